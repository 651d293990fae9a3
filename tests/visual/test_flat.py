"""Convex polygons in a plane."""

from __future__ import annotations

import math

import numpy as np
import pytest

from aftdeck.shapes import Vec2
from aftdeck.visual.flat import Flat, area, common, covers, hull, is_convex, merged
from tests.each import each, seeds


def regular(count: int, radius: float, middle: Vec2 = (0.0, 0.0)) -> Flat:
    """Return a regular polygon."""
    angles = [math.tau * k / count for k in range(count)]
    return [(middle[0] + radius * math.cos(a), middle[1] + radius * math.sin(a)) for a in angles]


def inside(polygon: Flat, points: np.ndarray) -> np.ndarray:
    """Return whether each point (n, 2) is inside a convex polygon."""
    found = np.ones(len(points), bool)
    for (ax, ay), (bx, by) in zip(polygon, [*polygon[1:], polygon[0]], strict=True):
        found &= (bx - ax) * (points[:, 1] - ay) - (by - ay) * (points[:, 0] - ax) >= 0.0
    return found


@each("seed", seeds(20, 500))
def test_the_common_part_has_the_points_that_both_have(seed: int) -> None:
    rng = np.random.default_rng(seed)
    a, b = (hull([(x, y) for x, y in rng.uniform(-1.0, 1.0, (8, 2)).tolist()]) for _ in range(2))
    points = rng.uniform(-1.0, 1.0, (300, 2))
    both = common(a, b)
    expected = inside(a, points) & inside(b, points)
    assert np.array_equal(inside(both, points) if both else np.zeros(300, bool), expected)
    assert is_convex(a)
    assert covers(a, a)
    assert not both or (covers(a, both) and covers(b, both))


@pytest.mark.parametrize("sides", [4, 8, 16])
def test_a_polygon_cut_into_triangles_becomes_one_again(sides: int) -> None:
    whole = regular(sides, 1.0)
    fan = [[(0.0, 0.0), a, b] for a, b in zip(whole, [*whole[1:], whole[0]], strict=True)]
    found = merged(fan)
    assert sum(map(area, found)) == pytest.approx(area(whole), abs=1e-6)
    assert all(map(is_convex, found))
    assert len(found) <= 2


def test_a_ring_keeps_its_hole() -> None:
    outer, inner = regular(16, 1.0), regular(16, 0.9)
    pieces = []
    for k in range(16):
        n = (k + 1) % 16
        pieces += [[inner[k], outer[k], outer[n]], [inner[k], outer[n], inner[n]]]
    found = merged(pieces)
    assert len(found) == 16
    assert sum(map(area, found)) == pytest.approx(area(outer) - area(inner), abs=1e-6)
    assert not any(inside(polygon, np.zeros((1, 2))).any() for polygon in found)
