"""All solutions of RMANGS for a pose: checked, in the requested revolutions and limits, and sorted."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.elementary import ceiling, nearest, sincos
from aftdeck.errors import InputError
from aftdeck.kinematics.finite import finite, not_finite
from aftdeck.kinematics.inverse import BRANCHES, rmangs
from aftdeck.law import law

ROTATION_TOLERANCE = 1e-6
"""Greatest allowed deviation of the pose's rotation from an orthonormal matrix [1]."""
SAME = 1e-9
"""Tolerance of an angle at its limits, and greatest difference of the angles of two solutions that count as
equal [rad]."""
EPSILON = 1e-9
"""Distance [m] or cosine [1] below which a pose counts as singular."""
FOUND, NOT_FINITE, SKEW, MIRRORED, SHOULDER, WRIST, OUT_OF_REACH, OUTSIDE = range(8)
"""Outcomes of `solve`; each outcome except `FOUND` is a reason why there is no solution."""


MIRRORED_TEXT = "the rotation is a mirror image: its determinant is -1, +1 is allowed"
"""Sentence about the outcome `MIRRORED`."""


def skew_text(off: float) -> str:
    """Return the sentence about the outcome `SKEW`; `off`: deviation of R R^T from the unit matrix [1]."""
    return f"the rotation is not orthonormal: R R^T is off by {off:.3g}, {ROTATION_TOLERANCE:g} is allowed"


class Solved(NamedTuple):
    """Result of `solve`.

    Attributes:
        outcome: `FOUND`, or the reason why there is no solution.
        number: number of solutions.
        value: a measure that depends on the outcome; 0 for outcomes that are not listed here. SKEW: deviation of R R^T
            from the unit matrix [1]. SHOULDER: distance of the fifth joint from the first joint's axis [m]. WRIST:
            cosine of the fifth angle [1]. OUT_OF_REACH: distance by which the wrist is out of reach [m]: positive
            beyond the reach of the stretched arm, negative inside the reach of the folded arm. OUTSIDE: angle by which
            `joint` is beyond its limit [rad].
        joint: for OUTSIDE, the joint beyond its limit, 0 to 5; -1 for any other outcome.
        angle: for OUTSIDE, the angle of that joint [rad]; 0 for any other outcome.
    """

    outcome: int
    number: int
    value: float
    joint: int
    angle: float


@law
def solve(arm: Array, hard: Array, pose: Array, near: Array, turned: bool, limited: bool, solutions: Array) -> Solved:
    """Find all joint angles that put the tip at a pose.

    Args:
        arm: packed arm, as in `kinematics.linkage`.
        hard: (6, 2) hard stops [rad].
        pose: (12,) tip position in L [m], then the rotation row by row.
        near: (6,) angles [rad]; the solutions are sorted by their distance from `near`, nearest first.
        turned: True to move each angle to the revolution nearest to `near`; False to keep each angle within +-pi.
        limited: True to move angles by whole revolutions inside the hard stops where this is possible, and to leave out
            solutions outside the hard stops.
        solutions: (8, 6) output [rad]; the first `number` rows are filled.
    """
    outcome, value = examine(pose, near)
    if outcome != FOUND:
        return Solved(outcome, 0, value, -1, 0.0)
    branches, excess = np.empty((BRANCHES, 6)), np.empty(BRANCHES)
    off_axis, cosine = rmangs(arm, pose, branches, excess)
    if off_axis < EPSILON:
        return Solved(SHOULDER, 0, off_axis, -1, 0.0)
    if cosine < EPSILON:
        return Solved(WRIST, 0, cosine, -1, 0.0)
    count, short = 0, excess[0]
    least_excess, nearest_row, culprit, greatest = np.inf, -1, -1, 0.0
    kept, kept_distances = np.empty((BRANCHES, 6)), np.empty(BRANCHES)
    smallest = np.inf
    for row in range(BRANCHES):
        if abs(excess[row]) < abs(short):
            short = excess[row]
        if excess[row] != 0.0:
            continue
        _choose_revolutions(branches[row], hard, near, turned, limited)
        excess_of_row, joint = _greatest_excess(branches[row], hard)
        if excess_of_row < least_excess:
            least_excess, nearest_row, culprit = excess_of_row, row, joint
        if limited and excess_of_row > SAME:
            continue
        smallest = min(smallest, abs(sincos(branches[row, 4])[1]))
        distance = 0.0
        for k in range(6):
            away = branches[row, k] - near[k]
            distance += away * away
        # insertion sort: rows at equal distances keep their order
        slot = count
        while slot > 0 and kept_distances[slot - 1] > distance:
            kept_distances[slot] = kept_distances[slot - 1]
            kept[slot] = kept[slot - 1]
            slot -= 1
        kept_distances[slot] = distance
        kept[slot] = branches[row]
        count += 1
    if nearest_row < 0:
        return Solved(OUT_OF_REACH, 0, short, -1, 0.0)
    if count == 0:
        greatest = branches[nearest_row, culprit]
        return Solved(OUTSIDE, 0, least_excess, culprit, greatest)
    if smallest < EPSILON:
        return Solved(WRIST, 0, smallest, -1, 0.0)
    return Solved(FOUND, _distinct(kept, count, solutions), 0.0, -1, 0.0)


@law
def examine(pose: Array, near: Array) -> tuple[int, float]:
    """Return the outcome if a pose (12,) is no pose or a number is not finite, with its measure; else FOUND and 0."""
    if not finite(pose) or not finite(near):
        return NOT_FINITE, 0.0
    skew = _skew(pose)
    if skew > ROTATION_TOLERANCE:
        return SKEW, skew
    return (MIRRORED if _determinant(pose) < 0.0 else FOUND), 0.0


def pose_error(outcome: int, value: float, pose: Array, near: Array) -> InputError:
    """Return the error for an outcome of `examine`.

    The texts of these errors appear in CMD CK and in the log. Recordings therefore change if a text changes.
    """
    if outcome == SKEW:
        return InputError(skew_text(value))
    if outcome == MIRRORED:
        return InputError(MIRRORED_TEXT)
    given = {"a position": pose[:3], "a rotation": pose[3:].reshape(3, 3), "near": near}
    return next(not_finite(name, values) for name, values in given.items() if not np.isfinite(values).all())


@law
def _skew(pose: Array) -> float:
    """Return the greatest deviation of R R^T from the unit matrix [1]."""
    worst = 0.0
    for i in range(3):
        for j in range(i + 1):
            dot = -1.0 if i == j else 0.0
            for k in range(3):
                dot += pose[3 + 3 * i + k] * pose[3 + 3 * j + k]
            worst = max(worst, abs(dot))
    return worst


@law
def _determinant(p: Array) -> float:
    """Return the determinant of the rotation."""
    found: float = p[3] * (p[7] * p[11] - p[8] * p[10])
    found -= p[4] * (p[6] * p[11] - p[8] * p[9])
    found += p[5] * (p[6] * p[10] - p[7] * p[9])
    return found


@law
def _choose_revolutions(angles: Array, hard: Array, near: Array, turned: bool, limited: bool) -> None:
    """Move each of six angles by whole revolutions.

    If `turned`, move each angle to the revolution nearest to `near`. Then, if `limited`, move each angle inside its
    limits. If no revolution is inside the limits, use the revolution nearest to the limits.
    """
    for k in range(6):
        angle = angles[k]
        if turned:
            angle = angle + math.tau * nearest((near[k] - angle) / math.tau)
        if limited:
            low, high = hard[k, 0], hard[k, 1]
            angle = angle - math.tau * max(ceiling((angle - high - SAME) / math.tau), 0.0)
            angle = angle + math.tau * max(ceiling((low - SAME - angle) / math.tau), 0.0)
            # if no revolution is inside, use the nearer one: the first above the limits, or the first below them
            below = angle - math.tau
            if angle > high + SAME and low - below < angle - high:
                angle = below
        angles[k] = angle


@law
def _greatest_excess(angles: Array, hard: Array) -> tuple[float, int]:
    """Return the greatest excess of a joint beyond its limits [rad], and that joint, 0 to 5.

    The excess is negative if all joints are inside their limits.
    """
    worst, joint = -np.inf, -1
    for k in range(6):
        beyond = max(hard[k, 0] - angles[k], angles[k] - hard[k, 1])
        if beyond > worst:
            worst, joint = beyond, k
    return worst, joint


@law
def _distinct(rows: Array, count: int, solutions: Array) -> int:
    """Copy the rows to `solutions`, without repetitions, and return the number of copied rows.

    Rows repeat if the arm is stretched out: the two elbow branches are then equal.
    """
    kept = 0
    for row in range(count):
        new = True
        for other in range(kept):
            apart = 0.0
            for k in range(6):
                apart = max(apart, abs(rows[row, k] - solutions[other, k]))
            new = new and apart > SAME
        if new:
            solutions[kept] = rows[row]
            kept += 1
    return kept
