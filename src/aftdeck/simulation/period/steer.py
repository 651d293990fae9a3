"""Steering in a control period: the plan of a motion that begins, MSTEER, and what stops the arm."""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.law import large_law, law
from aftdeck.simulation.row.now import Flat, motion_of, watch_of
from aftdeck.simulation.row.scalars import (
    AUTOMATIC,
    BEGAN,
    FIXED,
    HALT,
    HEIGHT,
    HELD,
    IN_PROGRESS,
    INHIBITED,
    KEEPS_CLOCK,
    LOCKED,
    PERIOD,
    SLIDES,
    STAND,
    TELESCOPE,
    TELESCOPE_RATE,
)
from aftdeck.simulation.row.world import world_of
from aftdeck.steering.course import start_motion
from aftdeck.steering.layout import CLOCK, CLOCK_RATE, MOTION_ACTIVE, RATES, RATIO, TWIST
from aftdeck.steering.msteer import measured, msteer
from aftdeck.worksite.sliding.walls import met


@large_law
def steered(flat: Flat, rules: Array, resting: Array) -> bool:
    """Command the joint rates, and stop the arm if a berth or a switch does so.

    Args:
        flat: constants of the run and row of the state.
        rules: the steering's rules of the present mode, rate and law.
        resting: rules that replace `rules` while no automatic motion is in progress.

    Returns:
        Whether nothing else limits the motion. False if contacts or walls may limit it.
    """
    world, now, watch = world_of(flat), motion_of(flat), watch_of(flat)
    v, command, steering, report = now.scalars, now.command, now.steering, now.report
    measured(now.angles, now.rates, now.angles, v[STAND] - v[HEIGHT], steering)
    v[BEGAN] = 0.0
    if v[IN_PROGRESS] != 0.0 and command[MOTION_ACTIVE] == 0.0:
        start_motion(rules, command, steering)
        v[BEGAN] = command[MOTION_ACTIVE]
    msteer(resting if command[MOTION_ACTIVE] == 0.0 else rules, command, steering, report)
    held, slides = int(v[HELD]), v[SLIDES] != 0.0
    for g in range(len(watch.essential)):
        watch.essential[g] = watch.permitted[g] | world.slides[held, g] if slides else watch.permitted[g]
    moved = v[TELESCOPE] != 0.0
    for i in range(len(now.angles)):
        moved = moved or steering[RATES + i] != 0.0
    v[HALT] = 0.0
    if v[FIXED] != 0.0 or v[LOCKED] != 0.0:
        if moved:
            v[HALT] = 1.0 if v[FIXED] != 0.0 else 2.0
        v[TELESCOPE] = 0.0
        backwards = v[AUTOMATIC] != 0.0 and world.constants[KEEPS_CLOCK] == 0.0
        stop_arm(len(now.angles), steering, report, world.constants[PERIOD] if backwards else 0.0)
        return True
    if not moved:
        v[TELESCOPE] = 0.0
        return True
    if slides:
        speed = abs(v[TELESCOPE]) * world.constants[TELESCOPE_RATE]
        if met(watch.found, watch.near, world.slides[held], steering, speed, world.constants[PERIOD]) != 0.0:
            return False
    return bool(v[INHIBITED] == 0.0)


@law
def stop_arm(joints: int, steering: Array, report: Array, back: float) -> None:
    """Stop the arm; the steering of the next step starts from rest.

    Args:
        joints: number of joints.
        steering: state of the steering laws.
        report: their report.
        back: 0, or in modes 1 and 3 the control period [s]: their clock is set back by `CLOCK_RATE` periods, which is
            about its advance in this step.
    """
    for i in range(joints):
        steering[RATES + i] = 0.0
    for i in range(6):
        steering[TWIST + i] = 0.0
    report[RATIO] = 0.0
    if back != 0.0:
        steering[CLOCK] -= steering[CLOCK_RATE] * back
        steering[CLOCK_RATE] = 0.0
