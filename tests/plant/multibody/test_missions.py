"""Built-in missions on plants with masses: each script reaches its end."""

from __future__ import annotations

import pytest

from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.run import Simulation
from benchmarks.flight_tests import TESTS
from tests.loaded import arm_name, names_with

SCRIPTED = [name for name in names_with("phase") if name not in TESTS]
"""Built-in scenarios with a script, except the flight tests (`test_flight_tests`)."""
MISSIONS = [(name, "rigid") for name in SCRIPTED] + [
    (name, "flexible") for name in SCRIPTED if arm_name(name) == "srms"
]
SHORTER = {("srms-deploy", "rigid"), ("srms-deploy", "flexible"), ("concept-1972-script", "rigid")}
"""Missions that CI flies: a capture, a release and a docking."""


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "plant"),
    [pytest.param(*one, marks=() if one in SHORTER else pytest.mark.long) for one in MISSIONS],
)
def test_mission_reaches_the_end_of_its_script(name: str, plant: str) -> None:
    sim, lines = Simulation(load_scenario(name, {("plant",): plant})), []
    while not sim.ended:
        sim.advance()
        lines += [event.text for event in sim._state.events]
    assert sim.ended == "completed", lines[-8:]
    if any("acquired" in text for text in lines):
        assert any("holds" in text and "greatest force" in text for text in lines)
