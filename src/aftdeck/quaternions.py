"""Quaternion of a rotation matrix, for laws, files and messages."""

from __future__ import annotations

from math import sqrt

from aftdeck.elementary import atan2
from aftdeck.law import elementary_law


@elementary_law
def scaled_quaternion(
    a: float, b: float, c: float, d: float, e: float, f: float, g: float, h: float, i: float
) -> tuple[float, float, float, float, float]:
    """Return w, x, y, z of a multiple of the quaternion of a rotation matrix, and its greatest component.

    The matrix is given row by row. The greatest component is positive, four times the square of that of the unit
    quaternion. For accuracy, it is computed first, and the others from it.
    """
    w, x, y, z = 1.0 + a + e + i, 1.0 + a - e - i, 1.0 - a + e - i, 1.0 - a - e + i
    greatest = max(w, x, y, z)
    if w == greatest:
        x, y, z = h - f, c - g, d - b
    elif x == greatest:
        w, y, z = h - f, d + b, c + g
    elif y == greatest:
        w, x, z = c - g, d + b, f + h
    else:
        w, x, y = d - b, c + g, f + h
    return w, x, y, z, greatest


@elementary_law
def unit_quaternion(
    a: float, b: float, c: float, d: float, e: float, f: float, g: float, h: float, i: float
) -> tuple[float, float, float, float]:
    """Return the unit quaternion w, x, y, z, with w >= 0, of a rotation matrix that is given row by row."""
    w, x, y, z, greatest = scaled_quaternion(a, b, c, d, e, f, g, h, i)
    scale = (0.5 if w >= 0.0 else -0.5) / sqrt(greatest)
    return scale * w, scale * x, scale * y, scale * z


@elementary_law
def rotation_vector(
    a: float, b: float, c: float, d: float, e: float, f: float, g: float, h: float, i: float
) -> tuple[float, float, float]:
    """Return the axis times the angle, at most pi [rad], of a rotation matrix that is given row by row."""
    w, x, y, z = unit_quaternion(a, b, c, d, e, f, g, h, i)
    sine = sqrt(x * x + y * y + z * z)
    scale = 2.0 * atan2(sine, w) / sine if sine > 0.0 else 2.0
    return scale * x, scale * y, scale * z
