"""Separating planes of two convex polyhedra in a store.

Two convex bodies that do not overlap are separated by a plane that contains a face of one of them, or that is parallel
to an edge of each. All these planes are tried, and a plane counts only after a test of all vertices of both bodies.
Source: Remote Manipulator Simulation, final report, chapter V (dynamic planes); the list of planes is the one for
hexahedra in chapter IV, without the restriction to hexahedra.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.bodies.vector import Vector, cross, dot, minus, times
from aftdeck.law import law
from aftdeck.units import FOOT
from aftdeck.visual.store import Store

TOLERANCE = 1e-6 * FOOT
"""Overlap up to which two bodies count as separate [m]: 1e-6 ft, more than the rounding errors."""
_PARALLEL = 1e-12
"""Square of the sine below which two edges count as parallel."""


class Extent(NamedTuple):
    """Greatest coordinate of body a, and least coordinate of body b, along a normal [m]."""

    a: float
    b: float


@law
def extent(points: Array, first: Indices, a: int, b: int, n: Vector) -> Extent:
    """Return the extents of polyhedra `a` and `b` along a normal from `a` to `b`.

    `points` and `first` are a store's `points` and `first_point`. A law counts the references of each array that it is
    given, and the nine arrays of a store would take longer than the extents.
    """
    high, low = -np.inf, np.inf
    for i in range(first[a], first[a + 1]):
        height = n.x * points[i, 0] + n.y * points[i, 1] + n.z * points[i, 2]
        high = height if height > high else high
    for i in range(first[b], first[b + 1]):
        height = n.x * points[i, 0] + n.y * points[i, 1] + n.z * points[i, 2]
        low = height if height < low else low
    return Extent(high, low)


@law
def nearer_by(along: Extent, eye: float) -> int:
    """Return 1 if body a can hide body b, -1 if b can hide a, 0 if neither can, from a plane's two extents.

    Args:
        along: extents of the bodies along the normal from a to b.
        eye: coordinate of the eye along the normal [m].
    """
    if along.a > along.b:  # the two touch, and rounding makes them overlap
        return 1 if 0.5 * (along.a + along.b) >= eye else -1
    if eye >= along.b:
        return -1
    return 1 if eye <= along.a else 0


class Found(NamedTuple):
    """Best plane of two polyhedra.

    Attributes:
        normal: unit normal from the first to the second polyhedron.
        apart: distance between the polyhedra along the normal [m]; negative if they overlap.
    """

    normal: Vector
    apart: float


@law
def best_plane(store: Store, a: int, b: int) -> Found:
    """Return the plane along whose normal two polyhedra are farthest apart.

    If a face's plane separates the polyhedra, the edges are not tried.
    """
    points, first, planes, best = store.points, store.first_point, store.planes, Found(Vector(0.0, 0.0, 1.0), -np.inf)
    for f in range(store.first_face[a], store.first_face[a + 1]):
        n = Vector(planes[f, 0], planes[f, 1], planes[f, 2])
        along = extent(points, first, a, b, n)
        if along.b - along.a > best.apart:
            best = Found(n, along.b - along.a)
    for f in range(store.first_face[b], store.first_face[b + 1]):
        n = Vector(-planes[f, 0], -planes[f, 1], -planes[f, 2])
        along = extent(points, first, a, b, n)
        if along.b - along.a > best.apart:
            best = Found(n, along.b - along.a)
    if best.apart >= -TOLERANCE:
        return best
    return _by_edges(store, a, b, best)


@law
def _by_edges(store: Store, a: int, b: int, best: Found) -> Found:
    """Return the best plane that is parallel to an edge of each polyhedron, or `best` if none is better."""
    points, first = store.points, store.first_point
    middle_a, middle_b = _middle(points, first, a), _middle(points, first, b)
    between = minus(middle_b, middle_a)
    edges, others = _edges(store, a), _edges(store, b)
    for c in range(len(edges)):
        e = Vector(edges[c, 0], edges[c, 1], edges[c, 2])
        for d in range(len(others)):
            g = Vector(others[d, 0], others[d, 1], others[d, 2])
            n = cross(e, g)
            square = dot(n, n)
            if square <= _PARALLEL * dot(e, e) * dot(g, g):
                continue
            n = times((1.0 if dot(n, between) > 0.0 else -1.0) / np.sqrt(square), n)
            along = extent(points, first, a, b, n)
            if along.b - along.a > best.apart:
                best = Found(n, along.b - along.a)
    return best


@law
def _edges(store: Store, k: int) -> Array:
    """Return the edges (n, 3) of polyhedron `k`, each as the vector from one of its ends to the other [m]."""
    points, corners, first_corner = store.points, store.corners, store.first_corner
    begin, end = store.first_face[k], store.first_face[k + 1]
    found, count = np.empty((first_corner[end] - first_corner[begin], 3)), 0
    for f in range(begin, end):
        for c in range(first_corner[f], first_corner[f + 1]):
            i, j = corners[c], corners[c + 1 if c + 1 < first_corner[f + 1] else first_corner[f]]
            if i > j:  # each edge belongs to two faces, which pass it in opposite directions
                continue
            for axis in range(3):
                found[count, axis] = points[j, axis] - points[i, axis]
            count += 1
    return found[:count]


@law
def _middle(points: Array, first: Indices, k: int) -> Vector:
    x, y, z, count = 0.0, 0.0, 0.0, first[k + 1] - first[k]
    for i in range(first[k], first[k + 1]):
        x, y, z = x + points[i, 0], y + points[i, 1], z + points[i, 2]
    return Vector(x / count, y / count, z / count)


@law
def plane_of(store: Store, a: int, b: int, found: Array) -> float:
    """Write the best plane (4,) of two polyhedra, halfway between them; return the distance between them [m]."""
    best = best_plane(store, a, b)
    along = extent(store.points, store.first_point, a, b, best.normal)
    found[0], found[1], found[2] = best.normal.x, best.normal.y, best.normal.z
    found[3] = 0.5 * (along.a + along.b)
    return best.apart
