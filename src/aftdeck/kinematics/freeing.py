"""Way out of a singularity by one joint: the joint that frees the arm, and the direction in which it turns."""

from __future__ import annotations

import math

from aftdeck.arms.geometry import GENERAL
from aftdeck.arrays import Array
from aftdeck.kinematics.chain.answers import SLOPES, answer, freeing_joint
from aftdeck.kinematics.jacobian import of_array
from aftdeck.kinematics.linkage import WRIST, sines
from aftdeck.kinematics.singular import distances
from aftdeck.law import law

SEARCH_STEP = math.radians(0.5)
"""Step of the search along a joint's path out of a singularity [rad]."""
LEVEL = 1e-6
"""Slope of the distance from a singularity below which it falls in neither direction [1/rad or 1/m]."""


@law
def joint_out(arm: Array, angles: Array, reach: Array, singularity: int, threshold: float) -> tuple[int, int]:
    """Return the joint that moves the arm out of a singularity, and the sign of its motion.

    With a closed form, it is the joint that gets there with the least rotation inside its reach limits. The joint's
    whole path to its reach limit is evaluated, because a path that leads away from the singularity at first may end
    before the arm has left the singularity. With the general solver, it is the joint whose motion changes the distance
    most.

    Args:
        arm: the arm's links.
        angles: (n,) joint angles [rad].
        reach: (n, 2) reach limits [rad].
        singularity: a singularity of the arm's solver.
        threshold: normalised distance beyond which the arm has left the singularity [1].

    Returns:
        The joint, from 0, and the sign of its rotation, +1 or -1. If no joint moves the arm out of the singularity, the
        joint is the first that changes the distance from the singularity, and the sign is -1.
    """
    if arm[WRIST] == GENERAL:
        return _freeing(arm, angles, reach)
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
def _freeing(arm: Array, angles: Array, reach: Array) -> tuple[int, int]:
    """Return the joint that changes the distance from a singularity most, and the sign with which the distance grows.

    At the singularity itself the distance grows in both directions; the joint then moves to its farther limit.
    """
    found = answer(arm, of_array(angles))
    joint = freeing_joint(arm, found)
    slope = found[SLOPES + joint]
    if abs(slope) < LEVEL:
        slope = reach[joint, 0] + reach[joint, 1] - 2.0 * angles[joint]
    return joint, 1 if slope > 0.0 else -1


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
