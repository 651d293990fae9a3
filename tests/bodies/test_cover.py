"""Covers contain the whole curved body, and exceed it by no more than their stated bound."""

from __future__ import annotations

import math

import numpy as np
import pytest

from aftdeck import separation
from aftdeck.arrays import Array
from aftdeck.bodies.cover import Axis, prism, tube_wall
from aftdeck.bodies.hexahedron_check import hexahedron
from aftdeck.errors import InputError
from tests.bodies.shapes import CUBE

AXES: dict[Axis, tuple[int, int, int]] = {"x": (0, 1, 2), "y": (1, 2, 0), "z": (2, 0, 1)}


def covered(points: Array, bodies: Array) -> bool:
    """Return whether each point is in one of the bodies."""
    inside = np.zeros(len(points), dtype=bool)
    for body in bodies:
        packed = hexahedron(body)
        normals, distances = packed[24:42].reshape(3, 6), packed[42:]
        inside |= (points @ normals - distances).max(axis=1) <= 1e-12
    return bool(inside.all())


def radii(bodies: Array, axis: Axis) -> Array:
    """Take random points in the bodies; return their distances from the axis."""
    rng = np.random.default_rng(51)
    share = rng.dirichlet(np.full(8, 0.3), 4000)
    points = np.concatenate([share @ body for body in bodies])
    _, u, v = AXES[axis]
    return np.asarray(np.hypot(points[:, u], points[:, v]))


def around(axis: Axis, along: Array, radius: Array, angle: Array) -> Array:
    """Return the points with these positions along an axis, distances from the axis and angles about the axis."""
    points = np.empty((len(along), 3))
    for k, values in zip(AXES[axis], (along, radius * np.cos(angle), radius * np.sin(angle)), strict=True):
        points[:, k] = values
    return points


@pytest.mark.parametrize("axis", AXES)
@pytest.mark.parametrize(("count", "start", "sweep"), [(8, math.pi, math.pi), (8, 0.0, math.tau), (20, 1.0, 5.0)])
@pytest.mark.parametrize("taper", [1.0, 0.7])
def test_tube_wall_is_covered_by_its_hexahedra(
    axis: Axis, count: int, start: float, sweep: float, taper: float
) -> None:
    radius, thickness, length = 2.33, 0.02, 18.54
    walls = tube_wall(
        radius, thickness, length, radius_end=taper * radius, axis=axis, start=start, sweep=sweep, count=count
    )
    assert walls.shape == (count, 8, 3)
    rng = np.random.default_rng(52)
    t = rng.random(5000)
    outer = radius * (1.0 - t + t * taper)
    angle = start + sweep * rng.random(5000)
    assert covered(around(axis, (t - 0.5) * length, outer - thickness * rng.random(5000), angle), walls)


@pytest.mark.parametrize("count", [8, 16])
def test_tube_wall_cover_exceeds_the_wall_within_its_stated_bound(count: int) -> None:
    half = math.pi / (2 * count)
    found = radii(tube_wall(2.33, 0.02, 18.54, start=math.pi, sweep=math.pi, count=count), "x")
    assert found.min() >= 2.31 * math.cos(half) - 1e-12
    assert found.max() <= 2.33 / math.cos(half) + 1e-12
    if count == 8:
        assert 2.31 * (1.0 - math.cos(half)) == pytest.approx(0.0444, abs=1e-4)


def test_adjacent_tube_wall_hexahedra_touch() -> None:
    walls = tube_wall(2.33, 0.02, 18.54)
    for one, other in zip(walls, np.roll(walls, -1, axis=0), strict=True):
        assert separation(one, other).clearance == pytest.approx(0.0, abs=1e-12)


def test_tube_wall_clearance_is_never_overstated() -> None:
    walls = tube_wall(2.33, 0.02, 18.54, start=math.pi, sweep=math.pi)
    rng = np.random.default_rng(53)
    for _ in range(60):
        size, r, angle = rng.uniform(0.01, 0.1), rng.uniform(0.5, 2.1), math.pi * (1.1 + 0.8 * rng.random())
        middle = np.array([rng.uniform(-5.0, 5.0), r * math.cos(angle), r * math.sin(angle)])
        corners = CUBE * size + middle
        true = 2.31 - np.hypot(corners[:, 1], corners[:, 2]).max()
        found = min(separation(corners, wall).clearance for wall in walls)
        assert true - 2.31 * (1.0 - math.cos(math.pi / 16)) - 1e-12 <= found <= true + 1e-12


@pytest.mark.parametrize("axis", AXES)
@pytest.mark.parametrize(("sides", "turn", "taper"), [(12, 0.0, 1.0), (6, 0.5, 1.0), (8, 0.2, 0.5), (4, 0.1, 1.2)])
def test_round_body_is_covered_by_its_prism(axis: Axis, sides: int, turn: float, taper: float) -> None:
    slices = prism(2.0, 9.0, radius_end=2.0 * taper, axis=axis, sides=sides, turn=turn)
    assert slices.shape == (sides // 2 - 1, 8, 3)
    rng = np.random.default_rng(54)
    t = rng.random(5000)
    radius = 2.0 * (1.0 - t + t * taper) * np.sqrt(rng.random(5000))
    assert covered(around(axis, (t - 0.5) * 9.0, radius, math.tau * rng.random(5000)), slices)
    assert radii(slices, axis).max() <= 2.0 * max(1.0, taper) / math.cos(math.pi / sides) + 1e-12


def test_twelve_sided_prism_exceeds_its_radius_by_less_than_1_in_28() -> None:
    assert radii(prism(1.0, 1.0), "x").max() < 1.0 + 1.0 / 28.0


def test_prism_slices_do_not_overlap() -> None:
    slices = prism(2.0, 9.0)
    for k, one in enumerate(slices):
        for other in slices[:k]:
            assert separation(one, other).clearance >= -1e-12


def test_round_body_clearance_is_never_overstated() -> None:
    slices = prism(1.5, 6.0)
    rng = np.random.default_rng(55)
    for _ in range(60):
        grain = CUBE * 1e-3
        angle, r, x = rng.uniform(0.0, math.tau), rng.uniform(1.7, 4.0), rng.uniform(-5.0, 5.0)
        middle = np.array([x, r * math.cos(angle), r * math.sin(angle)])
        true = math.hypot(r - 1.5, max(abs(x) - 3.0, 0.0))
        found = min(separation(grain + middle, part).clearance for part in slices)
        assert true - 1.5 * (1.0 / math.cos(math.pi / 12) - 1.0) - 1e-3 <= found <= true


def test_prism_flat_is_at_its_turn_angle() -> None:
    for turn in (0.0, 0.4):
        grain = CUBE * 1e-3 + np.array([0.0, 3.0 * math.cos(turn), 3.0 * math.sin(turn)])
        clearance = min(separation(grain, part).clearance for part in prism(2.0, 4.0, turn=turn))
        assert clearance == pytest.approx(1.0, abs=1e-3)


@pytest.mark.parametrize(
    ("sizes", "message"),
    [
        ({"radius": 0.0}, "radius is 0"),
        ({"radius_end": -1.0}, "radius_end is -1"),
        ({"thickness": math.nan}, "thickness is nan"),
        ({"thickness": 2.0}, "thickness is 2 m; it has to be less"),
        ({"length": math.inf}, "length is inf"),
        ({"sweep": 7.0}, "sweep is 7"),
        ({"start": math.nan}, "start is nan"),
        ({"count": 7}, "count is 7"),
        ({"axis": "w"}, "axis is 'w'"),
    ],
)
def test_invalid_tube_wall_argument_is_rejected(sizes: dict[str, float], message: str) -> None:
    given = {"radius": 2.0, "thickness": 0.1, "length": 5.0} | sizes
    with pytest.raises(InputError, match=message):
        tube_wall(**given)  # type: ignore[arg-type]  # an axis among the numbers


@pytest.mark.parametrize(
    ("sizes", "message"),
    [
        ({"radius": math.nan}, "radius is nan"),
        ({"length": 0.0}, "length is 0"),
        ({"sides": 7}, "7 sides"),
        ({"sides": 2}, "2 sides"),
        ({"turn": math.inf}, "turn is inf"),
    ],
)
def test_invalid_prism_argument_is_rejected(sizes: dict[str, float], message: str) -> None:
    given = {"radius": 2.0, "length": 5.0} | sizes
    with pytest.raises(InputError, match=message):
        prism(**given)  # type: ignore[arg-type]  # whole numbers among the others
