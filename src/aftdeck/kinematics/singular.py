"""Distances from the three singularities: the normalised denominators of the closed-form rate law.

Each distance is signed and is zero at its singularity; its magnitude is in [0, 1]. JSC-12628 names two of these
distances in RMANGS; the third is the denominator D of RMSRAT. The same formulas hold for both families of arms.
"""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.kinematics.finite import finite
from aftdeck.kinematics.linkage import L2, L3, L4, Floats, Sines, sines
from aftdeck.law import law

NAMES = ("shoulder", "elbow", "wrist")


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
def nearest_singularity(arm: Array, angles: Array) -> tuple[float, int]:
    """Return the least distance from a singularity [1], and that singularity: 0 shoulder, 1 elbow, 2 wrist."""
    d = distances(arm, sines(arm, angles[0], angles[1], angles[2], angles[3], angles[4], angles[5]))
    which = 0
    for k in range(1, 3):
        if abs(d[k]) < abs(d[which]):
            which = k
    return abs(d[which]), which


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
