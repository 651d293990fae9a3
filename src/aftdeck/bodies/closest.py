"""Closest points of two hexahedra.

The algorithm GJK finds the point of their Minkowski difference that is nearest to the origin.

Source: Gilbert, Johnson and Keerthi, "A fast procedure for computing the distance between complex objects in
three-dimensional space", 1988. All sub-simplices are enumerated. The search ends when the point's distance from
the origin agrees with the gap between the bodies along the direction from the origin to the point. The gap proves that
no other point is nearer.
"""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import vertex
from aftdeck.bodies.planes import lowest
from aftdeck.bodies.vector import ZERO, Vector, cross, dot, minus, moved_along, opposite, times
from aftdeck.law import law

AGREED = 1e-13
"""Greatest difference between distance and gap at which the search ends [m]."""
NOTHING = 1e-14
"""Greatest distance that counts as zero [m]. At such a distance, rounding errors make the direction from the origin
to the point meaningless."""
ENCLOSED = 4
"""Size of a simplex that contains the origin."""
MOST_STEPS = 64
"""Greatest number of search steps; no observed pair of bodies needed this number. The distance decreases with every
step."""


class Corner(NamedTuple):
    """Corner of the Minkowski difference of two bodies.

    Attributes:
        at: vertex a of the first body minus vertex b of the second body [m].
        a: number of the first body's vertex, from zero.
        b: number of the second body's vertex, from zero.
    """

    at: Vector
    a: int
    b: int


class Simplex(NamedTuple):
    """Simplex in the Minkowski difference.

    The simplex has `size` corners: p; p and q; or p, q and r. Its point nearest to the origin is `point` [m]. If `size`
    is ENCLOSED, the simplex is a tetrahedron that contains the origin; its fourth corner is not stored.
    """

    size: int
    p: Corner
    q: Corner
    r: Corner
    point: Vector


class Nearest(NamedTuple):
    """Result of a search.

    Attributes:
        simplex: the final simplex.
        distance: distance of the simplex's point from the origin [m].
        gap: gap between the bodies along the direction from the origin to that point [m].
    """

    simplex: Simplex
    distance: float
    gap: float


@law
def corner(a: Array, b: Array, i: int, j: int, moved: Vector) -> Corner:
    """Return vertex i of body `a`, moved by a vector [m], minus vertex j of body `b`."""
    p, q = vertex(a, i), vertex(b, j)
    return Corner(Vector(p.x - q.x + moved.x, p.y - q.y + moved.y, p.z - q.z + moved.z), i, j)


@law
def on_segment(p: Corner, q: Corner) -> Simplex:
    """Find the point of a segment that is nearest to the origin, and return the simplex in which this point lies."""
    e = minus(q.at, p.at)
    along = -dot(p.at, e)
    square = dot(e, e)
    if along <= 0.0:
        return Simplex(1, p, p, p, p.at)
    if along >= square:
        return Simplex(1, q, q, q, q.at)
    point = moved_along(p.at, along / square, e)
    # The component along the segment is only a rounding error: remove it. Near contact, the error is larger than the
    # component perpendicular to the segment.
    return Simplex(2, p, q, q, moved_along(point, -(dot(point, e) / square), e))


@law
def nearer(s: Simplex, t: Simplex) -> Simplex:
    """Return the simplex whose point is nearer to the origin; return s if both points are equally near."""
    if dot(s.point, s.point) <= dot(t.point, t.point):
        return s
    return t


@law
def on_triangle(p: Corner, q: Corner, r: Corner) -> Simplex:
    """Find the point of a triangle that is nearest to the origin, and return the simplex in which this point lies."""
    n = cross(minus(q.at, p.at), minus(r.at, p.at))
    pq, qr, rp = dot(n, cross(p.at, q.at)), dot(n, cross(q.at, r.at)), dot(n, cross(r.at, p.at))
    if pq > 0.0 and qr > 0.0 and rp > 0.0:
        return Simplex(3, p, q, r, times(dot(n, p.at) / dot(n, n), n))
    return nearer(nearer(on_segment(p, q), on_segment(q, r)), on_segment(r, p))


@law
def outside(p: Corner, q: Corner, r: Corner, s: Corner) -> bool:
    """Return whether the plane of p, q, r separates the origin from s, or contains the origin or s."""
    n = cross(minus(q.at, p.at), minus(r.at, p.at))
    origin = -dot(n, p.at)
    other = dot(n, minus(s.at, p.at))
    return origin * other <= 0.0


@law
def on_tetrahedron(p: Corner, q: Corner, r: Corner, s: Corner) -> Simplex:
    """Find the point of a tetrahedron that is nearest to the origin, and return the simplex in which this point lies.

    The face p, q, r is not tested: if the origin is not inside, the nearest point is on a face with the corner s.
    """
    best, found = Simplex(ENCLOSED, p, q, r, ZERO), False
    for _ in range(3):
        if outside(s, p, q, r):
            face = on_triangle(s, p, q)
            best, found = nearer(best, face) if found else face, True
        p, q, r = q, r, p
    return best


@law
def shortest(s: Simplex, w: Corner) -> Simplex:
    """Add a corner to a simplex, and find the point of the enlarged simplex that is nearest to the origin.

    Return the simplex in which this point lies.
    """
    if s.size == 1:
        return on_segment(s.p, w)
    if s.size == 2:
        return on_triangle(s.p, s.q, w)
    return on_tetrahedron(s.p, s.q, s.r, w)


@law
def spanned(size: int, p: Corner, q: Corner, r: Corner) -> Simplex:
    """Find the point that is nearest to the origin in a simplex with one to three corners.

    Return the simplex in which this point lies.
    """
    if size == 1:
        return Simplex(1, p, p, p, p.at)
    if size == 2:
        return on_segment(p, q)
    return on_triangle(p, q, r)


@law
def nearest(a: Array, b: Array, moved: Vector, start: Simplex, enough: float) -> Nearest:
    """Find the point of a Minkowski difference that is nearest to the origin.

    The difference is formed from body `a`, displaced by `moved`, and body `b`.

    Args:
        a: packed body.
        b: packed body.
        moved: displacement of the body `a` [m].
        start: simplex from which the search starts.
        enough: gap above which the search ends at once [m].
    """
    s, gap = start, -np.inf
    square = dot(s.point, s.point)
    distance = sqrt(square)
    for _ in range(MOST_STEPS):
        if s.size == ENCLOSED or distance <= NOTHING:
            break
        w = corner(a, b, lowest(a, s.point), lowest(b, opposite(s.point)), moved)
        gap = dot(s.point, w.at) / distance
        if distance - gap <= AGREED or gap > enough:
            break
        t = shortest(s, w)
        below = dot(t.point, t.point)
        if t.size < ENCLOSED and below >= square:
            break
        s, square = t, below
        distance = sqrt(square)
    return Nearest(s, distance, gap)


@law
def weights(s: Simplex) -> tuple[float, float, float]:
    """Return the weights for which the weighted sum of a simplex's corners is the simplex's point. Their sum is 1."""
    if s.size == 1:
        return 1.0, 0.0, 0.0
    e, h = minus(s.q.at, s.p.at), minus(s.point, s.p.at)
    if s.size == 2:
        t = dot(h, e) / dot(e, e)
        return 1.0 - t, t, 0.0
    f = minus(s.r.at, s.p.at)
    n = cross(e, f)
    per = 1.0 / dot(n, n)
    t, u = dot(n, cross(h, f)) * per, dot(n, cross(e, h)) * per
    return 1.0 - t - u, t, u
