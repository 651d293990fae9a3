"""Dynamic separating planes. A plane counts as valid only after a test of all vertices of both bodies.

The laws index the coordinates of a packed body directly: 0 to 7 are x, 8 to 15 are y, 16 to 23 are z. They process
vertices in pairs, so that a processor can compute the dot products of a pair in parallel.
"""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.bodies.vector import Vector, opposite
from aftdeck.law import law


class Sides(NamedTuple):
    """Greatest coordinate of body a, and least coordinate of body b, along a normal [m].

    If the first is less than the second, a plane with this normal separates the bodies.
    """

    a: float
    b: float


@law
def lesser(p: float, q: float) -> float:
    """Return the lesser of two numbers."""
    return q if q < p else p


@law
def least(body: Array, v: Vector) -> float:
    """Return the least dot product of a packed body's vertices with a vector."""
    x, y, z = v.x, v.y, v.z
    p = lesser(x * body[0] + y * body[8] + z * body[16], x * body[4] + y * body[12] + z * body[20])
    q = lesser(x * body[1] + y * body[9] + z * body[17], x * body[5] + y * body[13] + z * body[21])
    r = lesser(x * body[2] + y * body[10] + z * body[18], x * body[6] + y * body[14] + z * body[22])
    s = lesser(x * body[3] + y * body[11] + z * body[19], x * body[7] + y * body[15] + z * body[23])
    return lesser(lesser(p, q), lesser(r, s))


@law
def lowest(body: Array, v: Vector) -> int:
    """Return the number, from zero, of the packed body's vertex whose dot product with a vector is least."""
    x, y, z = v.x, v.y, v.z
    p0 = x * body[0] + y * body[8] + z * body[16]
    p1 = x * body[1] + y * body[9] + z * body[17]
    p2 = x * body[2] + y * body[10] + z * body[18]
    p3 = x * body[3] + y * body[11] + z * body[19]
    p4 = x * body[4] + y * body[12] + z * body[20]
    p5 = x * body[5] + y * body[13] + z * body[21]
    p6 = x * body[6] + y * body[14] + z * body[22]
    p7 = x * body[7] + y * body[15] + z * body[23]
    i0, m0 = (4, p4) if p4 < p0 else (0, p0)
    i1, m1 = (5, p5) if p5 < p1 else (1, p1)
    i2, m2 = (6, p6) if p6 < p2 else (2, p2)
    i3, m3 = (7, p7) if p7 < p3 else (3, p3)
    i0, m0 = (i2, m2) if m2 < m0 else (i0, m0)
    i1, m1 = (i3, m3) if m3 < m1 else (i1, m1)
    return i1 if m1 < m0 else i0


@law
def sides(a: Array, b: Array, normal: Vector) -> Sides:
    """Return the greatest coordinate of packed body a and the least coordinate of packed body b along a normal."""
    return Sides(-least(a, opposite(normal)), least(b, normal))
