"""Rehearsal of a motion: the same steering laws on an arm whose joint rates are exactly the commanded ones.

The computation is faster than real time.
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.law import law
from aftdeck.steering.course import start_motion
from aftdeck.steering.layout import AIMS, ANGLES, ARRIVED, DT, JOINTS, MEASURED, MOTION_ACTIVE, RATES, RATIO
from aftdeck.steering.msteer import msteer

STANDSTILL = 1e-3
"""RATIO [1] below which a motion counts as stopped by a limit."""
MAX_STOPPED_TIME = 2.0
"""Time [s] after which the rehearsal of a stopped motion ends."""


@law
def rehearse(rules: Array, command: Array, state: Array, report: Array, most: float) -> bool:
    """Run an automatic command, including its start, for at most `most` seconds; return whether the motion has ended.

    The arrays are overwritten. Afterwards `state` holds the arm's last state.
    """
    dt = rules[DT]
    stopped, step = 0, 0
    while step * dt < most and stopped * dt < MAX_STOPPED_TIME:
        if command[MOTION_ACTIVE] == 0.0:
            start_motion(rules, command, state)
        msteer(rules, command, state, report)
        for i in range(int(rules[JOINTS])):
            state[ANGLES + i] += state[RATES + i] * dt
            state[AIMS + i], state[MEASURED + i] = state[ANGLES + i], state[RATES + i]
        step += 1
        if report[ARRIVED] != 0.0:
            return True
        stopped = stopped + 1 if report[RATIO] < STANDSTILL else 0
    return False
