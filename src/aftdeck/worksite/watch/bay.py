"""Check whether solids are inside the payload bay."""

from __future__ import annotations

from aftdeck.arrays import Array, Indices
from aftdeck.bodies.hexahedron import VERTICES, X, Y, Z
from aftdeck.law import law


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
