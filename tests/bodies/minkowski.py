"""How deep two convex bodies are in each other, from the convex hull of their vertices' differences (Qhull)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull

Array = NDArray[np.float64]


def depth(a: Array, b: Array) -> float:
    """The length of the shortest move that takes the hulls of two sets of points apart; 0 where they are [m]."""
    hull = ConvexHull((a[:, None] - b[None]).reshape(-1, 3))
    return max(0.0, -float(hull.equations[:, 3].max()))
