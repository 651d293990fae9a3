"""Torques of motors and brakes at the end of each step, beside those of a run with shorter steps of MuJoCo."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.plant.multibody import plant as multibody
from aftdeck.plant.multibody import servo
from aftdeck.plant.multibody.build import STEP
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from tests.plant.multibody.test_payloads import BOTH

FINE = STEP / 32.0
"""Step of MuJoCo in the run beside [s]."""
FINEST = 2e-6
"""The same while brakes slip or seize [s]."""
WITHIN = 0.05
"""Greatest difference, as a share of the greatest torque of the motor or brake [1]."""
STICKS = Inputs(mode="ORB UNL", translation=(1.0, 0.0, -1.0), rotation=(1.0, 1.0, 1.0))
STRAIGHT = Inputs(mode="ORB UNL", translation=(1.0, 0.0, -1.0))
PITCHING = Inputs(mode="ORB UNL", rotation=(0.0, 1.0, 0.0))


def differences(sim: Simulation, fine: Simulation, given: Sequence[Inputs | None]) -> Array:
    """Return the differences of the torques as shares of their limits (steps, 6); both runs begin each step alike."""
    found, limits = [], sim.scenario.arm.model.servo
    assert limits is not None
    for inputs in given:
        fine.restore(sim.save())
        frame, other = sim.step(inputs), fine.step(inputs)
        assert frame.dynamics is not None and other.dynamics is not None
        most = limits.holding_torque if frame.brakes else limits.torque_limit
        found.append((np.array(frame.dynamics.torques) - other.dynamics.torques) / most)
    return np.array(found)


def from_start(
    name: str, plant: str, period: float, given: Sequence[Inputs | None], monkeypatch: pytest.MonkeyPatch
) -> Array:
    """Return the differences of a scenario's torques from its beginning."""
    scenario = aftdeck.load_scenario(name, {("plant",): plant, ("control_period",): period})
    sim = Simulation(scenario)
    monkeypatch.setattr(multibody, "STEP", FINE)
    return differences(sim, Simulation(scenario), given)


@BOTH
def test_torques_are_those_of_a_finer_run_while_the_sticks_move(plant: str, monkeypatch: pytest.MonkeyPatch) -> None:
    given = [*[STICKS] * 30, *[Inputs(mode="ORB UNL")] * 30]
    assert np.abs(from_start("first-flight", plant, 0.08, given, monkeypatch)).max() < WITHIN


@BOTH
@pytest.mark.parametrize("sticks", [STRAIGHT, STICKS, PITCHING], ids=["straight", "all", "pitching"])
def test_torques_of_brakes_are_those_of_a_finer_run(
    plant: str, sticks: Inputs, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The brakes are set in full motion; when they seize, their torques fall within a millisecond."""
    scenario = aftdeck.load_scenario("first-flight", {("plant",): plant, ("control_period",): 0.02})
    sim = Simulation(scenario)
    for _ in range(100):
        sim.step(sticks)
    for module, name in ((multibody, "STEP"), (servo, "FINE"), (servo, "FINEST")):
        monkeypatch.setattr(module, name, FINEST)
    found = differences(sim, Simulation(scenario), [Inputs(mode="ORB UNL", brakes=True)] * 10)
    assert np.abs(found).max() < WITHIN


@pytest.mark.slow
def test_torques_of_an_automatic_motion_are_those_of_a_finer_run(monkeypatch: pytest.MonkeyPatch) -> None:
    found = from_start("sts-400-closed", "flexible", 0.02, [None] * 400, monkeypatch)
    assert np.abs(found).max() < WITHIN
