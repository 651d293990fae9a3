"""Check whether solids are inside the payload bay."""

from __future__ import annotations

from aftdeck.arrays import Array, Indices
from aftdeck.bodies.hexahedron import VERTICES, X, Y, Z
from aftdeck.bodies.pose import turned_back
from aftdeck.bodies.vector import Vector, minus, vector_at
from aftdeck.law import law


@law
def may_be_inside(centre: Vector, radius: float, frame: Array, low: Array, high: Array) -> bool:
    """Return whether a sphere reaches into a box.

    Args:
        centre: its centre in L [m].
        radius: its radius [m].
        frame: (12,) pose in L of the frame in which the box is given.
        low: (3,) the box's least coordinates in that frame [m].
        high: (3,) the box's greatest coordinates in that frame [m].
    """
    at = turned_back(frame, minus(centre, vector_at(frame, 0)))
    inside = low[0] < at.x + radius and at.x - radius < high[0]
    inside = inside and low[1] < at.y + radius and at.y - radius < high[1]
    return inside and bool(low[2] < at.z + radius and at.z - radius < high[2])


@law
def any_inside(placed: Array, which: Indices, frame: Array, low: Array, high: Array) -> bool:
    """Return whether a vertex of the selected solids is inside a box.

    Args:
        placed: (n, 52) solids in L.
        which: (k,) indices of the selected solids.
        frame: (12,) pose in L of the frame in which the box is given.
        low: (3,) the box's least coordinates in that frame [m].
        high: (3,) the box's greatest coordinates in that frame [m].
    """
    for i in which:
        for v in range(VERTICES):
            x, y, z = placed[i, X + v] - frame[0], placed[i, Y + v] - frame[1], placed[i, Z + v] - frame[2]
            inside = True
            for c in range(3):
                along = frame[3 + c] * x + frame[6 + c] * y + frame[9 + c] * z
                inside = inside and low[c] < along < high[c]
            if inside:
                return True
    return False
