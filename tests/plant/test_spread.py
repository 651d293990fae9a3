"""Differences between motions with masses and their rehearsals, as CMD CK states them."""

from __future__ import annotations

from typing import Literal

import pytest

from aftdeck.plant.spread import spread_of
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.run import Simulation
from benchmarks.plants import LAWS, flight


@pytest.mark.slow
@pytest.mark.parametrize("plant", ["rigid", "flexible"])
@pytest.mark.parametrize("mode", LAWS)
@pytest.mark.parametrize("pounds", [0.0, 15_000.0])
def test_motion_stays_within_the_spread_of_its_rehearsal(
    mode: int, pounds: float, plant: Literal["rigid", "flexible"]
) -> None:
    law = LAWS[mode]
    spread = spread_of(plant, law, loaded=pounds > 0.0)
    rehearsed, found = flight(law, pounds, "kinematic"), flight(law, pounds, plant)
    assert found.time <= rehearsed.time * (1.0 + spread.longer) + spread.later + 0.1
    assert found.miss[1] <= spread.miss + 1e-3


def test_verdict_states_the_spread_on_plants_with_masses_only() -> None:
    verdicts = []
    for plant in ("kinematic", "rigid"):
        sim = Simulation(load_scenario("sts-400-closed", {("plant",): plant}))
        while sim.look().check is None:
            sim.advance()
        check = sim.look().check
        assert check is not None and check.good
        verdicts.append(check)
    assert verdicts[0].seconds == verdicts[1].seconds
    assert len(verdicts[1].text) > len(verdicts[0].text)
