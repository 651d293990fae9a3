"""Tuples of numbers used throughout the package; the docstring at each use gives unit and axes."""

from __future__ import annotations

Vec3 = tuple[float, float, float]
Six = tuple[float, float, float, float, float, float]
"""One number for each joint; or a twist, angular velocity first."""
Rows = tuple[Vec3, Vec3, Vec3]
"""Rotation as the rows of the matrix whose columns are the axes. In files a rotation is a quaternion, w, x, y, z."""
