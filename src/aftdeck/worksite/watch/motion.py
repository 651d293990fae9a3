"""Motion of a coordinate frame, from its poses before and after a step: the constant screw motion between the two."""

from __future__ import annotations

from math import atan2, sqrt, tan
from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.law import law
from aftdeck.worksite.watch.groups import POSE

_SMALL = 1e-2
"""Angle below which the series is used [rad]: its next term is 3e-13, and the closed form loses 1e-12 there."""


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
    # axis times sine of the rotation R Qᵀ, from its antisymmetric part; the cosine below is from its trace
    x = 0.5 * (_dot(r, q, 6, 3) - _dot(r, q, 3, 6))
    y = 0.5 * (_dot(r, q, 0, 6) - _dot(r, q, 6, 0))
    z = 0.5 * (_dot(r, q, 3, 0) - _dot(r, q, 0, 3))
    sine = sqrt(x * x + y * y + z * z)
    angle = atan2(sine, 0.5 * (_dot(r, q, 0, 0) + _dot(r, q, 3, 3) + _dot(r, q, 6, 6) - 1.0))
    scale = angle / sine if sine > 0.0 else 1.0
    x, y, z = scale * x, scale * y, scale * z
    dx, dy, dz = now[0] - before[0], now[1] - before[1], now[2] - before[2]
    # The displacement d is a chord of the screw motion: the velocity at its end is along V^-1 d + turn x d, where V is
    # the matrix of the exponential map that takes a constant velocity to the displacement.
    ux, uy, uz = y * dz - z * dy, z * dx - x * dz, x * dy - y * dx
    wx, wy, wz = y * uz - z * uy, z * ux - x * uz, x * uy - y * ux
    square = angle * angle
    share = (1.0 - 0.5 * angle / tan(0.5 * angle)) / square if angle > _SMALL else 1.0 / 12.0 + square / 720.0
    per = 1.0 / period
    return Motion(
        x * per,
        y * per,
        z * per,
        (dx + 0.5 * ux + share * wx) * per,
        (dy + 0.5 * uy + share * wy) * per,
        (dz + 0.5 * uz + share * wz) * per,
    )


@law
def _dot(r: Array, q: Array, i: int, j: int) -> float:
    """Return the dot product of two rows, which begin at r[i] and q[j]."""
    product: float = r[i] * q[j] + r[i + 1] * q[j + 1] + r[i + 2] * q[j + 2]
    return product


@law
def velocity(frames: Array, motions: Array, f: int, x: float, y: float, z: float) -> tuple[float, float, float]:
    """Return the velocity [m/s] of the point (x, y, z) that moves with frame f; poses (F, 12), motions (F, 6)."""
    x, y, z = x - frames[f, 0], y - frames[f, 1], z - frames[f, 2]
    return (
        motions[f, 3] + motions[f, 1] * z - motions[f, 2] * y,
        motions[f, 4] + motions[f, 2] * x - motions[f, 0] * z,
        motions[f, 5] + motions[f, 0] * y - motions[f, 1] * x,
    )
