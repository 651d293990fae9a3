"""Distances from the three singularities: the normalised denominators of the closed-form rate law.

Each distance is signed and is zero at its singularity; its magnitude is in [0, 1]. JSC-12628 names two of these
distances in RMANGS; the third is the denominator D of RMSRAT. The same formulas hold for both families of arms.
"""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.kinematics.finite import finite
from aftdeck.kinematics.jacobian import Rates
from aftdeck.kinematics.linkage import L2, L3, L4, Floats, Sines, sines
from aftdeck.law import law


class Singularities(NamedTuple):
    """Distances from the three singularities, each (...) in [-1, 1].

    Attributes:
        shoulder: distance of the fifth joint from the first joint's axis, divided by the greatest possible distance.
            The fifth joint is wrist yaw. In a heading-pitch-roll wrist, the fifth joint is wrist pitch; its location is
            the point in which the wrist's axes intersect.
        elbow: minus the sine of the elbow's geometric angle; positive if the elbow is bent as usual.
        wrist: cosine of the fifth joint's angle.
    """

    shoulder: Array
    elbow: Array
    wrist: Array


@law
def distances(arm: Floats, a: Sines) -> tuple[float, float, float]:
    """Return the normalised distances from the shoulder, elbow and wrist singularities [1]."""
    per_reach = 1.0 / (arm[L2] + arm[L3] + abs(arm[L4]))
    shoulder = (arm[L2] * a.c2 + arm[L3] * a.c23 + arm[L4] * a.cw) * per_reach
    return shoulder, a.s2 * a.c23 - a.c2 * a.s23, a.c5


@law
def closing(arm: Floats, a: Sines, rates: Rates, which: int) -> tuple[float, float]:
    """Return the signed distance from a singularity, and the rate at which the magnitude of the distance falls [1/s].

    `which` is 0 for the shoulder, 1 for the elbow, 2 for the wrist.
    """
    shoulder, elbow, wrist = distances(arm, a)
    upper, lower, hand = rates.r2, rates.r2 + rates.r3, rates.r2 + rates.r3 + rates.r4
    if which == 0:
        reach = arm[L2] + arm[L3] + abs(arm[L4])
        change = -(arm[L2] * a.s2 * upper + arm[L3] * a.s23 * lower + arm[L4] * a.sw * hand) / reach
        return shoulder, -change if shoulder >= 0.0 else change
    if which == 1:
        change = -(a.c2 * a.c23 + a.s2 * a.s23) * rates.r3
        return elbow, -change if elbow >= 0.0 else change
    change = -a.s5 * rates.r5
    return wrist, -change if wrist >= 0.0 else change


@law
def distances_many(arm: Array, angles: Array, result: Array) -> bool:
    """Compute the distances for each row of angles (n, 6) [rad], and write them into `result` (3, n).

    Returns:
        Whether all angles are finite.
    """
    whole = True
    for i in range(angles.shape[0]):
        q = angles[i]
        whole = whole and finite(q)
        d = distances(arm, sines(arm, q[0], q[1], q[2], q[3], q[4], q[5]))
        result[0, i], result[1, i], result[2, i] = d
    return whole
