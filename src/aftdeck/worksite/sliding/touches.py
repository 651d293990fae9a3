"""Touches: points where the held payload touches, or may soon touch, the walls along which it may slide."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.hexahedron import SIDES, VERTICES, D, face_normal, vertex
from aftdeck.bodies.vector import dot, put_vector
from aftdeck.law import law
from aftdeck.worksite.sliding.projection import LEAST, OUTWARD, POINT, TOUCH
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor
from aftdeck.worksite.watch.found import CLEARANCE, NORMAL, POINT_A, POINT_B, WHICH

_EACH = VERTICES + 1
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
    """Write the touches of the groups that count, and return their number.

    The touches of a group are its closest point, and every vertex of the sliding part that is within reach of a face of
    the wall. When a whole side touches a wall, its corners are touches, so that no rotation moves a corner into the
    wall.

    Args:
        frame: (n,), pairs (m, 2), begins (g + 1,): of the layout.
        pairs: see frame.
        begins: see frame.
        counts: (g,) 1 for groups of a sliding part and a wall.
        slides: index of the frame that slides.
        placed: (n, 52) the solids in L.
        found: (g, 15) the last measurements.
        reach: clearance up to which a wall is considered [m].
        period: time in which a clearance may be closed [s].
        out: greatest speed at which a point inside a wall comes out [m/s].
        touches: (k, 7) output rows; there has to be space for nine of each pair.
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
    """Return the least speed out of a wall: a clearance may close in one period, a depth opens at most at `out`."""
    return min(-clearance / period, out)


@law
def _over(wall: Array, body: Array, v: int, reach: float, period: float, out: float, row: Array) -> int:
    """Write the touch of vertex v of a body and return 1 if a wall's face is within reach of it; else return 0."""
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


def touches(watch: ClearanceMonitor, counts: Mask, slides: str, reach: float, period: float, out: float) -> Array:
    """Return the touches (k, 7) of a frame that slides along walls, with rows as in `sliding.projection`.

    Args:
        watch: the monitor, updated for the present frames.
        counts: (g,) 1 for groups of a sliding part and a wall.
        slides: name of the frame that slides.
        reach: clearance up to which a wall is considered [m]: the greatest distance that anything moves in a step.
        period: duration of a step [s].
        out: greatest speed at which a point inside a wall comes out [m/s].
    """
    own = watch.layout
    found = np.empty((_EACH * len(own.pairs), TOUCH))
    count = touching(
        own.frame,
        own.pairs,
        own.begins,
        counts & watch.active,
        own.frames.index(slides),
        watch.placed,
        watch.found,
        reach,
        period,
        out,
        found,
    )
    return found[:count]
