"""Escape direction: stick direction that leads out of a singularity or away from a stop.

For each of the 12 directions of the six stick axes, these laws compute the joint rates after RMSRAT and RATLMT. From
these rates they compute the speed at which the arm leaves the singularity or the stop. If no stick direction leads
away, the escape direction is a motion of one joint in SINGLE.
"""

from __future__ import annotations

import math

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Rates
from aftdeck.kinematics.linkage import Sines, Tip, sines, tip
from aftdeck.kinematics.rates import rmsrat
from aftdeck.kinematics.singular import distances
from aftdeck.law import law
from aftdeck.steering.layout import STICKS
from aftdeck.steering.limiters import closing, ratlmt
from aftdeck.steering.modes import manual
from aftdeck.steering.msteer import NEAR_FLOOR, carried_to_tip
from aftdeck.steering.views import sines_of

DIRECTIONS = 12
"""Number of stick directions: + and - of roll, pitch, yaw, X, Y, Z, in that order."""
SEARCH_STEP = math.radians(0.5)
"""Step of the search along a joint's path out of a singularity [rad]."""


@law
def way_out(
    rules: Array, command: Array, state: Array, singularity: int, joint: int, inward: float, speeds: Array
) -> None:
    """Write into `speeds` the speed at which each stick direction leads away from a singularity or a limit.

    Args:
        rules: rules of a manual mode.
        command: command whose law is used; its sticks are overwritten.
        state: state of the arm.
        singularity: 0 shoulder, 1 elbow, 2 wrist; `speeds` are the rates at which the distance from this singularity
            grows [1/s]. If `singularity` is -1, `joint` and `inward` apply instead.
        joint: joint at its limit; `speeds` are its rates [rad/s].
        inward: sign, +1 or -1, of the joint's rate that leads away from its limit.
        speeds: (12,) output, one speed for each stick direction; positive if the direction leads away.
    """
    a = sines_of(rules, state)
    here = tip(rules, a)
    for k in range(DIRECTIONS):
        rates = _stick_rates(rules, command, a, here, k)
        ratio = ratlmt(rules, state, a, rates).ratio
        if singularity >= 0:
            speeds[k] = -ratio * closing(rules, a, rates, singularity)[1]
        else:
            speeds[k] = ratio * inward * rates[joint]


@law
def _stick_rates(rules: Array, command: Array, a: Sines, here: Tip, k: int) -> Rates:
    """Return the joint rates that stick direction k demands, before limits."""
    for i in range(6):
        command[STICKS + i] = 0.0
    command[STICKS + k // 2] = 1.0 if k % 2 == 0 else -1.0
    demanded = manual.demand(rules, command, here)
    return rmsrat(rules, a, carried_to_tip(rules, here, demanded), NEAR_FLOOR)


@law
def stick_rates(rules: Array, command: Array, state: Array, speeds: Array) -> None:
    """Write the joint rates of each stick direction, after limits, into `speeds` (12, 6) [rad/s].

    See `way_out` for the other arguments.
    """
    a = sines_of(rules, state)
    here = tip(rules, a)
    for k in range(DIRECTIONS):
        rates = _stick_rates(rules, command, a, here, k)
        ratio = ratlmt(rules, state, a, rates).ratio
        for i in range(6):
            speeds[k, i] = ratio * rates[i]


@law
def joint_out(arm: Array, angles: Array, reach: Array, singularity: int, threshold: float) -> tuple[int, int]:
    """Return the joint that moves the arm out of a singularity with the least rotation, and the sign of this rotation.

    The joint stays inside its reach limits.
    The joint's whole path to its reach limit is evaluated, because a path that leads away from the singularity at first
    may end before the arm has left the singularity.

    Args:
        arm: links, as `kinematics.linkage` packs them.
        angles: (6,) joint angles [rad].
        reach: (6, 2) reach limits [rad].
        singularity: 0 shoulder, 1 elbow, 2 wrist.
        threshold: normalised distance beyond which the arm has left the singularity [1].

    Returns:
        The joint, 0 to 5, and the sign of its rotation, +1 or -1. If no joint moves the arm out of the singularity, the
        joint is the first that changes the distance from the singularity, and the sign is -1.
    """
    first, last = (1, 3) if singularity == 0 else (2, 2) if singularity == 1 else (4, 4)
    best, direction, least = first, -1, math.inf
    for joint in range(first, last + 1):
        for sign in (-1, 1):
            room = reach[joint, 1] - angles[joint] if sign > 0 else angles[joint] - reach[joint, 0]
            turned = SEARCH_STEP
            while turned < min(room, least):
                if abs(_turned_distance(arm, angles, joint, sign * turned, singularity)) > threshold:
                    best, direction, least = joint, sign, turned
                turned += SEARCH_STEP
    return best, direction


@law
def _turned_distance(arm: Array, angles: Array, joint: int, by: float, singularity: int) -> float:
    """Return the signed distance from a singularity after a rotation of one joint by an angle [rad]."""
    d = distances(
        arm,
        sines(
            arm,
            angles[0],
            angles[1] + (by if joint == 1 else 0.0),
            angles[2] + (by if joint == 2 else 0.0),
            angles[3] + (by if joint == 3 else 0.0),
            angles[4] + (by if joint == 4 else 0.0),
            angles[5],
        ),
    )
    return d[singularity]
