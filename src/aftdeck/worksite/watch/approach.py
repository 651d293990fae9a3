"""Speed at which the closest points of a monitored pair approach each other, and the numbers of its record."""

from __future__ import annotations

from aftdeck.arrays import Array, Indices
from aftdeck.bodies.pair import CONTACT
from aftdeck.bodies.pose import vec3
from aftdeck.bodies.vector import dot, minus, vector_at
from aftdeck.law import law
from aftdeck.tuples import Vec3
from aftdeck.worksite.watch.found import (
    CLEARANCE,
    DISTANCE,
    FEATURE_A,
    FEATURE_B,
    NORMAL,
    POINT_A,
    POINT_B,
    WHICH,
)
from aftdeck.worksite.watch.motion import motion, velocity

Measures = tuple[bool, float, float, Vec3, Vec3, Vec3, float, int, int]
"""Whether the parts are in contact; clearance [m], speed of approach [m/s], closest points, normal and distance of the
plane, and the features of both parts (`watch.found`)."""


@law
def approach(found: Array, g: int, pairs: Indices, frame: Indices, before: Array, now: Array, period: float) -> float:
    """Return the speed at which the closest points of a group approach each other; negative if they separate [m/s].

    Args:
        found: (g, 14) measurements, rows as in `worksite.watch.found`.
        g: the group.
        pairs: (m, 2) as `Layout.pairs`.
        frame: (n,) as `Layout.frame`.
        before: (F, 12) poses of the frames one step before, in L.
        now: (F, 12) poses of the frames at the measurement, in L.
        period: time between `before` and `now` [s].
    """
    row = found[g]
    k = int(row[WHICH])
    a, b = frame[pairs[k, 0]], frame[pairs[k, 1]]
    va = velocity(now[a], motion(before[a], now[a], period), vector_at(row, POINT_A))
    vb = velocity(now[b], motion(before[b], now[b], period), vector_at(row, POINT_B))
    return dot(vector_at(row, NORMAL), minus(va, vb))


@law
def measures(
    found: Array, g: int, pairs: Indices, frame: Indices, before: Array, now: Array, period: float
) -> Measures:
    """Return the numbers of a group's record; the arguments are those of `approach`."""
    row, speed = found[g], approach(found, g, pairs, frame, before, now, period)
    return (
        row[CLEARANCE] <= CONTACT, row[CLEARANCE], speed, vec3(row, POINT_A), vec3(row, POINT_B), vec3(row, NORMAL),
        row[DISTANCE], int(row[FEATURE_A]), int(row[FEATURE_B]),
    )  # fmt: skip
