"""Mode 2 through the servos: deviation from the line, miss at the end, and settling, on long and loaded moves."""

from __future__ import annotations

import math

import numpy as np
import pytest

from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.run import Simulation
from benchmarks.plants import flight

pytestmark = pytest.mark.slow


@pytest.mark.parametrize("plant", ["rigid", "flexible"])
@pytest.mark.parametrize(("pounds", "off"), [(5_000, 0.06), (15_000, 0.08), (32_000, 0.11), (65_000, 0.125)])
def test_loaded_move_stays_near_its_line_and_settles(plant: str, pounds: int, off: float) -> None:
    row = flight("closed loop", pounds, plant)
    assert max(row.off) < off
    assert row.miss[0] < 2.5e-3  # by the encoders, inside the end sphere of 2 mm
    assert row.miss[1] < 0.025
    assert row.late < 75.0


@pytest.mark.parametrize(
    ("plant", "off", "miss", "turn"), [("rigid", 0.025, 0.005, 0.05), ("flexible", 0.05, 0.025, 0.2)]
)
def test_sts_400_move_stays_near_its_line(plant: str, off: float, miss: float, turn: float) -> None:
    sim, tips, goal = Simulation(load_scenario("sts-400-closed", {("plant",): plant})), [], None
    while not sim.ended:
        frame = sim.step()
        assert frame.dynamics is not None
        tips.append(frame.dynamics.position)
        if frame.goal is not None:
            goal, missed = frame.goal.position, frame.dynamics.miss
    assert goal is not None
    assert missed is not None
    places, end = np.array(tips), np.array(goal)
    along = (end - places[0]) / np.linalg.norm(end - places[0])
    away = places - places[0]
    assert np.linalg.norm(away - np.outer(away @ along, along), axis=1).max() < off
    assert missed[0] < miss
    assert math.degrees(missed[1]) < turn
