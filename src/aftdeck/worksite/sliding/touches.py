"""Touches: points at which the held payload is, or may soon be, in contact with a wall along which it may slide."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.hexahedron import SIDES, VERTICES, D, face_normal, vertex
from aftdeck.bodies.vector import dot, put_vector
from aftdeck.law import law
from aftdeck.worksite.sliding.projection import LEAST, OUTWARD, POINT
from aftdeck.worksite.watch.found import CLEARANCE, NORMAL, POINT_A, POINT_B, WHICH

EACH = VERTICES + 1
"""Greatest number of touches of a pair of solids."""


@law
def touching(
    frame: Indices,
    pairs: Indices,
    begins: Indices,
    counts: Mask,
    slides: int,
    placed: Array,
    found: Array,
    reach: float,
    period: float,
    out: float,
    touches: Array,
) -> int:
    """Find all touches of a sliding part with its walls, write their rows into `touches`, and return their number.

    The sliding part and one of its walls form a group. The touches of the group are the point of the sliding part that
    is closest to the wall, and every vertex of the sliding part that is within reach of a face of the wall. When a
    whole side touches a wall, each corner of the side is a touch. No rotation can therefore move a corner into the
    wall.

    Args:
        frame: (n,) as `Layout.frame`.
        pairs: (m, 2) as `Layout.pairs`.
        begins: (g + 1,) as `Layout.begins`.
        counts: (g,) 1 for groups that consist of a sliding part and a wall.
        slides: index of the frame of the sliding part.
        placed: (n, 52) the solids in L.
        found: (g, 14) the last measurements.
        reach: clearance up to which a wall is considered [m].
        period: time in which a clearance may be closed [s].
        out: greatest speed at which a point inside a wall comes out [m/s].
        touches: (k, 7) output rows; nine rows are needed for each pair of solids.
    """
    count = 0
    for g in range(len(counts)):
        if counts[g] == 0 or not found[g, CLEARANCE] <= reach:
            continue
        first = frame[pairs[int(found[g, WHICH]), 0]] == slides
        row = touches[count]
        row[POINT : POINT + 3] = found[g, POINT_A : POINT_A + 3] if first else found[g, POINT_B : POINT_B + 3]
        row[OUTWARD : OUTWARD + 3] = (-1.0 if first else 1.0) * found[g, NORMAL : NORMAL + 3]
        row[LEAST] = _least(found[g, CLEARANCE], period, out)
        count += 1
        for k in range(begins[g], begins[g + 1]):
            body, wall = (pairs[k, 0], pairs[k, 1]) if first else (pairs[k, 1], pairs[k, 0])
            for v in range(VERTICES):
                count += _over(placed[wall], placed[body], v, reach, period, out, touches[count])
    return count


@law
def _least(clearance: float, period: float, out: float) -> float:
    """Return the least speed of a point along the wall's normal [m/s].

    A point at a positive clearance may reach the wall within one period. A point inside the wall has to come out within
    one period, but at most at the speed `out`.
    """
    return min(-clearance / period, out)


@law
def _over(wall: Array, body: Array, v: int, reach: float, period: float, out: float, row: Array) -> int:
    """If vertex v of a body is within reach of a wall, write its touch and return 1; else return 0."""
    p = vertex(body, v)
    face, height = 0, -np.inf
    for f in range(SIDES):
        above = dot(face_normal(wall, f), p) - wall[D + f]
        if above > height:
            face, height = f, above
    if height > reach:
        return 0
    put_vector(row, POINT, p)
    put_vector(row, OUTWARD, face_normal(wall, face))
    row[LEAST] = _least(height, period, out)
    return 1
