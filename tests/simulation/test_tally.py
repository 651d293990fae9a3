"""Least clearance of a run, in its summary."""

from __future__ import annotations

import math

import numpy as np
import pytest

from aftdeck.simulation.run import Simulation
from aftdeck.simulation.summary import Tally
from aftdeck.worksite.watch.found import CLEARANCE
from tests.loaded import scenario


@pytest.mark.parametrize("name", ["srms-berth", "concept-1972", "free-flyer"])
def test_least_clearance_counts_every_pair_that_is_the_nearest_in_a_step(name: str) -> None:
    sim = Simulation(scenario(name))
    sim.advance()
    worksite, rng = sim._state.worksite, np.random.default_rng(1)
    pairs = len(worksite.watch.found)
    tally, least = Tally(), math.inf
    for nearest in [-1, *rng.permutation(pairs).tolist(), -1]:
        worksite.nearest = nearest
        if nearest >= 0:
            worksite.watch.found[nearest, CLEARANCE] = clearance = rng.uniform(0.0, 1.0)
            least = min(least, clearance)
        tally.take(sim._state, b"")
        assert tally.least == least
    first = Tally()
    worksite.nearest = 0
    first.take(sim._state, b"")
    assert first.least == worksite.watch.found[0, CLEARANCE]
