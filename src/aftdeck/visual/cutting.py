"""Cuts of convex polyhedra in a store: by a plane, and by another polyhedron."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.bodies.vector import Vector, cross, dot, minus
from aftdeck.law import law
from aftdeck.visual.store import CLUSTERS, CORNERS, FACES, MOST_CORNERS, POINTS, Store

ON = 1e-9
"""Distance up to which a vertex counts as in a plane [m]."""
BELOW, ABOVE, CROSSED = -1, 1, 0
"""Positions of a polyhedron relative to a plane: on the side against the normal, on the side of the normal, on both."""
FULL = -2
"""Result of a cut for which the store has no free space left."""


@law
def point_at(points: Array, i: int) -> Vector:
    """Return point `i` of (n, 3) points."""
    return Vector(points[i, 0], points[i, 1], points[i, 2])


@law
def position_of(store: Store, k: int, plane: Array) -> int:
    """Return the position of polyhedron `k` relative to a plane (4,): BELOW, ABOVE or CROSSED."""
    low, high = np.inf, -np.inf
    points = store.points
    for i in range(store.first_point[k], store.first_point[k + 1]):
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
    begin, end = store.first_point[k], store.first_point[k + 1]
    new, count = store.used[CLUSTERS], end - begin
    free_point, free_face, free_corner = store.used[POINTS], store.used[FACES], store.used[CORNERS]
    room = free_point + count + MOST_CORNERS <= len(store.points) and new < len(store.owner)
    faces = store.first_face[k + 1] - store.first_face[k]
    corners = store.first_corner[store.first_face[k + 1]] - store.first_corner[store.first_face[k]]
    if not (
        room
        and free_face + faces + 1 <= len(store.planes)
        and free_corner + corners + 2 * faces + MOST_CORNERS <= len(store.corners)
    ):
        return FULL
    heights, moved = np.empty(count), np.empty(count, np.int64)
    for i in range(count):
        p = point_at(store.points, begin + i)
        heights[i] = side * (plane[0] * p.x + plane[1] * p.y + plane[2] * p.z - plane[3])
        moved[i] = -1
        if heights[i] <= ON:
            store.points[free_point] = store.points[begin + i]
            moved[i] = free_point
            free_point += 1
    crossing = free_point
    crossed, crossings = np.empty((MOST_CORNERS, 2), np.int64), 0
    rim, rims = np.empty(2 * MOST_CORNERS, np.int64), 0
    for f in range(store.first_face[k], store.first_face[k + 1]):
        start, stop = store.first_corner[f], store.first_corner[f + 1]
        store.first_corner[free_face] = free_corner
        inside = False
        for c in range(start, stop):
            i = store.corners[c] - begin
            j = store.corners[c + 1 if c + 1 < stop else start] - begin
            if heights[i] <= ON:
                store.corners[free_corner] = moved[i]
                free_corner += 1
                inside = inside or heights[i] < -ON
            if (heights[i] < -ON and heights[j] > ON) or (heights[i] > ON and heights[j] < -ON):
                p, q = min(i, j), max(i, j)
                at = -1
                for e in range(crossings):
                    if crossed[e, 0] == p and crossed[e, 1] == q:
                        at = crossing + e
                if at < 0:
                    if crossings == MOST_CORNERS:
                        return FULL
                    at = free_point
                    part = heights[p] / (heights[p] - heights[q])
                    for axis in range(3):
                        a, b = store.points[begin + p, axis], store.points[begin + q, axis]
                        store.points[at, axis] = a + part * (b - a)
                    crossed[crossings, 0], crossed[crossings, 1] = p, q
                    crossings += 1
                    free_point += 1
                store.corners[free_corner] = at
                free_corner += 1
        if inside and free_corner - store.first_corner[free_face] > 2:
            store.planes[free_face] = store.planes[f]
            store.paint[free_face] = store.paint[f]
            free_face += 1
        else:
            free_corner = store.first_corner[free_face]
    # the new face's corners are all kept points in the plane, and all crossings
    for i in range(count):
        if moved[i] >= 0 and heights[i] >= -ON:
            rim[rims] = moved[i]
            rims += 1
    for e in range(crossings):
        rim[rims] = crossing + e
        rims += 1
    if rims > MOST_CORNERS:
        return FULL
    normal = Vector(side * plane[0], side * plane[1], side * plane[2])
    _sort_around(store.points, rim, rims, normal)
    store.first_corner[free_face] = free_corner
    for i in range(rims):
        store.corners[free_corner] = rim[i]
        free_corner += 1
    for axis in range(4):
        store.planes[free_face, axis] = side * plane[axis]
    store.paint[free_face] = -1
    free_face += 1
    store.first_corner[free_face] = free_corner
    store.first_point[new + 1], store.first_face[new + 1] = free_point, free_face
    store.owner[new] = store.owner[k]
    store.used[CLUSTERS], store.used[POINTS] = new + 1, free_point
    store.used[FACES], store.used[CORNERS] = free_face, free_corner
    return new


@law
def _sort_around(points: Array, rim: Indices, count: int, normal: Vector) -> None:
    """Sort points of a convex polygon so that they are counter-clockwise as seen against the normal.

    After the first point, the next corner is the one that has all others on its left.
    """
    for i in range(count - 2):
        for j in range(i + 2, count):
            origin = point_at(points, rim[i])
            a, b = minus(point_at(points, rim[i + 1]), origin), minus(point_at(points, rim[j]), origin)
            if dot(cross(a, b), normal) < 0.0:
                rim[i + 1], rim[j] = rim[j], rim[i + 1]


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
        position = position_of(store, rest, other.planes[f])
        if position == ABOVE:
            pieces[start] = k
            return start + 1
        if position == BELOW:
            continue
        if count == len(pieces):
            return FULL
        piece = part_of(store, rest, other.planes[f], -1.0)
        rest = part_of(store, rest, other.planes[f], 1.0)
        if piece == FULL or rest == FULL:
            return FULL
        pieces[count] = piece
        count += 1
    return count
