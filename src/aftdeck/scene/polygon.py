"""Flat outlines: signed area, corners moved inwards, and the triangles that fill an outline."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from aftdeck.arrays import Array
from aftdeck.shapes import Vec2

SHARPEST = 2.0**0.5
"""Greatest inward displacement of a corner if its edges move inwards by 1, as on the page."""


def signed_area(outline: Sequence[Vec2]) -> float:
    """Return the area inside an outline [m^2]; negative if the outline is clockwise."""
    twice = 0.0
    for a, b in zip(outline, (*outline[1:], outline[0]), strict=True):
        twice += a[0] * b[1] - a[1] * b[0]
    return 0.5 * twice


def inwards(outline: Sequence[Vec2]) -> Array:
    """Return the displacement (n, 2) of each corner of a counter-clockwise outline if all edges move inwards by 1."""
    corners = np.array(outline, dtype=np.float64)
    edges = np.roll(corners, -1, axis=0) - corners
    lengths = np.sqrt(_squares(edges))
    normals = np.stack([-edges[:, 1], edges[:, 0]], axis=1) / np.where(lengths > 0.0, lengths, 1.0)
    both = normals + np.roll(normals, 1, axis=0)
    directions = both / np.maximum(0.5 * _squares(both), 1e-12)
    sizes = np.sqrt(_squares(directions))
    return np.asarray(directions * np.minimum(1.0, SHARPEST / np.maximum(sizes, SHARPEST)))


def _squares(vectors: Array) -> Array:
    """Return the squared lengths (n, 1) of vectors (n, 2)."""
    x, y = vectors[:, :1], vectors[:, 1:]
    return np.asarray(x * x + y * y)


def triangles(outline: Sequence[Vec2]) -> list[tuple[int, int, int]]:
    """Return the n - 2 counter-clockwise triangles that fill a counter-clockwise outline, by cutting off ears.

    Every edge of the outline is an edge of one triangle. If three corners are on one line, some triangles may
    have no area. If the outline crosses itself, some triangles overlap.
    """
    left = list(range(len(outline)))
    found = []
    while len(left) > 3:
        ears = (i for i in range(len(left)) if _is_ear(outline, left, i))
        i = next(ears, 0)
        found.append((left[i - 1], left[i], left[(i + 1) % len(left)]))
        del left[i]
    return [*found, (left[0], left[1], left[2])]


def _is_ear(outline: Sequence[Vec2], left: list[int], i: int) -> bool:
    """Return whether corner i is convex and no other corner is in the triangle of corner i and its two neighbours."""
    a, b, c = (outline[left[k % len(left)]] for k in (i - 1, i, i + 1))
    if _turn(a, b, c) <= 0.0:
        return False
    others = (outline[k] for k in left)
    return not any(
        p not in (a, b, c) and _turn(a, b, p) >= 0.0 and _turn(b, c, p) >= 0.0 and _turn(c, a, p) >= 0.0 for p in others
    )


def _turn(a: Vec2, b: Vec2, c: Vec2) -> float:
    """Return twice the signed area of a triangle."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
