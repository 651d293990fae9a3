"""The general solver for many poses at a time, and its search for one."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from aftdeck.arms.chain import COUNT, FOLLOW, HAND, SCALE
from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE
from aftdeck.kinematics.chain.answers import (
    MATRIX,
    NEAR,
    answer,
    follow_of,
    joints_of,
    packed_of,
    rates_of_twist,
    tip_at,
)
from aftdeck.kinematics.chain.search import Found, search
from aftdeck.kinematics.finite import finite
from aftdeck.kinematics.jacobian import Twist, of_array
from aftdeck.kinematics.linkage import put_tip
from aftdeck.law import law

FLOOR = 1e-7
"""Distance from a singularity below which a pose counts as singular [1]: rates are then over 1e7 times the usual."""


@law
def forward_many(arm: Array, angles: Array, position: Array, rotation: Array) -> bool:
    """Write the tip's poses in L, (m, 3) [m] and (m, 3, 3), for coordinates (m, n); return whether all are finite."""
    whole = True
    for i in range(angles.shape[0]):
        whole = whole and finite(angles[i])
        put_tip(tip_at(arm, of_array(angles[i])), position[i], rotation[i])
    return whole


@law
def jacobian_many(arm: Array, angles: Array, matrix: Array) -> bool:
    """Write the Jacobians (m, 6, n) in L for coordinates (m, n); return whether all are finite."""
    whole, count = True, int(packed_of(arm)[COUNT])
    for i in range(angles.shape[0]):
        whole = whole and finite(angles[i])
        found = answer(arm, of_array(angles[i]))
        for row in range(6):
            for column in range(count):
                matrix[i, row, column] = found[MATRIX + row * count + column]
    return whole


@law
def rates_many(arm: Array, angles: Array, twists: Array, rates: Array, singular: NDArray[np.bool_]) -> bool:
    """Write rates (m, n) for twists (m, 6) of the tip, and whether each pose is singular; return as `forward_many`."""
    whole = True
    for i in range(angles.shape[0]):
        t = twists[i]
        whole = whole and finite(angles[i]) and finite(t)
        found = answer(arm, of_array(angles[i]))
        singular[i] = found[NEAR] < FLOOR
        r = rates_of_twist(arm, found, Twist(t[0], t[1], t[2], t[3], t[4], t[5]), FLOOR)
        for k in range(angles.shape[1]):
            rates[i, k] = r[k]
    return whole


@law
def distances_many(arm: Array, angles: Array, result: Array) -> bool:
    """Write the distances (1, m) from a singularity for coordinates (m, n); return whether all are finite."""
    whole = True
    for i in range(angles.shape[0]):
        whole = whole and finite(angles[i])
        result[0, i] = answer(arm, of_array(angles[i]))[NEAR]
    return whole


@law
def search_from(arm: Array, goal: Array, limits: Array, q: Array) -> Found:
    """Search for a pose (12,) in L from coordinates `q` (n,), which are replaced by those found; see `search`."""
    packed = packed_of(arm)
    follow = follow_of(packed, packed[FOLLOW])
    return search(joints_of(packed), packed[HAND : HAND + POSE], goal, limits, packed[SCALE], follow, q)
