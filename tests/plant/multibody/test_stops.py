"""Measured stops of an arm with masses, and the switches that a script operates."""

from __future__ import annotations

import math

import numpy as np
import pytest

from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from benchmarks.flight_tests import TESTS, stops
from tests.plant.multibody.flights import scenario

STEP = Inputs(mode="ORB UNL", translation=(0.6, -0.4, -0.7))


def stopped(plant: str, last: Inputs, pounds: float = 0.0) -> tuple[float, float, list[str], Simulation]:
    """Move for 5 s, then stop.

    Returns:
        Distance of the tip at rest from its place at the stop, and the greatest distance [m], from the frames; the log
        lines about the stop; the run.
    """
    sim, lines = Simulation(scenario(plant, pounds=pounds)), []
    for _ in range(250):
        frame = sim.step(STEP)
    tips = []
    for step in range(1500):
        frame = sim.step(last if step == 0 else Inputs())
        assert frame.dynamics is not None
        tips.append(frame.dynamics.position)
        lines += [event.text for event in frame.events if event.kind == "stop"]
        if lines:
            break
    return math.dist(tips[-1], tips[0]), max(math.dist(tip, tips[0]) for tip in tips), lines, sim


@pytest.mark.parametrize("last", [Inputs(), Inputs(brakes=True), Inputs(safing=True)])
def test_stop_is_logged_once_with_the_distances_of_the_true_tip(last: Inputs) -> None:
    away, greatest, lines, sim = stopped("rigid", last)
    assert len(lines) == 1
    numbers = [float(word) for word in lines[0].split() if word.replace(".", "").isdigit()]
    units = 0.0254 if " in" in lines[0] else 1e-3
    assert numbers[1] * units == pytest.approx(away, rel=0.02, abs=2e-4)
    assert numbers[2] * units == pytest.approx(greatest - away, rel=0.02, abs=2e-4)
    assert np.abs(sim._state.plant.rates).max() < 5e-3


def test_brakes_stop_the_arm_in_a_shorter_distance_than_the_end_of_the_command() -> None:
    assert stopped("rigid", Inputs(brakes=True))[1] < stopped("rigid", Inputs())[1]


def test_kinematic_arm_logs_no_stop() -> None:
    sim, kinds = Simulation(scenario("kinematic")), []
    for step in range(600):
        kinds += [event.kind for event in sim.step(STEP if step < 250 else Inputs()).events]
    assert "stop" not in kinds


def test_saved_run_continues_to_the_last_bit_during_a_stop() -> None:
    sim = Simulation(scenario("flexible"))
    for step in range(350):
        sim.step(STEP if step < 250 else Inputs())
    other = Simulation(sim.scenario)
    other.restore(sim.save())
    for _ in range(400):
        assert sim.step(Inputs()) == other.step(Inputs())
    assert sim.save() == other.save()


def test_script_operates_brakes_and_safing() -> None:
    step = "[[phase]]\nmode = 'ORB UNL'\ntranslation = [0.5, 0.0, -0.5]\nduration = '3 s'\n"
    body = step + "".join(
        f"[[phase]]\nmode = 'ORB UNL'\n{switch} = {on}\nduration = '1 s'\n"
        for switch in ("brakes", "safing")
        for on in ("true", "false")
    )
    sim, seen = Simulation(scenario("rigid", body)), []
    while not sim.ended:
        frame = sim.step()
        seen.append((frame.brakes, frame.safing))
    assert sim.ended == "completed"
    assert {(True, False), (False, True)} < set(seen)
    assert seen[-1] == (False, False)


@pytest.mark.slow
@pytest.mark.parametrize("name", TESTS)
def test_flight_test_measures_nine_stops(name: str) -> None:
    found = stops(name, "rigid")
    assert len(found) == 9
    assert len({step for step, _ in found}) == 9
    assert load_scenario(name).plant == "rigid"
