"""Motion of a coordinate frame, from its poses before and after a step: the constant screw motion between the two."""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.bodies.vector import Vector, cross, dot, minus, times, vector_at
from aftdeck.elementary import atan2, sincos
from aftdeck.law import law
from aftdeck.worksite.watch.groups import POSE

_SMALL = 1e-2
"""Angle below which a series replaces the closed form [rad]. At this angle the first omitted term of the series is
3e-13, and the rounding error of the closed form is 1e-12."""


class Motion(NamedTuple):
    """Angular velocity [rad/s], and the velocity of the frame's origin at the end of the step [m/s], in L."""

    wx: float
    wy: float
    wz: float
    vx: float
    vy: float
    vz: float


@law
def motion(before: Array, now: Array, period: float) -> Motion:
    """Return the motion of a frame at the end of a step, from its poses before and after, both (12,) in L.

    The result is exact for a constant twist. Rotations of half a turn or more in one step are ambiguous.
    """
    still = True
    for k in range(POSE):
        still = still and before[k] == now[k]
    if still:
        return Motion(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    r, q = now[3:], before[3:]
    # R Qᵀ is the rotation in this step. Its antisymmetric part gives the axis times the sine of the angle; its trace
    # gives the cosine below.
    axis = Vector(
        0.5 * (_dot(r, q, 6, 3) - _dot(r, q, 3, 6)),
        0.5 * (_dot(r, q, 0, 6) - _dot(r, q, 6, 0)),
        0.5 * (_dot(r, q, 3, 0) - _dot(r, q, 0, 3)),
    )
    sine = sqrt(dot(axis, axis))
    angle = atan2(sine, 0.5 * (_dot(r, q, 0, 0) + _dot(r, q, 3, 3) + _dot(r, q, 6, 6) - 1.0))
    turn = times(angle / sine if sine > 0.0 else 1.0, axis)
    d = minus(vector_at(now, 0), vector_at(before, 0))
    # The displacement d is a chord of the screw motion. The velocity at the end of the step is
    # (V^-1 d + turn x d) / period. V is the matrix in the exponential map; it converts a constant velocity to a
    # displacement.
    u = cross(turn, d)
    w = cross(turn, u)
    square = angle * angle
    s, c = sincos(0.5 * angle)
    share = (1.0 - 0.5 * angle * c / s) / square if angle > _SMALL else 1.0 / 12.0 + square / 720.0
    per = 1.0 / period
    return Motion(
        turn.x * per,
        turn.y * per,
        turn.z * per,
        (d.x + 0.5 * u.x + share * w.x) * per,
        (d.y + 0.5 * u.y + share * w.y) * per,
        (d.z + 0.5 * u.z + share * w.z) * per,
    )


@law
def _dot(r: Array, q: Array, i: int, j: int) -> float:
    """Return the dot product of two rows, which begin at r[i] and q[j]."""
    product: float = r[i] * q[j] + r[i + 1] * q[j + 1] + r[i + 2] * q[j + 2]
    return product


@law
def velocity(frame: Array, moves: Motion, point: Vector) -> Vector:
    """Return the velocity [m/s] of a point that moves with a frame at the pose `frame` (12,)."""
    r, w = minus(point, vector_at(frame, 0)), moves
    return Vector(
        w.vx + w.wy * r.z - w.wz * r.y,
        w.vy + w.wz * r.x - w.wx * r.z,
        w.vz + w.wx * r.y - w.wy * r.x,
    )
