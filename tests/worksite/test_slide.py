"""Sliding: motion into a wall is removed, and motion along it is kept."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import nnls

from aftdeck.arrays import Array, Mask
from aftdeck.bodies.solid import Solid
from aftdeck.bodies.vector import Vector
from aftdeck.kinematics.jacobian import Twist
from aftdeck.worksite.sliding.projection import SLACK, TOUCH, slide
from aftdeck.worksite.sliding.touches import EACH, touching
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor
from aftdeck.worksite.watch.found import CLEARANCE
from aftdeck.worksite.watch.groups import layout_of
from tests.bodies.shapes import CUBE, rotations
from tests.worksite.scenes import clearances, moved

seeds = st.integers(0, 2**32 - 1)


def contacts(rng: np.random.Generator, count: int) -> Array:
    """Return random contacts (count, 7) around the tip, with a clearance of 0."""
    rows = np.zeros((count, 7))
    rows[:, :3] = 3.0 * rng.normal(size=(count, 3))
    rows[:, 3:6] = rotations(rng, count)[:, 0] if count else 0.0
    return rows


def touches(watch: ClearanceMonitor, counts: Mask, reach: float, period: float, out: float) -> Array:
    """Return the touches (k, 7) of the body "can", for the other arguments of `touching`."""
    own = watch.layout
    rows = np.empty((EACH * len(own.pairs), TOUCH))
    can = own.frames.index("can")
    count = touching(
        own.frame, own.pairs, own.begins, counts, can, watch.placed, watch.found, reach, period, out, rows
    )  # fmt: skip
    return rows[:count]


def slid(rows: Array, tip: Array, demanded: Array) -> Array:
    """Return the twist (6,) that `slide` allows."""
    return np.array(slide(rows, Vector(*tip.tolist()), Twist(*demanded)))


def outward(rows: Array, tip: Array, twist: Array) -> Array:
    """Return the speed (k,) at which each contact point leaves its wall [m/s]."""
    return np.asarray(((twist[3:] + np.cross(twist[:3], rows[:, :3] - tip)) * rows[:, 3:6]).sum(axis=1))


@settings(deadline=None)
@given(seeds, st.integers(0, 8))
def test_contact_points_never_enter_their_walls(seed: int, count: int) -> None:
    rng = np.random.default_rng(seed)
    rows, tip, demanded = contacts(rng, count), rng.normal(size=3), rng.normal(size=6)
    rows[:, 6] = -0.2 * rng.random(count)
    found = slid(rows, tip, demanded)
    assert (outward(rows, tip, found) >= rows[:, 6] - 1.1 * SLACK).all()
    if (outward(rows, tip, demanded) >= rows[:, 6]).all():
        assert np.array_equal(found, demanded)


@settings(deadline=None)
@given(seeds)
def test_motion_along_a_single_wall_is_unchanged(seed: int) -> None:
    rng = np.random.default_rng(seed)
    rows, tip, demanded = contacts(rng, 1), rng.normal(size=3), rng.normal(size=6)
    demanded[:3] *= rng.integers(2)
    found, normal = slid(rows, tip, demanded), rows[0, 3:6]
    before, after = (t[3:] + np.cross(t[:3], rows[0, :3] - tip) for t in (demanded, found))
    assert np.array_equal(found[:3], demanded[:3])
    assert after - (after @ normal) * normal == pytest.approx(before - (before @ normal) * normal, abs=1e-13)
    assert after @ normal == pytest.approx(max(before @ normal, 0.0), abs=1e-13)


@settings(deadline=None)
@given(seeds, st.integers(1, 8), st.sampled_from([1, 2, 3]))
def test_velocity_is_the_closest_admissible_one(seed: int, count: int, repeats: int) -> None:
    rng = np.random.default_rng(seed)
    rows, demanded = contacts(rng, count), np.array([0.0, 0.0, 0.0, *rng.normal(size=3)])
    found = slid(np.repeat(rows, repeats, axis=0), np.zeros(3), demanded)
    # Moreau: the removed part is the projection onto the cone of the normals that point into the walls
    push, _ = nnls(rows[:, 3:6].T, -demanded[3:])
    assert found[3:] == pytest.approx(demanded[3:] + rows[:, 3:6].T @ push, abs=1e-7)


def test_arm_between_six_walls_does_not_move() -> None:
    rows = np.zeros((6, 7))
    rows[:, 3:6] = np.concatenate([np.eye(3), -np.eye(3)])
    assert not slid(rows, np.zeros(3), np.array([0.0, 0.0, 0.0, 0.3, -0.2, 0.1])).any()


def test_two_walls_block_rotation_and_allow_sliding() -> None:
    rows = np.array([[4.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0], [-4.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0]])
    demanded = np.array([0.0, 0.0, 0.1, 0.3, 0.2, 0.4])
    assert slid(rows, np.zeros(3), demanded) == pytest.approx([0.0, 0.0, 0.0, 0.3, 0.0, 0.4])
    # the opposite rotation leaves both walls, and is allowed
    demanded[2] = -0.1
    assert slid(rows, np.zeros(3), demanded) == pytest.approx(demanded)


def test_body_that_cannot_leave_two_walls_does_not_move() -> None:
    rows = np.array([[0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.1], [0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.1]])
    assert not slid(rows, np.zeros(3), np.array([0.0, 0.0, 0.1, 0.3, 0.2, 0.4])).any()


@pytest.mark.slow
@settings(max_examples=20, deadline=None)
@given(seeds, st.booleans())
def test_payload_pushed_in_a_trough_slides_and_stays_out_of_its_walls(seed: int, turning: bool) -> None:
    rng = np.random.default_rng(seed)
    size = np.array([6.0, 2.0, 2.0])
    made = [
        Solid("payload", "can", CUBE * size),
        Solid("wall port", "orbiter", CUBE * [30.0, 1.0, 8.0] + [0.0, 2.0, 0.0]),
        Solid("wall starboard", "orbiter", CUBE * [30.0, 1.0, 8.0] - [0.0, 2.0, 0.0]),
        Solid("floor", "orbiter", CUBE * [30.0, 5.0, 1.0] + [0.0, 0.0, 3.0]),
    ]
    pairs = [("payload", part) for part in ("wall port", "wall starboard", "floor")]
    layout = layout_of(("orbiter", "can"), made, pairs)
    watch, counts, period = ClearanceMonitor(layout), np.ones(3, np.uint8), 0.02
    now = np.zeros((2, 12))
    now[:, 3:] = np.eye(3).ravel()
    demanded = rng.normal(size=6) * np.repeat([0.05 * turning, 0.5], 3)
    tip = np.array([0.0, 0.0, -1.0])
    along = 0.0
    watch.update(now)
    for _ in range(120):
        rows = touches(watch, counts, 0.1, period, 0.02)
        grip = now[1, :3] + now[1, 3:].reshape(3, 3) @ tip
        twist = slid(rows, grip, demanded)
        carried = np.zeros((2, 6))
        carried[1] = twist
        carried[1, 3:] -= np.cross(twist[:3], grip)
        now = moved(now, carried, period)
        along += twist[3] * period
        watch.update(now)
        # with 0.005 rad per step, a corner 4 m away deviates from its straight path by 5e-5 m
        assert watch.found[:, CLEARANCE].min() > (-1e-4 if turning else -1e-9)
    assert clearances(made, layout, now) == pytest.approx(watch.found[:, CLEARANCE], abs=1e-12)
    if not turning:
        assert along == pytest.approx(120 * demanded[3] * period)
        assert now[1, 0] == pytest.approx(along)
        # the payload reaches exactly the wall and the floor towards which it was pushed
        far = np.minimum(np.abs(demanded[4:]) * 120 * period, [0.5, 1.5])
        assert abs(now[1, 1]) == pytest.approx(far[0], abs=1e-9)
        if demanded[5] > 0.0:
            assert now[1, 2] == pytest.approx(far[1], abs=1e-9)


def test_contact_points_of_a_payload_are_its_corners_at_the_wall() -> None:
    made = [Solid("payload", "can", CUBE), Solid("wall", "orbiter", CUBE * [9.0, 1.0, 9.0])]
    layout = layout_of(("orbiter", "can"), made, [("payload", "wall")])
    watch, counts = ClearanceMonitor(layout), np.ones(1, np.uint8)
    now = np.zeros((2, 12))
    now[:, 3:] = np.eye(3).ravel()
    now[1, 1] = 1.01
    watch.update(now)
    rows = touches(watch, counts, 0.02, 0.1, 0.05)
    assert rows[:, 3:6] == pytest.approx(np.tile([0.0, 1.0, 0.0], (5, 1)), abs=1e-12)
    assert rows[:, 6] == pytest.approx(np.full(5, -0.1))
    assert {tuple(row) for row in rows[1:, :3].round(9)} == {(x, 0.51, z) for x in (-0.5, 0.5) for z in (-0.5, 0.5)}
    assert len(touches(watch, counts, 0.005, 0.1, 0.05)) == 0
    now[1, 1] = 0.99
    watch.update(now)
    assert touches(watch, counts, 0.02, 0.1, 0.05)[:, 6] == pytest.approx(np.full(5, 0.05))
