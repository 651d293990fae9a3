"""Tuples of numbers used throughout the package; the docstring at each use gives unit and axes."""

from __future__ import annotations

from collections.abc import Iterable

Vec3 = tuple[float, float, float]
Six = tuple[float, float, float, float, float, float]
"""One number for each joint; or a twist, angular velocity first."""
Rows = tuple[Vec3, Vec3, Vec3]
"""The three rows of a rotation matrix, whose columns are the axes of the rotated coordinate frame.

In files a rotation is a quaternion, w, x, y, z.
"""


def plain_vector(values: Iterable[float]) -> Vec3:
    """Return three numbers, for example quantities of a file, as Python floats."""
    x, y, z = map(float, values)
    return x, y, z
