"""Operations on single polyhedra: difference and union of two, for the making of clusters."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import vec3
from aftdeck.frames import Pose
from aftdeck.matrices import product
from aftdeck.visual.cutting import BELOW, FULL, ON, part_of, position_of, subtract
from aftdeck.visual.planes import plane_of
from aftdeck.visual.store import Polyhedron, box, polyhedron, store_of, volume

_ROOM = 64
"""Number of polyhedra for which the working stores of these functions have room."""
_FEWEST_PLANES = 4
"""Least number of faces of a polyhedron."""
_EQUAL = 1e-9
"""Relative difference up to which two volumes count as equal."""


def apart(a: Polyhedron, b: Polyhedron) -> float:
    """Return the distance between two polyhedra along their best plane [m]; negative if they overlap."""
    return float(plane_of(store_of([a, b]), 0, 1, np.empty(4)))


def difference(a: Polyhedron, b: Polyhedron) -> list[Polyhedron]:
    """Return convex pieces of the part of `a` that is outside `b`; they touch, but do not overlap."""
    store, pieces = store_of([a, b], _ROOM), np.empty(_ROOM, np.int64)
    count = subtract(store, 0, store, 1, pieces, 0)
    if count == FULL:
        raise AssertionError("a polyhedron has too many faces to be cut")
    return [a if k == 0 else polyhedron(store, k) for k in pieces[:count].tolist()]


def union(a: Polyhedron, b: Polyhedron) -> Polyhedron | None:
    """Return the union of two polyhedra if it is convex; otherwise None.

    The planes of either polyhedron that do not cut the other one bound a convex body that contains both. If the volume
    of this body is the volume of the union, then it is the union.
    """
    planes = np.concatenate([_outside(a, b), _outside(b, a)])
    if len(planes) < _FEWEST_PLANES:
        return None
    points = np.concatenate([a.points, b.points])
    low, high = points.min(axis=0), points.max(axis=0)
    room = 0.1 * float((high - low).max())
    bound = _within(box(vec3(low - room, 0), vec3(high + room, 0)), planes)
    if bound is None:
        return None
    both = volume(b) + sum(map(volume, difference(a, b)))
    return bound if volume(bound) <= both * (1.0 + _EQUAL) else None


def _outside(a: Polyhedron, b: Polyhedron) -> Array:
    """Return the planes (n, 4) of `a` that have all of `b` on their inner side."""
    heights = a.planes[:, :3] @ b.points.T - a.planes[:, 3:]
    return np.asarray(a.planes[(heights <= ON).all(axis=1)])


def _within(bound: Polyhedron, planes: Array) -> Polyhedron | None:
    """Return the part of a polyhedron inside all planes (n, 4); None if the planes do not bound it on all sides."""
    store, k = store_of([bound], _ROOM), 0
    for plane in planes:
        if position_of(store.points, store.first_point[k], store.first_point[k + 1], plane) != BELOW:
            k = part_of(store, k, plane, 1.0)
            if k == FULL:
                return None
    return polyhedron(store, k)


def moved(body: Polyhedron, pose: Pose) -> Polyhedron:
    """Convert a polyhedron from its own frame to another one; `pose` is the pose of its frame in the other one."""
    points = product(body.points, pose.rotation.T) + pose.position
    normals = product(body.planes[:, :3], pose.rotation.T)
    distances = body.planes[:, 3] + normals @ pose.position
    return Polyhedron(points, np.column_stack([normals, distances]), body.loops)
