"""Coordinates of the joints for a pose of the tip, by a search from given ones.

Each step solves the linear equations for the rest of the way with damping, which grows while steps fail. Joints stay
within their limits. Source: Levenberg and Marquardt's method, as More describes it, "The Levenberg-Marquardt
algorithm", Numerical Analysis, Lecture Notes in Mathematics 630 (1978).
"""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

import numpy as np

from aftdeck.arms.chain import SLIDES
from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE
from aftdeck.kinematics.chain.posture import place_joints, write_jacobian
from aftdeck.kinematics.chain.rates import Weighted, part_along, weigh
from aftdeck.law import law
from aftdeck.quaternions import rotation_vector

STEPS = 200
"""Greatest number of steps of a search."""
LONGEST = 0.5
"""Greatest step of a joint [rad, or characteristic lengths]."""
ENOUGH = 1e-13
"""Miss at which a search ends [rad, or characteristic lengths]."""
FIRST, LEAST, MOST = 1e-3, 1e-12, 1e6
"""Damping of the first step, the least damping, and the damping at which no step helps; each times the miss."""
CHANGE = 8.0
"""Factor by which a step that fails increases the damping, and one that succeeds decreases it [1]."""
ROUNDING = 1e-15
"""Share of the miss by which a step has to decrease it, for the search to go on [1]."""


class Found(NamedTuple):
    """End of a search.

    Attributes:
        turn: angle between the tip's axes and those of the goal [rad].
        distance: distance of the tip from the goal [m].
        steps: number of steps.
    """

    turn: float
    distance: float
    steps: int


@law
def miss_of(tip: Array, goal: Array, miss: Array) -> None:
    """Write the displacement from the tip to the goal: rotation vector [rad], then translation [m], in L.

    Args:
        tip: (12,) pose of the tip.
        goal: (12,) pose to reach.
        miss: (6,) output.
    """
    turn = np.empty((3, 3))
    for i in range(3):  # the rotation from the tip's axes to the goal's
        for j in range(3):
            turn[i, j] = 0.0
            for k in range(3):
                turn[i, j] += goal[3 + 3 * i + k] * tip[3 + 3 * j + k]
    miss[0], miss[1], miss[2] = rotation_vector(
        turn[0, 0], turn[0, 1], turn[0, 2], turn[1, 0], turn[1, 1], turn[1, 2], turn[2, 0], turn[2, 1], turn[2, 2]
    )
    for i in range(3):
        miss[3 + i] = goal[i] - tip[i]


@law
def search(chain: Array, hand: Array, goal: Array, limits: Array, scale: float, follow: Array, q: Array) -> Found:
    """Move the joints to where the tip is at a pose, or as near to it as this search gets.

    Args:
        chain: (n, 16) the chain.
        hand: (12,) pose of the tip in the last joint's frame.
        goal: (12,) pose to reach, in L.
        limits: (n, 2) least and greatest coordinate of each joint [rad or m].
        scale: characteristic length of the chain [m].
        follow: (6,) weights of the miss's components [1/rad, then 1/m].
        q: (n,) coordinates at the start; those found are written into it.
    """
    count = chain.shape[0]
    joints, tip, matrix = np.empty((count, POSE)), np.empty(POSE), np.empty((6, count))
    miss, missed, trial, weights = np.empty(6), np.empty(6), np.empty(count), np.empty(count)
    for i in range(count):
        q[i] = min(max(q[i], limits[i, 0]), limits[i, 1])
    place_joints(chain, hand, q, joints, tip)
    miss_of(tip, goal, miss)
    before, damping, steps = _size(miss, follow), FIRST, 0
    while steps < STEPS and before > ENOUGH:
        steps += 1
        write_jacobian(chain, joints, tip, matrix)
        _weigh_joints(chain, scale, matrix, miss, follow, q, limits, weights)
        w = weigh(matrix, weights, follow)
        after = before
        while damping < MOST:
            _step(w, miss, damping * before, limits, q, trial)
            place_joints(chain, hand, trial, joints, tip)
            miss_of(tip, goal, missed)
            after = _size(missed, follow)
            if after < before:
                break
            damping *= CHANGE
        gained = before - after
        if gained <= 0.0:
            break
        for i in range(count):
            q[i] = trial[i]
        for i in range(6):
            miss[i] = missed[i]
        before, damping = after, max(damping / CHANGE, LEAST)
        if gained < ROUNDING * before:
            break
    return Found(
        sqrt(miss[0] * miss[0] + miss[1] * miss[1] + miss[2] * miss[2]),
        sqrt(miss[3] * miss[3] + miss[4] * miss[4] + miss[5] * miss[5]),
        steps,
    )


@law
def _size(miss: Array, follow: Array) -> float:
    """Return the weighted size of a miss."""
    square = 0.0
    for i in range(6):
        part = follow[i] * miss[i]
        square += part * part
    return sqrt(square)


@law
def _weigh_joints(
    chain: Array, scale: float, matrix: Array, miss: Array, follow: Array, q: Array, limits: Array, weights: Array
) -> None:
    """Write the joints' weights (n,): 0 for a joint that is at a limit and would have to pass it."""
    for j in range(q.shape[0]):
        unit, pull = scale if chain[j, SLIDES] != 0.0 else 1.0, 0.0
        for i in range(6):
            pull += matrix[i, j] * follow[i] * follow[i] * miss[i]
        blocked = (q[j] <= limits[j, 0] and pull < 0.0) or (q[j] >= limits[j, 1] and pull > 0.0)
        weights[j] = 0.0 if blocked else unit * unit


@law
def _step(w: Weighted, miss: Array, damping: float, limits: Array, q: Array, trial: Array) -> None:
    """Write the joints' coordinates after a damped step into `trial` (n,)."""
    count, most = q.shape[0], 0.0
    for j in range(count):
        trial[j] = 0.0
    for k in range(w.values.shape[0]):
        bottom = w.values[k] * w.values[k] + damping
        part = part_along(w, k, miss) * w.values[k] / bottom if bottom > 0.0 else 0.0
        for j in range(count):
            trial[j] += w.right[j, k] * part
    for j in range(count):
        most = max(most, abs(trial[j]))
    share = LONGEST / most if most > LONGEST else 1.0
    for j in range(count):
        trial[j] = min(max(q[j] + trial[j] * share * sqrt(w.weights[j]), limits[j, 0]), limits[j, 1])
