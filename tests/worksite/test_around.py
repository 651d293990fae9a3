"""The contact update of a control step, against separate calls of its functions and against plain matrices."""

from __future__ import annotations

import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.bodies.pose import HERE, pose_of, row_of
from aftdeck.frames import Pose
from aftdeck.kinematics.frames import place_frames
from aftdeck.kinematics.observe import SEEN, observe, observe_near
from aftdeck.plant.state import FOLLOWING
from aftdeck.simulation.constants.flight import FAST, WATCHED
from aftdeck.simulation.payloads.alignment import alarm_pairs
from aftdeck.worksite.watch.places import nearest_place, place_everything
from tests.simulation.flights import random_inputs


def rotation(rng: np.random.Generator) -> Array:
    q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    proper: Array = q * np.sign(np.linalg.det(q))
    return proper


def some_row(rng: np.random.Generator, size: float = 5.0) -> Array:
    return row_of(Pose(rng.normal(size=3) * size, rotation(rng)))


def within(outer: Array, inner: Array) -> Array:
    """Return the product of two poses, by matrices: `outer` in a coordinate frame, and `inner` relative to `outer`."""
    a, b = pose_of(outer), pose_of(inner)
    return row_of(Pose(a.rotation @ b.position + a.position, a.rotation @ b.rotation))


@pytest.mark.parametrize("name", ["concept-1972", "srms-deploy"])
def test_frames_follow_their_carriers(name: str) -> None:
    rng = np.random.default_rng(3)
    sim = aftdeck.Simulation(name)
    site, stand = sim._flight.site, sim._state.plant.stand.position
    arm = len(site.arm.names)
    for _ in range(50):
        angles, prong, moved = rng.uniform(-2.0, 2.0, 6), rng.uniform(-0.3, 0.0), rng.normal(size=3)
        rides = np.array([some_row(rng) for _ in range(3)])
        carrier = np.array([arm, -1, 0])
        frames = np.full((2 + arm + 3, 12), np.nan)
        args = (site.arm.joints, site.scene, site.axes, moved, carrier, rides, angles, stand, prong)
        own = np.empty((arm, 12))
        place_frames(site.arm.joints, angles, stand, prong, own)
        bent = rng.random() < 0.5
        own += rng.normal(size=own.shape) if bent else 0.0
        place_everything(*args, own if bent else FOLLOWING, np.array(HERE), frames)
        if bent and arm == 9:  # the concept arm's prong moves along y of the hand
            own[8, 3:], own[8, :3] = own[6, 3:], own[6, :3] + prong * own[6, [4, 7, 10]]
        away = np.concatenate([site.axes @ moved, np.zeros(9)])
        expected = [site.scene, *own, site.scene - away, within(own[arm - 1], rides[0]), rides[1] - away]
        expected.append(within(site.scene, rides[2]))
        assert frames == pytest.approx(np.array(expected), abs=1e-12)


@pytest.mark.parametrize("name", ["concept-1972", "srms-deploy", "free-flyer"])
def test_step_equals_its_separate_contact_updates(name: str) -> None:
    sim = aftdeck.Simulation(name)
    state = sim._state
    period = sim.scenario.control_period
    for inputs in random_inputs(np.random.default_rng(11), 60):
        worksite = state.worksite
        counts = alarm_pairs(sim._flight, state, worksite.watch, worksite.frames, worksite.permitted)[0]
        watch, count = state.worksite.watch.copied(), state.worksite.contacts.count.copy()
        sim.advance(inputs)
        if not np.array_equal(watch.active, worksite.watch.active):
            continue  # a payload was captured or released at the end of the step
        watch.look_near(worksite.frames, counts, max(WATCHED, FAST * period))
        assert np.array_equal(watch.found, worksite.watch.found)
        assert np.array_equal(watch.placed, worksite.watch.placed)
        touching = watch.found[:, 0] <= 1e-9
        assert np.array_equal(worksite.contacts.count, np.where(touching, np.minimum(count + 1, 2), 0))
        assert worksite.nearest == watch.nearest(counts)


def test_nearest_place_is_the_closest_position_within_the_limit() -> None:
    rng = np.random.default_rng(5)
    found = set()
    for _ in range(300):
        frames = np.array([some_row(rng, 1.0) for _ in range(4)])
        rows, places = rng.integers(0, 3, 5), np.array([some_row(rng, 1.0) for _ in range(5)])
        away = [
            float(np.linalg.norm(within(frames[r], p)[:3] - frames[3, :3])) for r, p in zip(rows, places, strict=True)
        ]
        nearest = nearest_place(frames, 3, rows, places, 1.0)
        assert nearest == (int(np.argmin(away)) if min(away) < 1.0 else -1)
        found.add(nearest)
    assert -1 in found and len(found) > 3
    assert nearest_place(frames, 3, rows[:0], places[:0], 1.0) == -1


@pytest.mark.parametrize("name", ["concept-1972", "srms"])
def test_arm_is_near_a_limit_beyond_reach_or_close_to_a_singularity(name: str) -> None:
    rng = np.random.default_rng(7)
    model = aftdeck.load_arm(name).model
    reach = model.limits.reach
    answers = set()
    for _ in range(300):
        angles = rng.uniform(reach[:, 0] - 0.1, reach[:, 1] + 0.1)
        rates, seen, plain = rng.normal(size=6), np.empty(SEEN + 3), np.empty(SEEN + 3)
        near = observe_near(model.links, angles, rates, 0.25, reach, model.singular, seen)
        observe(model.links, angles, rates, plain)
        plain[17] -= 0.25
        past = bool(np.any((angles < reach[:, 0]) | (angles > reach[:, 1])))
        assert near == (past or bool(np.any(np.abs(seen[18:]) < model.singular)))
        assert np.array_equal(seen, plain)
        answers.add(near)
    assert answers == {True, False}
