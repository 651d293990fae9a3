"""Thinning of strips keeps ends, extremes and gaps."""

from __future__ import annotations

import itertools
import math

import msgspec
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from aftdeck.report.strips import BUCKETS, curve_values, sources, thin
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.readings.motion import worst_rate
from aftdeck.simulation.run import Simulation
from aftdeck.tuples import Six

VALUES = st.one_of(st.floats(-1e6, 1e6), st.just(math.nan))


@given(arrays(np.float64, st.integers(1, 60), elements=VALUES))
def test_short_curve_loses_only_points_between_equal_values(values: np.ndarray) -> None:
    kept = thin(values)
    assert (kept[0], kept[-1]) == (0, len(values) - 1)
    assert (np.diff(kept) > 0).all()
    for before, after in itertools.pairwise(kept.tolist()):
        dropped = values[before + 1 : after]
        assert np.array_equal(dropped, np.full(len(dropped), values[before]), equal_nan=True)


@given(st.integers(0, 2**32 - 1), st.integers(1, 20_000))
def test_long_curve_keeps_its_ends_and_the_extremes_of_every_part(seed: int, length: int) -> None:
    values = np.random.default_rng(seed).normal(size=length).cumsum()
    kept = thin(values)
    assert len(kept) <= 2 * BUCKETS + 2
    width = -(-length // BUCKETS)
    for start in range(0, length, max(width, length // 20 // width * width)):
        part = values[start : start + width]
        drawn = values[kept[(kept >= start) & (kept < start + width)]]
        if part.min() < part.max():
            assert (drawn.min(), drawn.max()) == (part.min(), part.max())


def test_gap_keeps_both_edges() -> None:
    values = np.ones(10_000)
    values[3001:4007] = math.nan
    kept = thin(values).tolist()
    assert {3000, 3001, 4006, 4007} <= set(kept)
    assert all(np.isnan(values[i]) == (3001 <= i < 4007) for i in kept)


def test_worst_rate_is_that_of_the_joint_nearest_to_its_limit() -> None:
    limits: Six = (0.1, 0.1, 0.1, 0.2, 0.2, 0.4)
    assert worst_rate((0.05, 0.0, -0.06, 0.1, 0.0, -0.28), limits) == (-0.28 / -0.4, 5)
    assert worst_rate((0.0,) * 6, limits) == (0.0, -1)


@pytest.mark.parametrize("brakes", [False, True])
def test_joint_torque_is_a_part_of_the_limit_of_what_acts(brakes: bool) -> None:
    scenario = load_scenario("first-flight", {("plant",): "rigid"})
    frame, servo = Simulation(scenario).look(), scenario.arm.model.servo
    assert frame.dynamics is not None
    assert servo is not None
    limits = (servo.holding_torque if brakes else servo.torque_limit).tolist()
    torques: Six = (0.1 * limits[0], 0.0, -0.6 * limits[2], 0.2 * limits[3], 0.0, 0.5 * limits[5])
    dynamics = msgspec.structs.replace(frame.dynamics, torques=torques)
    values = iter(curve_values(scenario)(msgspec.structs.replace(frame, brakes=brakes, dynamics=dynamics), None))
    shown = {source.blank.name: [next(values) for _ in source.curves] for source in sources(scenario)}
    assert shown["Joint torque"] == [pytest.approx(0.6)]
