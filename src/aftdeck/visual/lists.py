"""Permanent priority lists: the order of fixed clusters for an eye at a fixed point.

Which of two clusters hides the other one depends on the eye's position only, not on pan, tilt or zoom. A list for a
camera that does not move is therefore made once. Two clusters are compared if any ray from the eye meets both, in
whatever direction.

Source: Remote Manipulator Simulation, final report, chapter V, Figure 15 and TABLE VII (made by hand for nine cameras).
"""

from __future__ import annotations

from math import sqrt

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.vector import Vector, cross, dot, minus, times
from aftdeck.law import law
from aftdeck.visual.cutting import point_at
from aftdeck.visual.planes import best_plane, extent, nearer_by
from aftdeck.visual.store import Store

_BESIDE = 1e-9
"""Distance by which a point may be on the wrong side of a plane that contains the eye, per distance from the eye."""


@law
def nearer(store: Store, i: int, j: int, eye: Vector) -> int:
    """Return 1 if polyhedron `i` can hide `j` from an eye, -1 if `j` can hide `i`, 0 if neither can."""
    best = best_plane(store, i, j)
    return nearer_by(extent(store.points, store.first_point, i, j, best.normal), dot(best.normal, eye))


@law
def behind_one_another(store: Store, i: int, j: int, eye: Vector) -> bool:
    """Return whether a ray from the eye meets the inside of both polyhedra.

    If none does, a plane through the eye and two vertices has the two polyhedra on different sides.
    """
    first_i, end_i = store.first_point[i], store.first_point[i + 1]
    first_j, end_j = store.first_point[j], store.first_point[j + 1]
    count = end_i - first_i + end_j - first_j
    rays = np.empty((count, 3))
    for k in range(count):
        at = first_i + k if k < end_i - first_i else first_j + k - (end_i - first_i)
        ray = minus(point_at(store.points, at), eye)
        ray = times(1.0 / sqrt(dot(ray, ray)), ray)
        rays[k, 0], rays[k, 1], rays[k, 2] = ray.x, ray.y, ray.z
    for p in range(count):
        for q in range(p):
            n = cross(point_at(rays, p), point_at(rays, q))
            size = dot(n, n)
            if size < _BESIDE * _BESIDE:
                continue
            n = times(1.0 / sqrt(size), n)
            if _divides(rays, end_i - first_i, n, 1.0) or _divides(rays, end_i - first_i, n, -1.0):
                return False
    return True


@law
def _divides(rays: Array, of_first: int, n: Vector, sign: float) -> bool:
    """Return whether a plane through the eye has the first rays on one side and the others on the other side."""
    for k in range(len(rays)):
        side = sign * (n.x * rays[k, 0] + n.y * rays[k, 1] + n.z * rays[k, 2])
        if (side if k < of_first else -side) > _BESIDE:
            return False
    return True


@law
def compare_all(store: Store, members: Indices, eye: Vector, hides: Mask) -> None:
    """Write into `hides` (n, n) a 1 in [a, b] if member `a` hides a part of member `b` from an eye; otherwise a 0."""
    hides[:] = 0
    for a in range(len(members)):
        for b in range(a):
            way = nearer(store, members[a], members[b], eye)
            if way != 0 and behind_one_another(store, members[a], members[b], eye):
                if way > 0:
                    hides[a, b] = 1
                else:
                    hides[b, a] = 1


def permanent_list(store: Store, members: Indices, eye: Array) -> tuple[int, ...] | None:
    """Return clusters in one frame, highest priority first, for an eye in any direction; None if there is a cycle.

    Of clusters that could come next, the one with the lowest number comes first.

    Args:
        store: the clusters, each in its own frame.
        members: numbers of clusters in one frame.
        eye: (3,) position of the eye in that frame [m].
    """
    hides = hidden(store, members, eye)
    over = hides.sum(axis=0, dtype=np.int64)  # how many members hide each one
    found: list[int] = []
    left = list(range(len(members)))
    while left:
        first = next((k for k in left if over[k] == 0), None)
        if first is None:
            return None
        left.remove(first)
        over -= hides[first]
        found.append(int(members[first]))
    return tuple(found)


def hidden(store: Store, members: Indices, eye: Array) -> Mask:
    """Return (n, n) a 1 in [a, b] if member `a` hides a part of member `b` from an eye (3,), in any direction."""
    found = np.empty((len(members), len(members)), np.uint8)
    _compare_from(store, members, float(eye[0]), float(eye[1]), float(eye[2]), found)
    return found


@law
def _compare_from(store: Store, members: Indices, x: float, y: float, z: float, hides: Mask) -> None:
    """Run `compare_all` for an eye at x, y, z."""
    compare_all(store, members, Vector(x, y, z), hides)
