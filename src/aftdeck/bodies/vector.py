"""Vectors of three named numbers, for use inside the laws.

Compiled code creates these tuples in almost no time. To pass such a tuple from Python would take microseconds.
"""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.law import law


class Vector(NamedTuple):
    """Vector, or position of a point."""

    x: float
    y: float
    z: float


ZERO = Vector(0.0, 0.0, 0.0)


@law
def vector_at(values: Array, at: int) -> Vector:
    """Return the vector whose three components begin at index `at`."""
    return Vector(values[at], values[at + 1], values[at + 2])


@law
def put_vector(values: Array, at: int, v: Vector) -> None:
    """Write the three components of a vector from index `at` on."""
    values[at], values[at + 1], values[at + 2] = v.x, v.y, v.z


@law
def plus(p: Vector, q: Vector) -> Vector:
    """Return p + q."""
    return Vector(p.x + q.x, p.y + q.y, p.z + q.z)


@law
def minus(p: Vector, q: Vector) -> Vector:
    """Return p - q."""
    return Vector(p.x - q.x, p.y - q.y, p.z - q.z)


@law
def opposite(v: Vector) -> Vector:
    """Return -v."""
    return Vector(-v.x, -v.y, -v.z)


@law
def moved_along(p: Vector, share: float, v: Vector) -> Vector:
    """Return p + share * v."""
    return Vector(p.x + share * v.x, p.y + share * v.y, p.z + share * v.z)


@law
def times(share: float, v: Vector) -> Vector:
    """Return share * v."""
    return Vector(share * v.x, share * v.y, share * v.z)


@law
def dot(p: Vector, q: Vector) -> float:
    """Return the dot product of two vectors."""
    return p.x * q.x + p.y * q.y + p.z * q.z


@law
def cross(p: Vector, q: Vector) -> Vector:
    """Return the cross product p × q."""
    return Vector(p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x)
