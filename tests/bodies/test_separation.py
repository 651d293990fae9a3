"""Results of `aftdeck.separation`, against brute force and against the properties of a distance."""

from __future__ import annotations

import numpy as np
import pytest

import aftdeck
from aftdeck import Separation, separation
from aftdeck.arrays import Array
from aftdeck.bodies.pair import CONTACT
from tests.bodies import brute
from tests.bodies.shapes import CUBE, boxes, moved, near_contact, rotations, skewed

NEEDLE = CUBE * [0.01, 0.01, 6.0]
PLATE = CUBE * [4.0, 4.0, 0.5]


def near_pairs(seed: int, count: int) -> list[tuple[Array, Array]]:
    """Return random pairs of boxes and skewed bodies near contact."""
    rng = np.random.default_rng(seed)
    both = np.concatenate([boxes(rng, count), skewed(rng, count)])
    bodies = np.einsum("nij,nvj->nvi", rotations(rng, 2 * count), both)[rng.permutation(2 * count)]
    a, b = bodies[:count], bodies[count:]
    return list(zip(a, b + near_contact(rng, a, b).shift[:, None], strict=True))


def apart(found: Separation) -> Array:
    """Return the vector from the first closest point to the second."""
    return found.closest.b - found.closest.a


def test_clearance_agrees_with_brute_force() -> None:
    for a, b in near_pairs(1, 400):
        assert separation(a, b).clearance == pytest.approx(brute.clearance(a, b), abs=1e-12)


def test_clearance_of_needles_and_slabs_agrees_with_brute_force() -> None:
    rng = np.random.default_rng(2)
    for _ in range(200):
        sizes = np.exp(rng.uniform(np.log(1e-3), np.log(20.0), (2, 3)))
        a, b = np.einsum("nij,nvj->nvi", rotations(rng, 2), CUBE * sizes[:, None])
        b = b + near_contact(rng, a[None], b[None]).shift
        assert separation(a, b).clearance == pytest.approx(brute.clearance(a, b), abs=1e-12)


def test_exchanged_bodies_have_equal_clearance_and_opposite_normal() -> None:
    for a, b in near_pairs(3, 300):
        one, other = separation(a, b), separation(b, a)
        assert one.clearance == pytest.approx(other.clearance, abs=1e-13)
        assert one.collides == other.collides
        if one.plane is not None and other.plane is not None:
            # For a small clearance, rounding limits the accuracy of the direction.
            assert one.plane.normal == pytest.approx(-other.plane.normal, abs=1e-12 + 1e-14 / one.clearance)


def test_rigid_motion_of_both_bodies_keeps_their_clearance() -> None:
    rng = np.random.default_rng(4)
    for a, b in near_pairs(4, 300):
        turn, move = rotations(rng, 1)[0], rng.normal(size=3) * 10.0
        there = separation(a @ turn.T + move, b @ turn.T + move)
        here = separation(a, b)
        assert there.clearance == pytest.approx(here.clearance, abs=1e-12)


def test_moving_apart_along_the_normal_adds_exactly_that_clearance() -> None:
    rng = np.random.default_rng(5)
    for a, b in near_pairs(5, 300):
        found = separation(a, b)
        if found.plane is not None:
            step = rng.uniform(0.0, 2.0)
            beyond = separation(a, b + step * found.plane.normal)
            assert beyond.clearance == pytest.approx(found.clearance + step, abs=1e-12)


def test_bodies_moved_apart_by_their_penetration_depth_touch() -> None:
    for a, b in near_pairs(6, 300):
        found = separation(a, b)
        if found.clearance < -1e-6:
            out = -apart(found)
            assert separation(a, b + out).clearance == pytest.approx(0.0, abs=1e-12)
            assert separation(a, b + 0.99 * out).collides
            assert not separation(a, b + 1.01 * out).collides


def test_moving_apart_never_reduces_clearance() -> None:
    rng = np.random.default_rng(7)
    for a, b in near_pairs(7, 100):
        found = separation(a, b)
        if found.plane is None:
            continue
        way = rng.normal(size=3)
        way *= np.sign(way @ found.plane.normal)
        clearances = [separation(a, b + step * way).clearance for step in (0.0, 0.01, 0.1, 1.0)]
        assert np.diff(clearances).min() >= -1e-13


@pytest.mark.parametrize("across", [False, True])
def test_needle_through_a_face_collides_in_either_argument_order(across: bool) -> None:
    turn = np.array([[1.0, 0.0, 0.0], [0.0, 0.96, -0.28], [0.0, 0.28, 0.96]])
    needle = NEEDLE @ turn.T + [0.3, 0.2, 0.1]
    found = separation(needle, PLATE) if across else separation(PLATE, needle)
    through, through_what = found.feature if across else found.feature[::-1]
    assert found.collides
    assert found.plane is None
    assert through in {"edge 12", "edge 34", "edge 56", "edge 78"}
    assert through_what in {"face c", "face d"}
    assert found.clearance < -0.5


def test_needle_that_ends_before_a_face_does_not_collide() -> None:
    # The edges of the needle do not pierce the plate; only their extensions do.
    found = separation(moved(NEEDLE, 0.3, 0.2, 3.25 + 1e-6), PLATE)
    assert found.clearance == pytest.approx(1e-6, abs=1e-12)
    assert not found.collides


@pytest.mark.parametrize(
    ("gap", "collides"),
    [(0.0, True), (0.9e-9, True), (1.1e-9, False), (1e-6, False), (-0.9e-9, True), (-1e-3, True)],
)
@pytest.mark.parametrize("turned", [False, True])
def test_contact_is_a_clearance_of_at_most_1_nm(gap: float, collides: bool, turned: bool) -> None:
    turn = rotations(np.random.default_rng(8), 1)[0] if turned else np.eye(3)
    for shift in ([1.0 + gap, 0.0, 0.0], [0.3, 1.0 + gap, -0.4]):
        found = separation(CUBE @ turn.T, (CUBE + shift) @ turn.T)
        assert found.clearance == pytest.approx(gap, abs=1e-14)
        assert found.collides is collides
        assert (found.plane is None) is collides


@pytest.mark.parametrize("shift", [[1.0, 1.0, 0.0], [1.0, 1.0, 1.0], [1.0, 0.3, 0.2], [1.0, 1.0, 0.4]])
def test_touching_edges_vertices_and_faces_collide(shift: list[float]) -> None:
    found = separation(CUBE, CUBE + shift)
    assert found.collides
    assert found.clearance == pytest.approx(0.0, abs=1e-15)
    assert found.closest.a == pytest.approx(found.closest.b, abs=1e-15)


def test_body_overlaps_itself_by_its_least_thickness() -> None:
    for body in near_pairs(9, 50)[0]:
        found = separation(body, body)
        assert found.clearance == pytest.approx(brute.clearance(body, body), abs=1e-13)
    assert separation(CUBE * [3.0, 2.0, 1.0], CUBE * [3.0, 2.0, 1.0]).clearance == pytest.approx(-1.0, abs=1e-15)


def test_nested_body_depth_is_face_distance_plus_half_thickness() -> None:
    found = separation(CUBE * 4.0, CUBE * [0.5, 0.6, 0.7] + [1.2, 0.0, 0.0])
    assert found.clearance == pytest.approx(-(2.0 - 1.2 + 0.25), abs=1e-15)
    assert apart(found) == pytest.approx([found.clearance, 0.0, 0.0], abs=1e-15)
    assert found.feature.a == "body"


def test_parallel_faces_give_closest_points_that_face_each_other() -> None:
    found = separation(CUBE, CUBE * [2.0, 0.5, 0.5] + [2.0, 0.1, -0.2])
    assert found.clearance == pytest.approx(0.5, abs=1e-15)
    assert apart(found) == pytest.approx([0.5, 0.0, 0.0], abs=1e-15)
    assert found.plane is not None
    assert found.plane.normal == pytest.approx([1.0, 0.0, 0.0])
    assert found.plane.distance == pytest.approx(0.75)


@pytest.mark.parametrize(
    ("shift", "feature"),
    [
        ([1.5, 1.5, 1.5], ("vertex 8", "vertex 1")),
        ([-1.5, -1.5, -1.5], ("vertex 1", "vertex 8")),
        ([0.9, 0.8, 0.7], ("vertex 8", "body")),
    ],
)
def test_features_are_named_by_their_vertices(shift: list[float], feature: tuple[str, str]) -> None:
    assert separation(CUBE, CUBE + shift).feature == feature


def test_closest_points_on_an_edge_or_a_face_name_it() -> None:
    turn = np.array([[0.8, 0.0, 0.6], [0.0, 1.0, 0.0], [-0.6, 0.0, 0.8]]) @ np.array(
        [[0.8, -0.6, 0.0], [0.6, 0.8, 0.0], [0.0, 0.0, 1.0]]
    )
    pin = (CUBE * 0.1) @ turn.T
    assert separation(CUBE * 4.0, moved(pin, 3.0, 0.2, 0.3)).feature.a == "face f"
    assert separation(CUBE * 4.0, moved(pin, 3.0, 3.0, 0.3)).feature.a == "edge 78"


def test_separation_results_share_no_memory() -> None:
    one, two = separation(CUBE, CUBE + 3.0), separation(CUBE, CUBE + 4.0)
    assert one.plane is not None
    assert two.plane is not None
    assert one.plane.distance != two.plane.distance
    assert not np.shares_memory(one.closest.a, two.closest.a)


def test_separation_is_public() -> None:
    assert {"separation", "Separation"} <= set(aftdeck.__all__)


def test_bodies_count_as_apart_only_if_the_stored_plane_separates_them() -> None:
    """At gaps of about CONTACT, in steps of its rounding: the plane that is stored was tested with all vertices."""
    rng = np.random.default_rng(12)
    for a, b in near_pairs(12, 400):
        found = separation(a, b)
        if abs(found.clearance) < 1e-6:
            continue  # rounding limits the accuracy of the direction
        line = apart(found)
        out = line / found.clearance
        touching = b - line  # the closest points coincide
        for gap in (*(CONTACT + np.array([-1e-15, 0.0, 1e-16, 1e-15])), *rng.uniform(0.0, 4.0 * CONTACT, 4)):
            now = separation(a, touching + gap * out)
            if now.plane is not None:
                below, above = (a @ now.plane.normal).max(), ((touching + gap * out) @ now.plane.normal).min()
                assert below < now.plane.distance < above
                assert now.clearance > CONTACT
            else:
                assert now.clearance <= CONTACT and gap < CONTACT + 1e-14
