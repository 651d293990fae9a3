"""Polygons of a picture, in the order in which they are painted: from the lowest priority to the highest."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.law import law
from aftdeck.visual.cutting import FEWEST_CORNERS, FULL
from aftdeck.visual.outlines import clipped
from aftdeck.visual.store import MOST_CORNERS, Store

MOST_POLYGONS = 4096
"""Greatest number of polygons in a picture."""


class Polygons(NamedTuple):
    """Convex polygons, in the order in which they are painted.

    Attributes:
        points: (P, 2) corners, from -1 at the left and upper edge of the picture to 1 at the right and lower edge.
        begins: (Q + 1,) first corner of each polygon.
        owner: (Q,) cluster of each polygon.
        face: (Q,) face of the clusters' store whose colour the polygon has.
        normal: (Q, 3) outward unit normal of each polygon, in the coordinates of the camera.
    """

    points: Array
    begins: Indices
    owner: Indices
    face: Indices
    normal: Array


@law
def gather(
    placed: Store,
    table: Indices,
    count: int,
    wide: float,
    high: float,
    points: Array,
    begins: Indices,
    owner: Indices,
    face: Indices,
    normal: Array,
) -> int:
    """Write the front faces of all polyhedra of a picture, cut off at its edges, into arrays as in `Polygons`.

    A face that a cut made is left out: another polyhedron of the same body lies on it.

    Args:
        placed: the polyhedra, in the coordinates of the camera.
        table: the priority output table, highest priority first.
        count: number of entries in the table.
        wide: tangent of half the horizontal field of view.
        high: tangent of half the vertical field of view.
        points: output.
        begins: output.
        owner: output.
        face: output.
        normal: output.

    Returns:
        Number of polygons; FULL if there are too many.
    """
    polygon, work = np.empty((MOST_CORNERS + 8, 3)), np.empty((MOST_CORNERS + 8, 3))
    written, at = 0, 0
    begins[0] = 0
    for n in range(count):
        k = table[count - 1 - n]
        for f in range(placed.first_face[k], placed.first_face[k + 1]):
            if placed.planes[f, 3] >= 0.0 or placed.paint[f] < 0:
                continue
            corners = clipped(placed, f, wide, high, polygon, work)
            if corners < FEWEST_CORNERS:
                continue
            if written == len(owner) or at + corners > len(points):
                return FULL
            for i in range(corners):
                points[at, 0] = polygon[i, 0] / (polygon[i, 2] * wide)
                points[at, 1] = polygon[i, 1] / (polygon[i, 2] * high)
                at += 1
            owner[written], face[written] = placed.owner[k], placed.paint[f]
            normal[written] = placed.planes[f, :3]
            written += 1
            begins[written] = at
    return written
