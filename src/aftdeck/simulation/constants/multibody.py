"""Plant with masses of a run, made from the scenario. This module imports MuJoCo."""

from __future__ import annotations

from typing import Any

import numpy as np

from aftdeck.arms.load import ArmModel
from aftdeck.bodies.mass_properties import MassProperties
from aftdeck.frames import Mount
from aftdeck.kinematics.payload import Payload
from aftdeck.plant.linear_actuator import travel_of_stand
from aftdeck.plant.multibody.build import arm_spec, attach, in_tip_frame
from aftdeck.plant.multibody.plant import MultibodyPlant
from aftdeck.scenario.model import Scenario
from aftdeck.worksite.model import OrbiterMass


def multibody_plant(scenario: Scenario) -> MultibodyPlant:
    """Return the plant of a scenario with the plant ``rigid`` or ``flexible``; `scenario.build` has checked it."""
    arm = scenario.arm.model
    models = [_compiled(scenario, arm, payload) for payload in (None, *scenario.own_payloads)]
    return MultibodyPlant(models, arm, travel_of_stand(arm), scenario.control_period, strict=scenario.strict)


def _compiled(scenario: Scenario, arm: ArmModel, payload: Payload | None) -> Any:
    mass = scenario.worksite.orbiter
    orbiter = orbiter_in_l(arm.mount, mass) if scenario.free_orbiter and mass is not None else None
    payloads = [MassProperties(one.mass, np.zeros(3), np.diag(one.inertia)) for one in scenario.cargo]
    spec = arm_spec(arm, flexible=scenario.plant == "flexible", orbiter=orbiter, payloads=payloads)
    if payload is not None:
        centre = payload.rotation @ payload.centre
        attach(spec, in_tip_frame(payload.mass, centre, payload.rotation, payload.inertia))
    return spec.compile()


def orbiter_in_l(mount: Mount, orbiter: OrbiterMass) -> MassProperties:
    """Return the orbiter's mass properties in L."""
    x, y, z = orbiter.centre
    centre = mount.rotation.T @ (np.array([-x, y, -z]) - mount.origin)
    return MassProperties(orbiter.mass, centre, mount.rotation.T @ np.diag(orbiter.inertia) @ mount.rotation)
