"""Penetration depth of two hexahedra: the length of the shortest move that separates the two.

The separation along a direction is the gap between the two bodies in that direction; it is negative if they overlap.
The depth is minus the greatest separation. Only two kinds of directions have to be examined. The first kind: the
normals of the faces of both bodies. The second kind: the directions perpendicular to an edge of one body and to an edge
of the other body, for pairs of edges whose arcs of normals cross (Gauss map; S. Gottschalk's theorem of separating
axes).
"""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import BESIDE, ENDS, SIDES, face_normal, vertex
from aftdeck.bodies.planes import sides
from aftdeck.bodies.vector import Vector, cross, dot, minus, opposite, times
from aftdeck.law import law

PARALLEL = 1e-24
"""Squared sine of the greatest angle at which two edges count as parallel [1]. For such edges, the normals of the faces
are sufficient."""


class Separation(NamedTuple):
    """Separation of two bodies along a unit normal.

    Attributes:
        apart: the separation [m]; negative if the bodies overlap along the normal.
        normal: the unit normal, from body a to body b [1].
    """

    apart: float
    normal: Vector


@law
def along(a: Array, b: Array, normal: Vector) -> Separation:
    """Return the separation along a unit normal, computed from all vertices of both bodies."""
    found = sides(a, b, normal)
    return Separation(found.b - found.a, normal)


@law
def by_faces(a: Array, b: Array) -> Separation:
    """Return the greatest separation along the face normals of both bodies."""
    best = along(a, b, face_normal(a, 0))
    for f in range(1, SIDES):
        found = along(a, b, face_normal(a, f))
        best = found if found.apart > best.apart else best
    for f in range(SIDES):
        found = along(a, b, opposite(face_normal(b, f)))
        best = found if found.apart > best.apart else best
    return best


@law
def greatest(a: Array, b: Array, above_b: Array, above_a: Array) -> Separation:
    """Return the greatest separation of packed bodies a and b.

    Args:
        a: packed body.
        b: packed body.
        above_b: (6, 8) heights of a's vertices over b's faces [m].
        above_a: (6, 8) heights of b's vertices over a's faces [m].
    """
    best = by_faces(a, b)
    for e in range(len(ENDS)):
        i, j = ENDS[e, 0], ENDS[e, 1]
        a1, a2 = BESIDE[e, 0], BESIDE[e, 1]
        edge_a = minus(vertex(a, j), vertex(a, i))
        for g in range(len(ENDS)):
            k, m = ENDS[g, 0], ENDS[g, 1]
            b1, b2 = BESIDE[g, 0], BESIDE[g, 1]
            # p1, p2: dot products of b's edge with the normals of the two faces at a's edge
            # q1, q2: dot products of a's edge with the normals of the two faces at b's edge
            p1, p2 = above_a[a1, m] - above_a[a1, k], above_a[a2, m] - above_a[a2, k]
            q1, q2 = above_b[b1, j] - above_b[b1, i], above_b[b2, j] - above_b[b2, i]
            if p1 * p2 >= 0.0 or q1 * q2 >= 0.0 or p1 * q1 <= 0.0:
                continue
            edge_b = minus(vertex(b, m), vertex(b, k))
            normal = cross(edge_a, edge_b)
            square = dot(normal, normal)
            if square <= PARALLEL * dot(edge_a, edge_a) * dot(edge_b, edge_b):
                continue
            unit = times((1.0 if p1 > 0.0 else -1.0) / sqrt(square), normal)
            if dot(unit, minus(vertex(b, k), vertex(a, i))) > best.apart:
                found = along(a, b, unit)
                best = found if found.apart > best.apart else best
    return best
