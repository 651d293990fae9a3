"""Penetration depth of two convex bodies, from the convex hull of their vertices' differences (Qhull)."""

from __future__ import annotations

from scipy.spatial import ConvexHull

from aftdeck.arrays import Array


def depth(a: Array, b: Array) -> float:
    """Return the shortest translation that separates the hulls of two sets of points [m]; 0 if they are separate."""
    hull = ConvexHull((a[:, None] - b[None]).reshape(-1, 3))
    return max(0.0, -float(hull.equations[:, 3].max()))
