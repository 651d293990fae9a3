"""Polygons of a picture, in the order in which they are painted: from the lowest priority to the highest."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.law import law
from aftdeck.visual.cutting import FEWEST_CORNERS, FULL
from aftdeck.visual.marks import MOST_MARK_CORNERS, Marks
from aftdeck.visual.outlines import clipped, in_picture, within_planes
from aftdeck.visual.store import MOST_CORNERS, Store

MOST_POLYGONS = 8192
"""Greatest number of polygons in a picture."""


class Polygons(NamedTuple):
    """Convex polygons, in the order in which they are painted.

    Attributes:
        points: (P, 2) corners, from -1 at the left and upper edge of the picture to 1 at the right and lower edge.
        begins: (Q + 1,) first corner of each polygon.
        owner: (Q,) cluster of each polygon.
        face: (Q,) face of the clusters' store whose colour the polygon has; F + m for mark number m, where F is the
            number of these faces.
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
    marks: Marks,
    frame: Indices,
    poses: Array,
    points: Array,
    begins: Indices,
    owner: Indices,
    face: Indices,
    normal: Array,
) -> int:
    """Write the front faces of all polyhedra of a picture, cut off at its edges, into arrays as in `Polygons`.

    The marks of a face follow it directly. A face that a cut made is left out: another polyhedron of the same body lies
    on it.

    Args:
        placed: the polyhedra, in the coordinates of the camera.
        table: the priority output table, highest priority first.
        count: number of entries in the table.
        wide: tangent of half the horizontal field of view.
        high: tangent of half the vertical field of view.
        marks: the marks of the clusters' faces.
        frame: (N,) frame of each cluster.
        poses: (F, 12) poses of the frames in the coordinates of the camera.
        points: output.
        begins: output.
        owner: output.
        face: output.
        normal: output.

    Returns:
        Number of polygons; FULL if there are too many.
    """
    size = MOST_MARK_CORNERS + 2 * MOST_CORNERS
    polygon, work = np.empty((size, 3)), np.empty((size, 3))
    planes, paints, corner, begin = placed.planes, placed.paint, placed.corners, placed.first_corner
    faces = len(marks.first) - 1
    written, at = 0, 0
    begins[0] = 0
    for n in range(count):
        k = table[count - 1 - n]
        own = placed.owner[k]
        pose = poses[frame[own]]
        first_face, end_face = placed.first_face[k], placed.first_face[k + 1]
        for f in range(first_face, end_face):
            paint = paints[f]
            if planes[f, 3] >= 0.0 or paint < 0:
                continue
            first = marks.first[paint]
            for m in range(first - 1, marks.first[paint + 1]):
                if m < first:  # the face itself
                    corners = clipped(placed.points, corner, begin[f], begin[f + 1], wide, high, polygon, work)
                else:
                    corners = 0
                    for i in range(marks.begins[m], marks.begins[m + 1]):
                        x, y, z = marks.points[i, 0], marks.points[i, 1], marks.points[i, 2]
                        for r in range(3):
                            polygon[corners, r] = (
                                pose[r] + pose[3 + 3 * r] * x + pose[4 + 3 * r] * y + pose[5 + 3 * r] * z
                            )
                        corners += 1
                    corners = within_planes(planes, first_face, end_face, f, polygon, corners, work)
                    corners = in_picture(polygon, corners, wide, high, work)
                if corners < FEWEST_CORNERS:
                    if m < first:
                        break
                    continue
                if written == len(owner) or at + corners > len(points):
                    return FULL
                for i in range(corners):
                    points[at, 0] = polygon[i, 0] / (polygon[i, 2] * wide)
                    points[at, 1] = polygon[i, 1] / (polygon[i, 2] * high)
                    at += 1
                owner[written], face[written] = own, paint if m < first else faces + m
                normal[written, 0], normal[written, 1], normal[written, 2] = planes[f, 0], planes[f, 1], planes[f, 2]
                written += 1
                begins[written] = at
    return written
