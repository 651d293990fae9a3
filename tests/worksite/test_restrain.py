"""An inhibited arm: no contact is deepened, no new contact is made, and motion that relieves a contact is allowed."""

from __future__ import annotations

from math import sqrt

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from aftdeck.arrays import Array, Mask
from aftdeck.bodies.pair import CONTACT
from aftdeck.bodies.solid import Solid
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor
from aftdeck.worksite.watch.contact_motion import (
    BESIDES,
    DEEPER,
    LEAST_RELIEF,
    RELIEF,
    relief,
    worst_new_contact,
)
from aftdeck.worksite.watch.contact_trial import trial_of
from aftdeck.worksite.watch.found import CLEARANCE
from aftdeck.worksite.watch.groups import Layout, layout_of
from tests.bodies.shapes import boxes, skewed
from tests.worksite.scenes import CHAIN, all_pairs, clearances, moved, poses, scene

PERIOD = 0.02
seeds = st.integers(0, 2**32 - 1)


def relieves(watch: ClearanceMonitor, counts: Mask, after: Array) -> bool:
    """Return whether a motion to the poses `after` relieves the contacts of the groups that count."""
    return relief(trial_of(watch, counts, counts, after)) > 0.0


def arm_moved(rng: np.random.Generator, frames: Array, pace: float) -> Array:
    """Return the coordinate frames one step later: the arm's frames have random twists, the others do not move."""
    twists = np.zeros((len(frames), 6))
    twists[1:4] = pace * rng.normal(size=(3, 6))
    return moved(frames, twists, PERIOD)


def lost_clearance(before: Array, after: Array) -> Array:
    """Return the loss of clearance (g,) of each pair that is in contact before or after [m]; 0 for the others."""
    touched = (before <= CONTACT) | (after <= CONTACT)
    return np.where(touched, before - after, 0.0)


def carried(before: Array, after: Array, point: Array) -> Array:
    """Return the position of a point after the motion of the frame that carries it, by matrices."""
    r, q = before[3:].reshape(3, 3), after[3:].reshape(3, 3)
    return np.asarray(q @ r.T @ (point - before[:3]) + after[:3])


def gained_clearance(made: list[Solid], layout: Layout, counts: Mask, now: Array, then: Array) -> tuple[float, float]:
    """Return the clearance gained by all solids in contact and the greatest sliding distance [m].

    Without a contact, the first value is inf.
    """
    gained, slid, touching = 0.0, 0.0, False
    for g in np.flatnonzero(counts).tolist():
        pairs = list(zip(all_pairs(made, layout, g, now), all_pairs(made, layout, g, then), strict=True))
        if min(before.clearance for before, _ in pairs) > CONTACT:
            continue
        touching = True
        a, b = layout.between_frames[g]
        for before, after in pairs:
            if before.clearance > CONTACT:
                gained += min(after.clearance, 0.0)
                continue
            gained += after.clearance - before.clearance
            p, q = map(np.asarray, before.closest)
            normal = (q - p) / np.linalg.norm(q - p)
            displacement = carried(now[a], then[a], p) - p - (carried(now[b], then[b], q) - q)
            slid = max(slid, float(np.linalg.norm(np.cross(displacement, normal))))
    return (gained if touching else np.inf), slid


def lost_at_most(before: Array, after: Array, gained: float) -> float:
    """Return the clearance [m] that each pair may lose if the solids in contact gain `gained` in total.

    If the step makes a new contact, the result is `DEEPER`.
    """
    made = bool(((before > CONTACT) & (after <= CONTACT)).any())
    return DEEPER if made or not np.isfinite(gained) else max(DEEPER, BESIDES * gained)


@pytest.mark.slow
@settings(max_examples=15, deadline=None)
@given(seeds, st.sampled_from([1e-6, 0.1, 10.0]))
def test_motion_is_allowed_only_if_it_relieves_contacts_and_makes_none(seed: int, pace: float) -> None:
    rng = np.random.default_rng(seed)
    made, layout = scene(rng)
    watch, now = ClearanceMonitor(layout), poses(rng)
    counts = layout.carried(CHAIN)
    watch.update(now)
    found = watch.found.copy()
    here = clearances(made, layout, now)
    for _ in range(3):
        then = arm_moved(rng, now, pace)
        losses = np.where(counts == 1, lost_clearance(here, clearances(made, layout, then)), -np.inf)
        if abs(losses.max() - 1e-12) > 5e-13:
            which = worst_new_contact(watch, counts, then)
            assert (which < 0) == (losses.max() < 1e-12)
            if which >= 0:
                assert losses[which] == pytest.approx(losses.max(), abs=2e-12)
            gained, slid = gained_clearance(made, layout, counts, now, then)
            kept = losses.max() <= lost_at_most(here, clearances(made, layout, then), gained)
            assert relieves(watch, counts, then) == (kept and gained >= max(RELIEF * slid, LEAST_RELIEF))
    assert relieves(watch, counts, now) == (not (here[counts == 1] <= CONTACT).any())
    assert np.array_equal(watch.found, found)


@pytest.mark.slow
@settings(max_examples=8, deadline=None)
@given(seeds)
def test_inhibited_arm_never_deepens_a_contact(seed: int) -> None:
    rng = np.random.default_rng(seed)
    made, layout = scene(rng)
    watch, now = ClearanceMonitor(layout), poses(rng)
    counts = layout.carried(CHAIN)
    watch.update(now)
    start = before = clearances(made, layout, now)
    assume((before[counts == 1] <= CONTACT).any())
    lost = 0.0
    for _ in range(25):
        then = arm_moved(rng, now, rng.choice([0.01, 1.0]))
        if relieves(watch, counts, then):
            watch.update(then)
            after = clearances(made, layout, then)
            most = lost_at_most(before, after, gained_clearance(made, layout, counts, now, then)[0])
            assert (after[before <= CONTACT] >= before[before <= CONTACT] - 2.0 * most).all()
            assert (after[before > CONTACT] > CONTACT).all()
            now, before, lost = then, after, lost + 2.0 * most
    assert (before[start <= CONTACT] >= start[start <= CONTACT] - lost).all()


def directions(frames: Array, step: float) -> Array:
    """Return the coordinate frames (12, F, 12) after each of 12 motions of frame 1.

    The motions are a rotation about, and a translation along, each of three axes, in both directions.
    """
    found = []
    for axis in range(6):
        for sign in (1.0, -1.0):
            twists = np.zeros((len(frames), 6))
            twists[1, axis] = sign
            if axis < 3:  # about its own origin
                twists[1, 3:] = -np.cross(twists[1, :3], frames[1, :3])
            found.append(moved(frames, twists, step))
    return np.array(found)


@pytest.mark.slow
@settings(max_examples=15, deadline=None)
@given(seeds, st.booleans())
def test_single_contact_always_has_an_escape_direction(seed: int, box: bool) -> None:
    rng = np.random.default_rng(seed)
    shapes = (boxes if box else skewed)(rng, 2)
    made = [Solid("palm", "hand", shapes[0]), Solid("wall", "orbiter", shapes[1])]
    layout = layout_of(("orbiter", "hand"), made, [("palm", "wall")])
    now = poses(rng)[[0, 2]]
    now[1, :3] = 0.2 * rng.normal(size=3) * np.ptp(shapes, axis=1).min()
    watch, counts = ClearanceMonitor(layout), np.ones(1, np.uint8)
    watch.update(now)
    assume(watch.found[0, CLEARANCE] <= CONTACT)
    step = 0.02
    for _ in range(400):
        clearance = watch.found[0, CLEARANCE]
        if clearance > CONTACT:
            break
        candidates = directions(now, step)
        gains = np.array([relief(trial_of(watch, counts, counts, after)) for after in candidates])
        best = int(gains.argmax())
        # any escape direction is within 55 deg of one of three perpendicular axes
        assert gains[best] >= step / sqrt(3.0) - 1e-12
        assert relieves(watch, counts, candidates[best])
        watch.update(candidates[best])
        now = candidates[best]
        assert watch.found[0, CLEARANCE] - clearance == pytest.approx(gains[best], abs=1e-12)
    assert watch.found[0, CLEARANCE] > CONTACT


def test_escape_direction_into_another_contact_is_rejected() -> None:
    cube = boxes(np.random.default_rng(0), 1)[0]
    cube = cube / np.ptp(cube, axis=0)
    made = [
        Solid("palm", "hand", cube),
        Solid("floor", "orbiter", cube * [9.0, 9.0, 1.0] + [0.0, 0.0, 0.9]),
        Solid("roof", "orbiter", cube * [9.0, 9.0, 1.0] - [0.0, 0.0, 1.01]),
    ]
    layout = layout_of(("orbiter", "hand"), made, [("palm", "floor"), ("palm", "roof")])
    watch, counts = ClearanceMonitor(layout), np.ones(2, np.uint8)
    now = np.zeros((2, 12))
    now[:, 3:] = np.eye(3).ravel()
    watch.update(now)
    up = now.copy()
    for height, free in ((0.005, True), (0.0101, False)):
        up[1, 2] = -height
        assert relieves(watch, counts, up) is free
        assert (relief(trial_of(watch, counts, counts, up)) > 0.0) == free
    watch.active[1] = 0
    watch.update(now)
    assert relieves(watch, counts, up)
