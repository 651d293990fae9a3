"""Polygons of which nothing is seen because a single later one covers them: painting these would change no pixel."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.law import law

_MARGIN = 2.0
"""Distance of a covered polygon's bounds from the edges of the polygon that covers them [pixels]: more than the
distance between a polygon's edge and the pixels that a painter gives to it."""
_LEAST = 400.0
"""Least area of a polygon that is tried as a cover [pixels]; smaller ones cover few others."""


@law
def mark_uncovered(points: Array, begins: Indices, found: Mask) -> None:
    """Write a 1 for each polygon that may be seen; a 0 if a single later polygon covers it.

    Args:
        points: (P, 2) corners of all convex polygons [pixels].
        begins: (Q + 1,) first corner of each polygon, in the order in which they are painted.
        found: (Q,) output.
    """
    boxes, turns, covers, count = np.empty((len(found), 4)), np.empty(len(found)), np.empty(len(found), np.int64), 0
    for q in range(len(found) - 1, -1, -1):
        left, top, right, bottom, area = np.inf, np.inf, -np.inf, -np.inf, 0.0
        for i in range(begins[q], begins[q + 1]):
            j = i + 1 if i + 1 < begins[q + 1] else begins[q]
            x, y = points[i, 0], points[i, 1]
            left, right, top, bottom = min(left, x), max(right, x), min(top, y), max(bottom, y)
            area += 0.5 * (x * points[j, 1] - y * points[j, 0])
        boxes[q, 0], boxes[q, 1], boxes[q, 2], boxes[q, 3] = left, top, right, bottom
        turns[q] = 1.0 if area > 0.0 else -1.0
        found[q] = 1
        for n in range(count):
            k = covers[n]
            if left < boxes[k, 0] or top < boxes[k, 1] or right > boxes[k, 2] or bottom > boxes[k, 3]:
                continue
            inside = True
            for i in range(begins[k], begins[k + 1]):
                j = i + 1 if i + 1 < begins[k + 1] else begins[k]
                x, y = points[i, 0], points[i, 1]
                ex, ey = turns[k] * (points[j, 0] - x), turns[k] * (points[j, 1] - y)
                # the corner of the bounds that is the farthest outside this edge
                depth = ex * ((top if ex > 0.0 else bottom) - y) - ey * ((right if ey > 0.0 else left) - x)
                if depth < _MARGIN * np.sqrt(ex * ex + ey * ey):
                    inside = False
                    break
            if inside:
                found[q] = 0
                break
        if found[q] and abs(area) >= _LEAST:
            covers[count] = q
            count += 1
