"""Control steps of an automatic motion without inputs, for the rehearsal of CMD CK."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE
from aftdeck.kinematics.solver import nearest_singularity
from aftdeck.law import law
from aftdeck.lent import lend
from aftdeck.simulation.period.contact import bounded, measured, placed, still_clear
from aftdeck.simulation.period.period import ATTACHED, MOVED, moved, settled
from aftdeck.simulation.row.now import Arrays, lent, motion_of
from aftdeck.simulation.row.scalars import (
    ARM,
    CHANGED,
    FLOATS,
    FREELY,
    HELD,
    HINDERED,
    INHIBITED,
    MADE,
    PERIOD,
    SLIDES,
    STAND_VELOCITY,
    WITHIN,
)
from aftdeck.simulation.row.world import world_of
from aftdeck.steering.layout import ANGLE, ARRIVED, DISTANCE, MOTION_ACTIVE, RATIO, REMAINING
from aftdeck.steering.rehearsal import STANDSTILL

STEPS, SINCE, LATEST, NEAREST, WHICH, PASSES, PASSES_TURN, REACHED = range(8)
"""Indices of the values of a rehearsal: number of steps so far; time at which the motion to the present point began,
and by which it has to end [s]; least distance from a singularity so far [1], and its number; distance [m] and angle
[rad] from the target within which the motion goes on to the next point, or -1; how far the last step came."""
VALUES = 8
CLOSE = 1e-3
"""Clearance below which a pair is measured, if nothing floats and no payload slides along walls [m]."""


@law
def rehearsed(
    arrays: Arrays,
    rules: Array,
    resting: Array,
    links: Array,
    values: Array,
    most: int,
    half: float,
    slowest: float,
    day: float,
) -> None:
    """Rehearse control steps until one needs more than compiled code, may end the motion, or changes a contact.

    Args:
        arrays: as for `period.advance`.
        rules: the same.
        resting: the same.
        links: the same.
        values: of the rehearsal; changed.
        most: greatest number of steps.
        half: time from its beginning for which the duration of a motion is estimated [s].
        slowest: least share of the steering's speed that an estimate assumes [1].
        day: time at which every rehearsal ends [s].
    """
    flat = lent(arrays)
    world, now = world_of(flat), motion_of(flat)
    rules, resting, links, command, report = lend(rules), lend(resting), lend(links), now.command, now.report
    v, period = now.scalars, world.constants[PERIOD]
    always = len(world.bars) > 0 and v[HELD] < 0.0
    near = v[SLIDES] != 0.0
    for k in range(len(now.flights)):
        near = near or now.flights[k, FLOATS] != 0.0
    within = world.constants[WITHIN] if near else CLOSE
    bound, true = -np.inf, np.empty((0, POSE))
    values[REACHED], v[MADE] = ATTACHED, 0.0
    for _ in range(most):
        passes = report[DISTANCE] <= values[PASSES] and report[ANGLE] <= values[PASSES_TURN]
        if report[ARRIVED] != 0.0 or report[RATIO] < STANDSTILL or passes:
            return
        reached = moved(flat, rules, resting)
        if reached == MOVED:
            placed(flat, true)
            if always or not still_clear(flat, bound, within):
                measured(flat, within)
                bound = bounded(flat)
            else:
                v[CHANGED] = 0.0
            reached = settled(flat, False)
        values[REACHED] = reached
        values[STEPS] += 1.0
        v[MADE] += 1.0
        if reached < ATTACHED:
            return
        time = values[STEPS] * period
        near, which = nearest_singularity(links, now.angles)
        if near < values[NEAREST]:
            values[NEAREST], values[WHICH] = near, which
        if v[CHANGED] != 0.0 or v[ARM] != 0.0 or v[INHIBITED] != 0.0:
            return
        if v[STAND_VELOCITY] != 0.0 or v[HINDERED] != FREELY:
            return
        if command[MOTION_ACTIVE] != 0.0:
            estimate(report, values, time, half, slowest)
        if time >= min(values[LATEST], day):
            return


@law
def estimate(report: Array, values: Array, time: float, half: float, slowest: float) -> None:
    """Give the motion to the present point twice its estimated duration, if it is longer than estimated before.

    Args:
        report: report of the steering laws.
        values: of the rehearsal; changed.
        time: time since the rehearsal began [s].
        half: as for `rehearsed`.
        slowest: as for `rehearsed`.
    """
    since = values[SINCE]
    if time - since <= half:
        left = report[REMAINING] / max(report[RATIO], slowest)
        values[LATEST] = max(values[LATEST], since + 2.0 * (time - since + left))
