"""Tuples of numbers used throughout the package; the docstring at each use gives unit and axes."""

from __future__ import annotations

from collections.abc import Iterable

Vec3 = tuple[float, float, float]
Six = tuple[float, float, float, float, float, float]
"""A twist, angular velocity first; or six values of another kind in the same order of axes."""
Joints = tuple[float, ...]
"""One number for each joint, in the order of the arm's joints."""
MOST_JOINTS = 8
"""Greatest number of joints of an arm."""
Rows = tuple[Vec3, Vec3, Vec3]
"""The three rows of a rotation matrix, whose columns are the axes of the rotated coordinate frame.

In files a rotation is a quaternion, w, x, y, z.
"""
UNTURNED: Rows = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
"""Rows of the rotation by no angle."""


def plain_vector(values: Iterable[float]) -> Vec3:
    """Return three numbers, for example quantities of a file, as Python floats."""
    x, y, z = map(float, values)
    return x, y, z
