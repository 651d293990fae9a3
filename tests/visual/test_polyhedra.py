"""Cuts, differences and unions of polyhedra, and the planes between them."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from aftdeck.bodies.hexahedron_check import hexahedron
from aftdeck.bodies.separation import separation
from aftdeck.visual.planes import TOLERANCE
from aftdeck.visual.solids import apart, difference, union
from aftdeck.visual.store import Polyhedron, area, box, of_hexahedron, polyhedron, store_of, volume
from tests.bodies.shapes import rotations, skewed

seeds = st.integers(0, 2**32 - 1)


def two(seed: int, near: float = 1.0) -> tuple[Polyhedron, Polyhedron, np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    a, b = skewed(rng, 2) @ rotations(rng, 2)
    b = b + 0.5 * near * rng.normal(size=3)
    return of_hexahedron(hexahedron(a, "a")), of_hexahedron(hexahedron(b, "b")), a, b


def assert_closed(body: Polyhedron) -> None:
    """Each edge belongs to two faces in opposite directions, and the faces' vectors of area add to zero."""
    edges = [edge for loop in body.loops for edge in zip(loop, (*loop[1:], loop[0]), strict=True)]
    assert len(set(edges)) == len(edges)
    assert {(q, p) for p, q in edges} == set(edges)
    areas = [area(body.points[list(loop)].tolist()) for loop in body.loops]
    assert np.abs(np.array(areas) @ body.planes[:, :3]).max() < 1e-9 * sum(areas)
    for plane, loop in zip(body.planes, body.loops, strict=True):
        assert np.abs(body.points[list(loop)] @ plane[:3] - plane[3]).max() < 1e-8


@given(seeds)
def test_what_a_body_loses_to_another_one_is_what_they_share(seed: int) -> None:
    a, b, _, _ = two(seed)
    shared = volume(a) - sum(map(volume, difference(a, b)))
    other = volume(b) - sum(map(volume, difference(b, a)))
    assert shared == pytest.approx(other, abs=1e-9)
    assert (shared > 1e-9) == (apart(a, b) < -1e-6) or abs(apart(a, b)) < 1e-3


@given(seeds)
def test_pieces_are_closed_and_apart(seed: int) -> None:
    a, b, _, _ = two(seed)
    pieces = difference(a, b)
    for k, piece in enumerate(pieces):
        assert_closed(piece)
        assert apart(piece, b) >= -TOLERANCE
        assert all(apart(piece, other) >= -TOLERANCE for other in pieces[:k])


@given(seeds)
def test_random_points_are_in_a_piece_or_in_the_other_body(seed: int) -> None:
    a, b, _, _ = two(seed)
    points = np.random.default_rng(seed).uniform(a.points.min(axis=0), a.points.max(axis=0), (200, 3))
    inside = [depth(points, body) for body in (a, b, *difference(a, b))]
    clear = np.all([np.abs(found) > 1e-6 for found in inside], axis=0)
    in_a, in_b, *in_pieces = (found[clear] > 0.0 for found in inside)
    assert ((in_a & ~in_b) == np.sum(in_pieces, axis=0)).all()


def depth(points: np.ndarray, body: Polyhedron) -> np.ndarray:
    return np.asarray((body.planes[:, 3] - points @ body.planes[:, :3].T).min(axis=1))


@given(seeds, st.integers(0, 2))
def test_two_halves_of_a_body_are_the_body(seed: int, axis: int) -> None:
    a, _, _, _ = two(seed)
    middle = float(a.points[:, axis].mean())
    low, high = a.points.min(axis=0) - 1.0, a.points.max(axis=0) + 1.0
    upper = low.copy()
    upper[axis] = middle
    (half,) = difference(a, box(upper, high))
    (other,) = difference(a, half)
    both = union(half, other)
    assert both is not None
    assert volume(both) == pytest.approx(volume(a), rel=1e-9)
    assert len(both.planes) == len(a.planes)


def test_bodies_whose_union_is_not_convex_are_not_joined() -> None:
    cube = box((0, 0, 0), (1, 1, 1))
    assert union(cube, box((1, 0, 0), (2, 1, 1))) is not None
    assert union(cube, box((1, 0, 0), (2, 1, 1.01))) is None
    assert union(cube, box((1.01, 0, 0), (2, 1, 1))) is None
    assert union(cube, box((0.2, 0.2, 0.2), (0.8, 0.8, 0.8))) is not None


@given(seeds, st.floats(0.1, 3.0))
def test_planes_agree_with_the_clearance(seed: int, near: float) -> None:
    a, b, vertices_a, vertices_b = two(seed, near)
    clearance = separation(vertices_a, vertices_b).clearance
    if clearance > 1e-6:
        assert 0.0 < apart(a, b) <= clearance + 1e-9
    elif clearance < -1e-6:
        assert -np.inf < apart(a, b) <= clearance + 1e-9


@given(seeds)
def test_a_store_returns_its_polyhedra(seed: int) -> None:
    a, b, _, _ = two(seed)
    store = store_of([a, b], 4)
    for k, body in enumerate((a, b)):
        found = polyhedron(store, k)
        assert found.loops == body.loops
        assert (found.points == body.points).all()
        assert (found.planes == body.planes).all()
