"""Whole runs with random sticks, switches and starting poses: invariants of every step."""

from __future__ import annotations

import math

import pytest

import aftdeck
from tests.each import each, seeds
from tests.steering.flying import kinds, scenario
from tests.steering.random_runs import flight


@pytest.mark.slow
@each("seed", seeds(60, 600))
def test_random_run_keeps_invariants(seed: int) -> None:
    flight(seed)


@pytest.mark.slow
@each("seed", seeds(6, 60, first=100))
def test_random_as_flown_run_keeps_invariants(seed: int) -> None:
    flight(seed, 'soft_stops = "as-flown"\n', mended=False)


@pytest.mark.slow
@each("seed", seeds(6, 60, first=200))
def test_random_strict_run_keeps_rates_and_hard_stops(seed: int) -> None:
    flight(seed, "strict = true\n", mended=False)


def test_held_stick_stops_before_a_singularity() -> None:
    for extra_joint, way in ((4, 1.0), (4, -1.0)):
        q = [0.0, 60.0, -80.0, 20.0, 60.0 * way, 0.0]
        sim = aftdeck.Simulation(scenario(q))
        seen = set()
        for _ in range(3000):
            frame = sim.step(aftdeck.Inputs(rotation=(0.0, 0.0, way), mode="END EFF"))
            seen |= kinds(frame)
        assert frame.singularity[2] > 0.0 and abs(frame.angles[extra_joint]) < math.pi / 2
        assert "singularity" in seen or "soft stop" in seen
