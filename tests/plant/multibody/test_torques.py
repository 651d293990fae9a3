"""Torques of motors and brakes at the end of each step, beside those of a run with shorter steps of MuJoCo."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

import aftdeck
from aftdeck.plant.multibody import plant as multibody
from aftdeck.plant.multibody.build import STEP
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from tests.plant.multibody.test_payloads import BOTH

FINE = STEP / 32.0
"""Step of MuJoCo in the run beside [s]."""
WITHIN = 0.05
"""Greatest difference, as a share of the greatest torque of the motor or brake [1]."""
STICKS = Inputs(mode="ORB UNL", translation=(1.0, 0.0, -1.0), rotation=(1.0, 1.0, 1.0))
STRAIGHT = Inputs(mode="ORB UNL", translation=(1.0, 0.0, -1.0))


def differences(
    name: str,
    plant: str,
    period: float,
    steps: int,
    given: Callable[[int], Inputs | None],
    monkeypatch: pytest.MonkeyPatch,
) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """Return the differences of the torques as shares of their limits (steps, 6); both runs begin each step alike."""
    scenario = aftdeck.load_scenario(name, {("plant",): plant, ("control_period",): period})
    sim = Simulation(scenario)
    monkeypatch.setattr(multibody, "STEP", FINE)
    fine, found = Simulation(scenario), []
    servo = scenario.arm.model.servo
    assert servo is not None
    for k in range(steps):
        fine.restore(sim.save())
        frame, other = sim.step(given(k)), fine.step(given(k))
        assert frame.dynamics is not None and other.dynamics is not None
        limits = servo.holding_torque if frame.brakes else servo.torque_limit
        found.append((np.array(frame.dynamics.torques) - other.dynamics.torques) / limits)
    return np.array(found)


@BOTH
def test_torques_are_those_of_a_finer_run_while_the_sticks_move(plant: str, monkeypatch: pytest.MonkeyPatch) -> None:
    found = differences(
        "first-flight", plant, 0.08, 60, lambda k: STICKS if k < 30 else Inputs(mode="ORB UNL"), monkeypatch
    )
    assert np.abs(found).max() < WITHIN


@BOTH
def test_torques_of_brakes_are_those_of_a_finer_run(plant: str, monkeypatch: pytest.MonkeyPatch) -> None:
    found = differences(
        "first-flight",
        plant,
        0.02,
        180,
        lambda k: STRAIGHT if k < 100 else Inputs(mode="ORB UNL", brakes=True),
        monkeypatch,
    )
    assert np.abs(found).max() < WITHIN


@pytest.mark.slow
def test_torques_of_an_automatic_motion_are_those_of_a_finer_run(monkeypatch: pytest.MonkeyPatch) -> None:
    found = differences("sts-400-closed", "flexible", 0.02, 400, lambda _: None, monkeypatch)
    assert np.abs(found).max() < WITHIN
