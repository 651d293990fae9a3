"""How deep two convex bodies are in each other, from the convex hull of their vertices' differences (Qhull)."""

from __future__ import annotations

from scipy.spatial import ConvexHull

from aftdeck.arrays import Array


def depth(a: Array, b: Array) -> float:
    """The length of the shortest move that takes the hulls of two sets of points apart; 0 where they are [m]."""
    hull = ConvexHull((a[:, None] - b[None]).reshape(-1, 3))
    return max(0.0, -float(hull.equations[:, 3].max()))
