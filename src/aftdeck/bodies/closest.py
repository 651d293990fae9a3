"""Closest points of two hexahedra: the point of their Minkowski difference nearest to the origin, by GJK.

Source: Gilbert, Johnson and Keerthi, "A fast procedure for computing the distance between complex objects in
three-dimensional space", 1988. The sub-simplices are enumerated exactly. The search ends when the distance reached
agrees with the gap of the plane perpendicular to it, so each answer carries its own proof.
"""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import X, Y, Z
from aftdeck.bodies.planes import lowest
from aftdeck.law import law

AGREED = 1e-13
"""Largest difference of distance and gap at which the search ends [m]."""
NOTHING = 1e-14
"""Distance at or below which a direction is lost in rounding [m]."""
ENCLOSED = 4
"""Size of a simplex that contains the origin."""
MOST_STEPS = 64
"""Largest number of search steps, more than any observed pair needs: the distance falls with every step."""


class Corner(NamedTuple):
    """Corner of the Minkowski difference: a vertex of a minus a vertex of b [m], and both numbers, from zero."""

    x: float
    y: float
    z: float
    a: int
    b: int


class Simplex(NamedTuple):
    """Corners (the first `size`) that span the point nearest to the origin, and that point [m].

    A size of ENCLOSED means a tetrahedron that contains the origin.
    """

    size: int
    p: Corner
    q: Corner
    r: Corner
    x: float
    y: float
    z: float


class Nearest(NamedTuple):
    """Final simplex of a search, its point's distance from the origin, and the gap along that direction [m]."""

    simplex: Simplex
    distance: float
    gap: float


@law
def corner(a: Array, b: Array, i: int, j: int, x: float, y: float, z: float) -> Corner:
    """Return vertex i of a, moved by (x, y, z) [m], minus vertex j of b."""
    return Corner(a[X + i] - b[X + j] + x, a[Y + i] - b[Y + j] + y, a[Z + i] - b[Z + j] + z, i, j)


@law
def on_segment(p: Corner, q: Corner) -> Simplex:
    """Return the simplex of the point of a segment that is nearest to the origin."""
    ex, ey, ez = q.x - p.x, q.y - p.y, q.z - p.z
    along = -(p.x * ex + p.y * ey + p.z * ez)
    square = ex * ex + ey * ey + ez * ez
    if along <= 0.0:
        return Simplex(1, p, p, p, p.x, p.y, p.z)
    if along >= square:
        return Simplex(1, q, q, q, q.x, q.y, q.z)
    t = along / square
    x, y, z = p.x + t * ex, p.y + t * ey, p.z + t * ez
    # Remove the component that rounding left along the segment: near contact it is the larger component.
    t = (x * ex + y * ey + z * ez) / square
    return Simplex(2, p, q, q, x - t * ex, y - t * ey, z - t * ez)


@law
def nearer(s: Simplex, t: Simplex) -> Simplex:
    """Return the simplex whose point is nearer to the origin; s if both are equally near."""
    if s.x * s.x + s.y * s.y + s.z * s.z <= t.x * t.x + t.y * t.y + t.z * t.z:
        return s
    return t


@law
def on_triangle(p: Corner, q: Corner, r: Corner) -> Simplex:
    """Return the simplex of the point of a triangle that is nearest to the origin."""
    ex, ey, ez = q.x - p.x, q.y - p.y, q.z - p.z
    fx, fy, fz = r.x - p.x, r.y - p.y, r.z - p.z
    nx, ny, nz = ey * fz - ez * fy, ez * fx - ex * fz, ex * fy - ey * fx
    pq = nx * (p.y * q.z - p.z * q.y) + ny * (p.z * q.x - p.x * q.z) + nz * (p.x * q.y - p.y * q.x)
    qr = nx * (q.y * r.z - q.z * r.y) + ny * (q.z * r.x - q.x * r.z) + nz * (q.x * r.y - q.y * r.x)
    rp = nx * (r.y * p.z - r.z * p.y) + ny * (r.z * p.x - r.x * p.z) + nz * (r.x * p.y - r.y * p.x)
    if pq > 0.0 and qr > 0.0 and rp > 0.0:
        h = (nx * p.x + ny * p.y + nz * p.z) / (nx * nx + ny * ny + nz * nz)
        return Simplex(3, p, q, r, h * nx, h * ny, h * nz)
    return nearer(nearer(on_segment(p, q), on_segment(q, r)), on_segment(r, p))


@law
def outside(p: Corner, q: Corner, r: Corner, s: Corner) -> bool:
    """Return whether the origin is not strictly on the same side of the plane of p, q, r as s."""
    ex, ey, ez = q.x - p.x, q.y - p.y, q.z - p.z
    fx, fy, fz = r.x - p.x, r.y - p.y, r.z - p.z
    nx, ny, nz = ey * fz - ez * fy, ez * fx - ex * fz, ex * fy - ey * fx
    origin = -(nx * p.x + ny * p.y + nz * p.z)
    other = nx * (s.x - p.x) + ny * (s.y - p.y) + nz * (s.z - p.z)
    return origin * other <= 0.0


@law
def on_tetrahedron(p: Corner, q: Corner, r: Corner, s: Corner) -> Simplex:
    """Return the simplex of the point of a tetrahedron that is nearest to the origin.

    The face p, q, r is not tested: the nearest point is on a face with corner s, unless the origin is inside.
    """
    best, found = Simplex(ENCLOSED, p, q, r, 0.0, 0.0, 0.0), False
    for _ in range(3):
        if outside(s, p, q, r):
            face = on_triangle(s, p, q)
            best, found = nearer(best, face) if found else face, True
        p, q, r = q, r, p
    return best


@law
def shortest(s: Simplex, w: Corner) -> Simplex:
    """Return the simplex of the point nearest to the origin, for a simplex and one more corner."""
    if s.size == 1:
        return on_segment(s.p, w)
    if s.size == 2:
        return on_triangle(s.p, s.q, w)
    return on_tetrahedron(s.p, s.q, s.r, w)


@law
def spanned(size: int, p: Corner, q: Corner, r: Corner) -> Simplex:
    """Return the simplex of the point nearest to the origin, for one to three corners."""
    if size == 1:
        return Simplex(1, p, p, p, p.x, p.y, p.z)
    if size == 2:
        return on_segment(p, q)
    return on_triangle(p, q, r)


@law
def nearest(a: Array, b: Array, x: float, y: float, z: float, start: Simplex, enough: float) -> Nearest:
    """Search the Minkowski difference of a, moved by (x, y, z), and b for its point nearest to the origin.

    Args:
        a: packed body.
        b: packed body.
        x: a's displacement, with y and z [m].
        y: see x.
        z: see x.
        start: simplex from which the search starts.
        enough: gap above which the search ends at once [m].
    """
    s, gap = start, -np.inf
    square = s.x * s.x + s.y * s.y + s.z * s.z
    distance = sqrt(square)
    for _ in range(MOST_STEPS):
        if s.size == ENCLOSED or distance <= NOTHING:
            break
        w = corner(a, b, lowest(a, s.x, s.y, s.z), lowest(b, -s.x, -s.y, -s.z), x, y, z)
        gap = (s.x * w.x + s.y * w.y + s.z * w.z) / distance
        if distance - gap <= AGREED or gap > enough:
            break
        t = shortest(s, w)
        below = t.x * t.x + t.y * t.y + t.z * t.z
        if t.size < ENCLOSED and below >= square:
            break
        s, square = t, below
        distance = sqrt(square)
    return Nearest(s, distance, gap)


@law
def weights(s: Simplex) -> tuple[float, float, float]:
    """Return the weights of a simplex's corners in its point; they add up to 1."""
    p, q, r = s.p, s.q, s.r
    if s.size == 1:
        return 1.0, 0.0, 0.0
    ex, ey, ez = q.x - p.x, q.y - p.y, q.z - p.z
    if s.size == 2:
        t = ((s.x - p.x) * ex + (s.y - p.y) * ey + (s.z - p.z) * ez) / (ex * ex + ey * ey + ez * ez)
        return 1.0 - t, t, 0.0
    fx, fy, fz = r.x - p.x, r.y - p.y, r.z - p.z
    hx, hy, hz = s.x - p.x, s.y - p.y, s.z - p.z
    nx, ny, nz = ey * fz - ez * fy, ez * fx - ex * fz, ex * fy - ey * fx
    per = 1.0 / (nx * nx + ny * ny + nz * nz)
    t = (nx * (hy * fz - hz * fy) + ny * (hz * fx - hx * fz) + nz * (hx * fy - hy * fx)) * per
    u = (nx * (ey * hz - ez * hy) + ny * (ez * hx - ex * hz) + nz * (ex * hy - ey * hx)) * per
    return 1.0 - t - u, t, u
