"""Steering in a control period: the plan of a motion that begins, MSTEER, and what limits the motion."""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.law import large_law, law
from aftdeck.lent import lend
from aftdeck.simulation.period.limit import limited
from aftdeck.simulation.row.now import Arrays, Flat, lent, motion_of
from aftdeck.simulation.row.scalars import BEGAN, HEIGHT, IN_PROGRESS, STAND
from aftdeck.steering.course import start_motion
from aftdeck.steering.layout import MOTION_ACTIVE
from aftdeck.steering.msteer import measured, msteer


@law
def steer(arrays: Arrays, rules: Array, resting: Array) -> None:
    """Steer as `steered` does, after Python code has measured the arm: on a plant with masses."""
    commanded(lent(arrays), lend(rules), lend(resting))


@law
def steered(flat: Flat, rules: Array, resting: Array) -> None:
    """Measure the arm, command the joint rates, and limit them to what contacts, berths, switches and walls allow.

    Args:
        flat: constants of the run and row of the state.
        rules: the steering's rules of the present mode, rate and law.
        resting: rules that replace `rules` while no automatic motion is in progress.
    """
    now = motion_of(flat)
    v = now.scalars
    measured(now.angles, now.rates, now.angles, v[STAND] - v[HEIGHT], now.steering)
    commanded(flat, rules, resting)


@large_law
def commanded(flat: Flat, rules: Array, resting: Array) -> None:
    """Steer from what is measured; the arguments are those of `steered`."""
    now = motion_of(flat)
    v, command, steering, report = now.scalars, now.command, now.steering, now.report
    v[BEGAN] = 0.0
    if v[IN_PROGRESS] != 0.0 and command[MOTION_ACTIVE] == 0.0:
        start_motion(rules, command, steering)
        v[BEGAN] = command[MOTION_ACTIVE]
    msteer(resting if command[MOTION_ACTIVE] == 0.0 else rules, command, steering, report)
    limited(flat, resting if command[MOTION_ACTIVE] == 0.0 else rules)
