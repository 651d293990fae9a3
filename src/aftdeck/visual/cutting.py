"""Cuts of convex polyhedra in a store: by a plane, and by another polyhedron."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.bodies.vector import Vector, cross, dot
from aftdeck.law import law
from aftdeck.visual.store import CLUSTERS, CORNERS, FACES, MOST_CORNERS, POINTS, Store

ON = 1e-9
"""Distance up to which a vertex counts as in a plane [m]."""
BELOW, ABOVE, CROSSED = -1, 1, 0
"""Positions of a polyhedron relative to a plane: on the side against the normal, on the side of the normal, on both."""
FEWEST_CORNERS = 3
"""Least number of corners of a face."""
FULL = -2
"""Result of a cut for which the store has no free space left."""


@law
def point_at(points: Array, i: int) -> Vector:
    """Return point `i` of (n, 3) points."""
    return Vector(points[i, 0], points[i, 1], points[i, 2])


@law
def position_of(points: Array, begin: int, end: int, plane: Array) -> int:
    """Return the position of a polyhedron relative to a plane (4,): BELOW, ABOVE or CROSSED.

    Its vertices are the points from index `begin` to `end`.
    """
    low, high = np.inf, -np.inf
    for i in range(begin, end):
        height = plane[0] * points[i, 0] + plane[1] * points[i, 1] + plane[2] * points[i, 2] - plane[3]
        low, high = min(low, height), max(high, height)
    if high <= ON:
        return BELOW
    return ABOVE if low >= -ON else CROSSED


@law
def part_of(store: Store, k: int, plane: Array, side: float) -> int:
    """Append the part of polyhedron `k` on one side of a plane that crosses it; return the index of the part.

    Args:
        store: the polyhedra; updated.
        k: the polyhedron.
        plane: (4,) unit normal and distance [m].
        side: 1.0 for the side against the normal, -1.0 for the side of the normal.

    Returns:
        Index of the part; FULL if there is no free space.
    """
    begin, end, new, points = store.first_point[k], store.first_point[k + 1], store.used[CLUSTERS], store.points
    if not _has_room(store, k):
        return FULL
    heights, moved = np.empty(end - begin), np.empty(end - begin, np.int64)
    free = store.used[POINTS]
    for i in range(end - begin):
        x, y, z = points[begin + i, 0], points[begin + i, 1], points[begin + i, 2]
        heights[i] = side * (plane[0] * x + plane[1] * y + plane[2] * z - plane[3])
        moved[i] = -1
        if heights[i] <= ON:
            points[free, 0], points[free, 1], points[free, 2] = x, y, z
            moved[i] = free
            free += 1
    end_point = _cut_faces(store, k, heights, moved, free)
    if end_point == FULL:
        return FULL
    if not _close(store, plane, side, heights, moved, free, end_point):
        return FULL
    store.first_point[new + 1], store.first_face[new + 1] = end_point, store.used[FACES]
    store.owner[new] = store.owner[k]
    store.used[CLUSTERS], store.used[POINTS] = new + 1, end_point
    return int(new)


@law
def _has_room(store: Store, k: int) -> bool:
    """Return whether there is free space for a part of polyhedron `k`."""
    points = store.first_point[k + 1] - store.first_point[k] + MOST_CORNERS
    faces = store.first_face[k + 1] - store.first_face[k] + 1
    corners = store.first_corner[store.first_face[k + 1]] - store.first_corner[store.first_face[k]]
    return bool(
        store.used[CLUSTERS] < len(store.owner)
        and store.used[POINTS] + points <= len(store.points)
        and store.used[FACES] + faces <= len(store.planes)
        and store.used[CORNERS] + corners + 2 * faces + MOST_CORNERS <= len(store.corners)
    )


@law
def _cut_faces(store: Store, k: int, heights: Array, moved: Indices, free: int) -> int:
    """Append what a plane leaves of the faces of polyhedron `k`.

    Args:
        store: the polyhedra; updated: points, planes, corners, paint and the numbers of faces and corners.
        k: the polyhedron.
        heights: (n,) height of each vertex over the plane, towards the side that is removed [m].
        moved: (n,) index of each kept vertex in the part; -1 for a vertex that is removed.
        free: index of the first free point; the points in which the plane cuts edges follow from there.

    Returns:
        Index of the first free point; FULL if the plane cuts more than MOST_CORNERS edges.
    """
    begin, crossed, crossings = store.first_point[k], np.empty((MOST_CORNERS, 2), np.int64), 0
    points, planes, corners, first_corner = store.points, store.planes, store.corners, store.first_corner
    face, corner = store.used[FACES], store.used[CORNERS]
    for f in range(store.first_face[k], store.first_face[k + 1]):
        start, stop = first_corner[f], first_corner[f + 1]
        first_corner[face] = corner
        inside = False
        for c in range(start, stop):
            i = corners[c] - begin
            j = corners[c + 1 if c + 1 < stop else start] - begin
            if heights[i] <= ON:
                corners[corner] = moved[i]
                corner += 1
                inside = inside or heights[i] < -ON
            if min(heights[i], heights[j]) < -ON and max(heights[i], heights[j]) > ON:
                p, q = min(i, j), max(i, j)
                at = 0  # the number of the edge p-q, if it is already cut
                while at < crossings and (crossed[at, 0] != p or crossed[at, 1] != q):
                    at += 1
                if at == crossings:
                    if crossings == MOST_CORNERS:
                        return FULL
                    part = heights[p] / (heights[p] - heights[q])
                    for axis in range(3):
                        low, high = points[begin + p, axis], points[begin + q, axis]
                        points[free + at, axis] = low + part * (high - low)
                    crossed[at, 0], crossed[at, 1] = p, q
                    crossings += 1
                corners[corner] = free + at
                corner += 1
        if inside and corner - first_corner[face] >= FEWEST_CORNERS:
            for axis in range(4):
                planes[face, axis] = planes[f, axis]
            store.paint[face] = store.paint[f]
            face += 1
        else:
            corner = first_corner[face]
    store.used[FACES], store.used[CORNERS] = face, corner
    return free + crossings


@law
def _close(store: Store, plane: Array, side: float, heights: Array, moved: Indices, first: int, end_point: int) -> bool:
    """Append the face that a plane makes; return False if it has too many corners.

    Its corners are all kept vertices in the plane, and the points from `first` on, in which the plane cuts edges.
    """
    rim, count = np.empty(len(moved) + MOST_CORNERS, np.int64), 0
    for i in range(len(moved)):
        if moved[i] >= 0 and heights[i] >= -ON:
            rim[count] = moved[i]
            count += 1
    for at in range(first, end_point):
        rim[count] = at
        count += 1
    if count > MOST_CORNERS:
        return False
    _sort_around(store.points, rim, count, Vector(side * plane[0], side * plane[1], side * plane[2]))
    face, corner = store.used[FACES], store.used[CORNERS]
    store.first_corner[face] = corner
    for i in range(count):
        store.corners[corner + i] = rim[i]
    for axis in range(4):
        store.planes[face, axis] = side * plane[axis]
    store.paint[face] = -1
    store.first_corner[face + 1] = corner + count
    store.used[FACES], store.used[CORNERS] = face + 1, corner + count
    return True


@law
def _sort_around(points: Array, rim: Indices, count: int, normal: Vector) -> None:
    """Sort points of a convex polygon so that they are counter-clockwise as seen against the normal.

    After the first point, the next corner is the one that has all others on its left.
    """
    for i in range(count - 2):
        for j in range(i + 2, count):
            o, p, q = rim[i], rim[i + 1], rim[j]
            a = Vector(points[p, 0] - points[o, 0], points[p, 1] - points[o, 1], points[p, 2] - points[o, 2])
            b = Vector(points[q, 0] - points[o, 0], points[q, 1] - points[o, 1], points[q, 2] - points[o, 2])
            if dot(cross(a, b), normal) < 0.0:
                rim[i + 1], rim[j] = q, p


@law
def subtract(store: Store, k: int, other: Store, m: int, pieces: Indices, count: int) -> int:
    """Append the pieces of polyhedron `k` outside polyhedron `m` of another store.

    The faces of `m` cut `k`, one after the other; what is outside a face is a piece.

    Args:
        store: the polyhedra; updated.
        k: the polyhedron to cut.
        other: store of the polyhedron `m`; it can be the same store.
        m: the polyhedron that cuts.
        pieces: output: the indices of the pieces, from index `count` on. It is `k` itself if `m` does not overlap `k`.
        count: number of pieces that `pieces` already contains.

    Returns:
        Number of pieces that `pieces` contains; FULL if there is no free space.
    """
    start, rest = count, k
    for f in range(other.first_face[m], other.first_face[m + 1]):
        position = position_of(store.points, store.first_point[rest], store.first_point[rest + 1], other.planes[f])
        if position == ABOVE:
            if start == len(pieces):
                return FULL
            pieces[start] = k
            return start + 1
        if position == BELOW:
            continue
        if count == len(pieces):
            return FULL
        piece = part_of(store, rest, other.planes[f], -1.0)
        rest = part_of(store, rest, other.planes[f], 1.0)
        if FULL in (piece, rest):
            return FULL
        pieces[count] = piece
        count += 1
    return count
