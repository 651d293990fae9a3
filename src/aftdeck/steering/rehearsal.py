"""Flying a motion ahead of time: the same steering on an arm that follows exactly, as fast as it computes."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from aftdeck.kinematics.linkage import sines
from aftdeck.kinematics.singular import distances
from aftdeck.law import law
from aftdeck.steering.course import set_off
from aftdeck.steering.layout import ANGLES, ARRIVED, CAUSE, CULPRIT, DT, GO, MEASURED, RATES, RATIO
from aftdeck.steering.msteer import msteer

Array = NDArray[np.float64]

STANDSTILL = 1e-3
"""RATIO [1] under which a motion counts as held at a standstill."""
GIVEN_UP = 2.0
"""How long [s] it may be held there before it is given up."""


class Rehearsal(NamedTuple):
    """How a rehearsed motion went.

    Attributes:
        arrived: whether it came to its end.
        time: when it ended or was given up [s].
        cause: what held it at a standstill: a number of `limiters.CAUSES`; 0 where nothing did.
        culprit: the joint or singularity concerned; -1 none.
        nearest: least distance from any singularity on the way [1].
        which: that singularity: 0 shoulder, 1 elbow, 2 wrist.
    """

    arrived: bool
    time: float
    cause: int
    culprit: int
    nearest: float
    which: int


@law
def rehearse(rules: Array, command: Array, state: Array, report: Array, most: float) -> Rehearsal:
    """Fly `command` from `state` for at most `most` seconds, its start included; the arrays are used up.

    Afterwards `state` holds where the arm has come to.
    """
    dt = rules[DT]
    nearest, which, held, step = 1.0, 0, 0, 0
    while step * dt < most:
        if command[GO] == 0.0:
            set_off(rules, command, state)
        msteer(rules, command, state, report)
        for i in range(6):
            state[ANGLES + i] += state[RATES + i] * dt
            state[MEASURED + i] = state[RATES + i]
        step += 1
        d = distances(
            rules,
            sines(
                rules,
                state[ANGLES],
                state[ANGLES + 1],
                state[ANGLES + 2],
                state[ANGLES + 3],
                state[ANGLES + 4],
                state[ANGLES + 5],
            ),
        )
        for k in range(3):
            if abs(d[k]) < nearest:
                nearest, which = abs(d[k]), k
        if report[ARRIVED] != 0.0:
            return Rehearsal(True, step * dt, 0, -1, nearest, which)
        held = held + 1 if report[RATIO] < STANDSTILL else 0
        if held * dt >= GIVEN_UP:
            return Rehearsal(False, step * dt, int(report[CAUSE]), int(report[CULPRIT]), nearest, which)
    return Rehearsal(False, step * dt, 0, -1, nearest, which)
