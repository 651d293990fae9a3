"""The clearance monitor's results, compared with a separate computation for each pair of solids."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from aftdeck.arrays import Array
from aftdeck.bodies.pair import CONTACT
from aftdeck.worksite.watch.approach import approach
from aftdeck.worksite.watch.clearance_monitor import FAR, ClearanceMonitor
from aftdeck.worksite.watch.found import CLEARANCE, DISTANCE, NORMAL, POINT_A, POINT_B, WHICH
from tests.each import number
from tests.worksite.scenes import clearances, moved, placed, poses, scene

PERIOD = 0.02
seeds = st.integers(0, 2**32 - 1)


def drift(rng: np.random.Generator, pace: float = 1.0) -> Array:
    """Return random twists (5, 6); the orbiter's is zero."""
    twists = pace * rng.normal(size=(5, 6))
    twists[0] = 0.0
    return twists


def approaches(watch: ClearanceMonitor, before: Array, now: Array) -> Array:
    """Return the speed (g,) at which the closest points of each group approach each other [m/s]."""
    layout = watch.layout
    return np.array(
        [approach(watch.found, g, layout.pairs, layout.frame, before, now, PERIOD) for g in range(len(watch.found))]
    )


@settings(max_examples=number(4, 40), deadline=None)
@given(seeds)
def test_pair_clearance_is_that_of_its_nearest_solids(seed: int) -> None:
    rng = np.random.default_rng(seed)
    made, layout = scene(rng)
    watch, before, twists = ClearanceMonitor(layout), poses(rng), drift(rng, 5.0)
    for step in range(4):
        # a jump at step 2, after which the cache is useless
        now = poses(rng, 1.0) if step == 2 else moved(before, twists, PERIOD)
        watch.update(now)
        expected = clearances(made, layout, now)
        assert watch.found[:, CLEARANCE] == pytest.approx(expected, abs=1e-12)
        for g, row in enumerate(watch.found):
            i, j = layout.pairs[int(row[WHICH])]
            assert (made[i].part, made[j].part) == layout.named(g)
            a, b = placed(made[i], now), placed(made[j], now)
            way = row[POINT_B : POINT_B + 3] - row[POINT_A : POINT_A + 3]
            normal = row[NORMAL : NORMAL + 3]
            assert np.linalg.norm(normal) == pytest.approx(1.0, abs=1e-12)
            assert way == pytest.approx(expected[g] * normal, abs=1e-9)
            # along the normal, the gap or the overlap equals the clearance
            assert (b @ normal).min() - (a @ normal).max() == pytest.approx(expected[g], abs=1e-9)
            if expected[g] > CONTACT:
                assert (a @ normal).max() < row[DISTANCE] < (b @ normal).min()
            else:
                halfway = 0.5 * ((a @ normal).max() + (b @ normal).min())
                assert row[DISTANCE] == pytest.approx(halfway, abs=1e-9)
        before = now


@pytest.mark.slow
@settings(max_examples=12, deadline=None)
@given(seeds)
def test_closing_speed_is_the_rate_of_decrease_of_clearance(seed: int) -> None:
    rng = np.random.default_rng(seed)
    made, layout = scene(rng)
    now, twists, instant = poses(rng), drift(rng), 1e-5
    watch = ClearanceMonitor(layout)
    watch.update(now)
    speeds = approaches(watch, moved(now, twists, -PERIOD), now)
    here = clearances(made, layout, now)
    fall = (here - clearances(made, layout, moved(now, twists, instant))) / instant
    fell = (clearances(made, layout, moved(now, twists, -instant)) - here) / instant
    smooth = np.abs(fall - fell) < 1e-3
    assume(smooth.sum() > len(smooth) // 2)
    assert speeds[smooth] == pytest.approx(0.5 * (fall + fell)[smooth], abs=2e-3)
    assert np.median(np.abs(speeds[smooth] - 0.5 * (fall + fell)[smooth])) < 1e-7


def test_stationary_bodies_have_zero_closing_speed() -> None:
    rng = np.random.default_rng(5)
    _, layout = scene(rng)
    watch, now = ClearanceMonitor(layout), poses(rng)
    watch.update(now)
    assert not approaches(watch, now, now).any()


@settings(max_examples=10, deadline=None)
@given(seeds)
def test_inactive_pair_is_not_computed_and_changes_no_other_pair(seed: int) -> None:
    rng = np.random.default_rng(seed)
    _, layout = scene(rng)
    whole, part, now, twists = ClearanceMonitor(layout), ClearanceMonitor(layout), poses(rng), drift(rng)
    part.active[:] = rng.integers(0, 2, len(part.active))
    for _ in range(3):
        before, now = now, moved(now, twists, PERIOD)
        whole.update(now)
        part.update(now)
    counts = part.active == 1
    assert np.array_equal(part.found[counts], whole.found[counts])
    assert np.isinf(part.found[~counts, CLEARANCE]).all()
    part.active[:] = 1
    part.update(now)
    assert part.found[:, CLEARANCE] == pytest.approx(whole.found[:, CLEARANCE], abs=1e-12)
    assert approaches(part, before, now) == pytest.approx(approaches(whole, before, now), abs=1e-6)


@settings(max_examples=10, deadline=None)
@given(seeds, st.sampled_from([0.3, 2.0, np.inf]))
def test_monitor_without_cache_gives_bit_identical_results(seed: int, within: float) -> None:
    rng = np.random.default_rng(seed)
    _, layout = scene(rng)
    watch, forgetful, now = ClearanceMonitor(layout), ClearanceMonitor(layout), poses(rng)
    twists, active = drift(rng, 3.0), rng.integers(0, 8, len(watch.active)) > 0
    counts = rng.integers(0, 2, len(watch.active)).astype(np.uint8)
    for step in range(8):
        # without motion, parallel faces stay parallel, and many points are equally close
        now = moved(now, twists, PERIOD) if step % 3 else now
        forgetful.forget()
        for one in (watch, forgetful):
            one.active[:] = active
            one.look_near(now, counts, within)
        assert watch.found.tobytes() == forgetful.found.tobytes()
        assert watch.placed.tobytes() == forgetful.placed.tobytes()


@settings(max_examples=10, deadline=None)
@given(seeds, st.sampled_from([0.3, 2.0]), st.sampled_from([0.02, 0.5]), st.sampled_from([0.3, 30.0]))
def test_list_of_small_bounds_leaves_out_no_group_that_matters(
    seed: int, within: float, share: float, speed: float
) -> None:
    rng = np.random.default_rng(seed)
    _, layout = scene(rng)
    watch, forgetful, now = ClearanceMonitor(layout), ClearanceMonitor(layout), poses(rng)
    groups, lists, farthest = len(watch.active), 0, 0.0
    counts, twists = np.ones(groups, np.uint8), drift(rng, speed)
    for step in range(150):
        if step % 25 == 0:
            twists = drift(rng, speed)
        twists = -twists  # to and fro: the motions add up, and the parts stay where they are
        if rng.random() < 0.05:
            counts = (rng.random(groups) < share).astype(np.uint8)
        if rng.random() < 0.05:
            watch.active[:] = forgetful.active[:] = rng.random(groups) < 0.9
        now = moved(now, twists, PERIOD)
        forgetful.forget()
        for one in (watch, forgetful):
            one.look_near(now, counts, within)
        lists += watch.listed[-1] < forgetful.active.sum()
        assert watch.found.tobytes() == forgetful.found.tobytes()
        bounds = watch.bound - (watch.moved[layout.between_frames] @ (1.0, 1.0))
        near = forgetful.near != 0
        assert (bounds[near] <= forgetful.found[near, CLEARANCE]).all()
        farthest = max(farthest, float(watch.moved.max()))
    assert lists > 0
    assert farthest <= FAR and (speed < 30.0 or farthest > 0.5 * FAR)


def test_nearest_pair_is_the_closest_of_the_selected_pairs() -> None:
    rng = np.random.default_rng(6)
    _, layout = scene(rng)
    watch, now = ClearanceMonitor(layout), poses(rng)
    watch.update(now)
    counts = np.ones(len(layout.groups), np.uint8)
    for expected in np.argsort(watch.found[:, CLEARANCE]):
        assert watch.nearest(counts) == expected
        counts[expected] = 0
    assert watch.nearest(counts) == -1
    watch.active[:] = 0
    watch.update(now)
    assert watch.nearest(counts + 1) == -1
