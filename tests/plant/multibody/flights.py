"""Flights on plants with masses: scenarios of one motion, and the arm with servos without faults."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from aftdeck.arrays import Array
from aftdeck.frames import Pose
from aftdeck.kinematics.arm import Arm, load_arm
from aftdeck.scenario.load import parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.run import Simulation
from aftdeck.steering.mode import LawChoice
from benchmarks.empty_space import move_to

BAY = "joints = ['-31 deg', '79 deg', '-103 deg', '-77 deg', '17 deg', '-128 deg']"
"""Joint angles over the bay."""
AT_BAY = np.radians([-31.0, 79.0, -103.0, -77.0, 17.0, -128.0])


def scenario(
    plant: str,
    body: str = "",
    *,
    initial: str = BAY,
    pounds: float = 0.0,
    orbiter: str = "fixed",
    worksite: str = "",
    head: str = "",
) -> Scenario:
    """Return a scenario in empty space, or with an orbiter that moves; its payload's centre is at the tip."""
    payload = f"[payload]\nmass = '{pounds} lb'\n" if pounds else ""
    worksite = worksite or ("space" if orbiter == "fixed" else "orbiter")
    text = (
        f"title = 'a flight'\nworksite = '{worksite}'\nplant = '{plant}'\nduration = '600 s'\n{head}\n"
        f"[dynamics]\norbiter = '{orbiter}'\n[initial]\n{initial}\n{payload}{body}\n"
    )
    return parse_scenario(text, "flight", "flight.toml", Path())


def move(by: tuple[float, float, float], law: LawChoice = "closed loop") -> str:
    """Return a phase in OPR CMD that displaces the tip from `AT_BAY` [m]."""
    tip = load_arm("srms").forward(AT_BAY)
    return move_to(Pose(tip.position + np.array(by), tip.rotation), law)


def ideal(given: Scenario, gain: float = 100.0) -> Scenario:
    """Return a scenario whose servos are stiffer, have no torque limit and no friction, and measure exactly."""
    model = given.arm.model
    assert model.servo is not None
    servo = model.servo._replace(
        gain=gain * model.servo.gain,
        torque_limit=np.full(6, 1e12),
        friction=np.zeros(6),
        encoder_step=np.zeros(6),
        tachometer_step=np.zeros(6),
    )
    return replace(given, arm=Arm(replace(model, servo=servo)))


def flown(given: Scenario) -> tuple[Simulation, Array]:
    """Run a scenario to its end, and return the simulation and the true tip positions of all steps [m]."""
    sim, tips = Simulation(given), []
    while not sim.ended:
        frame = sim.step()
        tips.append(frame.position if frame.dynamics is None else frame.dynamics.position)
    return sim, np.array(tips)
