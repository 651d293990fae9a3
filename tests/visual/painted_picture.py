"""Pictures painted polygon by polygon: each pixel shows the last polygon that contains its centre."""

from __future__ import annotations

import numpy as np
from numba import njit

from aftdeck.arrays import Indices
from aftdeck.visual.polygons import Polygons


def painted(polygons: Polygons, width: int, height: int) -> Indices:
    """Return the cluster (height, width) that each pixel shows; -1 where it shows none."""
    shown: Indices = _painted(polygons.points, polygons.begins, polygons.owner, width, height)
    return shown


@njit(cache=True)
def _painted(points, begins, owner, width, height):  # type: ignore[no-untyped-def]
    shown = np.full((height, width), -1, np.int64)
    for q in range(len(owner)):
        first, end = begins[q], begins[q + 1]
        x = (points[first:end, 0] + 1.0) * 0.5 * width
        y = (points[first:end, 1] + 1.0) * 0.5 * height
        # the sign of the area gives the side of the edges on which the inside is
        area = 0.0
        for i in range(len(x)):
            j = (i + 1) % len(x)
            area += x[i] * y[j] - x[j] * y[i]
        sign = 1.0 if area > 0.0 else -1.0
        for row in range(max(0, int(y.min() - 0.5)), min(height, int(y.max() + 0.5) + 1)):
            for column in range(max(0, int(x.min() - 0.5)), min(width, int(x.max() + 0.5) + 1)):
                inside = True
                for i in range(len(x)):
                    j = (i + 1) % len(x)
                    across = (x[j] - x[i]) * (row + 0.5 - y[i]) - (y[j] - y[i]) * (column + 0.5 - x[i])
                    if sign * across < 0.0:
                        inside = False
                        break
                if inside:
                    shown[row, column] = owner[q]
    return shown
