"""Scenarios in which a body can be disturbed, and the momentum of all bodies, for tests."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import mujoco
import numpy as np

from aftdeck.arrays import Array
from aftdeck.scenario.load import parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.run import Simulation
from tests import loaded
from tests.plant.multibody.flights import scenario
from tests.plant.multibody.points import cloud
from tests.plant.multibody.test_payloads import bodies_of

FAR = {"position": [0.0, 0.0, 25.0]}
"""Start of a free payload that touches nothing."""
KINDS = ("tip", "orbiter", "own payload", "worksite's payload")


def given(plant: str, kind: str, lines: str = "", *, period: float = 0.02, orbiter: str = "free") -> Scenario:
    """Return a scenario in which a body of some kind can be disturbed; the arm's servos only hold it."""
    head = f"control_period = {period}\n{lines}"
    if kind == "worksite's payload":
        points = cloud(1).toml()
        text = (
            f"title = 't'\nplant = '{plant}'\nduration = '60 s'\n{head}\n[dynamics]\norbiter = '{orbiter}'\n"
            f"[initial]\njoints = {loaded.scenario('loaded').initial_angles.tolist()}\n"
            f"[[cargo]]\nname = 'payload'\nstart = {{ position = {FAR['position']} }}\n{points}"
        )
        return parse_scenario(text, "disturbed", "disturbed.toml", Path())
    body = f"[payload]\n{cloud(1).toml()}" if kind == "own payload" else ""
    return scenario(plant, body, orbiter=orbiter, worksite="space", head=head)


def planned(on: str, begin: float, duration: float, **fields: object) -> str:
    """Return the value of a scenario's key `disturbance`."""
    table = {"on": on, "begin": begin, "duration": duration, **fields}
    return f"disturbance = [{{ {', '.join(f'{key} = {value!r}' for key, value in table.items())} }}]\n"


def name_of(kind: str) -> str:
    return "payload" if "payload" in kind else kind


def momentum(sim: Simulation) -> tuple[Array, Array, float]:
    """Return momentum [N s], angular momentum about space's origin [N m s] and energy [J] of all bodies."""
    plant: Any = sim._flight.plant
    view = plant._apart[sim._state.script.attached].view
    model, data = view.model, mujoco.MjData(view.model)
    mujoco.mj_setState(model, data, bodies_of(sim).physics, mujoco.mjtState.mjSTATE_INTEGRATION)
    mujoco.mj_forward(model, data)
    mujoco.mj_energyVel(model, data)
    linear, angular, velocity = np.zeros(3), np.zeros(3), np.zeros(6)
    for body in range(1, model.nbody):
        mujoco.mj_objectVelocity(model, data, mujoco.mjtObj.mjOBJ_BODY, body, velocity, 0)
        place, axes = data.xipos[body], data.ximat[body].reshape(3, 3)
        spin, own = velocity[:3], model.body_mass[body] * velocity[3:]  # of the centre of mass
        linear += own
        angular += np.cross(place, own) + axes @ np.diag(model.body_inertia[body]) @ axes.T @ spin
    return linear, angular, float(data.energy[1])
