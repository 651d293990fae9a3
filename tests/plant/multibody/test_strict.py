"""Steering as published (`strict`) on plants with masses: it moves a heavy payload."""

from __future__ import annotations

import numpy as np
import pytest

from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from tests.plant.multibody.flights import move, scenario

HEAVY = 32_000.0
"""Mass of the payload [lb]."""


def moved(plant: str, mode: str, *, strict: bool) -> float:
    """Return the distance of the tip from its first place after a push of 40 s [m]."""
    sim = Simulation(scenario(plant, pounds=HEAVY, head=f"strict = {str(strict).lower()}"))
    start = np.array(sim.step(Inputs(mode=mode)).position)
    for _ in range(2000):
        sim.advance(Inputs(translation=(1.0, 0.0, 0.0)))
    return float(np.linalg.norm(np.array(sim.look().position) - start))


@pytest.mark.slow
@pytest.mark.parametrize("mode", ["ORB LD", "END EFF"])
@pytest.mark.parametrize("plant", ["rigid", "flexible"])
def test_strict_steering_moves_a_heavy_payload_like_the_corrected_one(plant: str, mode: str) -> None:
    assert moved(plant, mode, strict=True) == pytest.approx(moved(plant, mode, strict=False), rel=0.1)


@pytest.mark.slow
def test_strict_mode_2_brings_a_heavy_payload_to_its_target() -> None:
    given = scenario("rigid", move((1.0, 0.0, 0.0)), pounds=HEAVY, head="strict = true")
    sim = Simulation(given)
    target = np.array(sim.step().position) + np.array((1.0, 0.0, 0.0))
    for _ in range(5000):
        sim.advance()
    assert np.linalg.norm(np.array(sim.look().position) - target) < 0.01


def test_strict_steering_starts_a_heavy_payload() -> None:
    sim = Simulation(scenario("rigid", pounds=HEAVY, head="strict = true"))
    for _ in range(500):
        sim.advance(Inputs(mode="ORB LD", translation=(1.0, 0.0, 0.0)))
    speed, _ = sim.look().por_limits
    assert np.linalg.norm(sim.look().twist[3:]) > 0.2 * speed
