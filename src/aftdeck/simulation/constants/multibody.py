"""Plant with masses of a run, made from the scenario. This module imports MuJoCo."""

from __future__ import annotations

from typing import Any

import numpy as np

from aftdeck.bodies.hexahedron import unpack
from aftdeck.bodies.pose import pose_of
from aftdeck.frames import Pose
from aftdeck.kinematics.payload import HeldPayload
from aftdeck.plant.linear_actuator import travel_of_stand
from aftdeck.plant.multibody.build import arm_spec, attach
from aftdeck.plant.multibody.contacts import add_solids
from aftdeck.plant.multibody.jets import Thrusters
from aftdeck.plant.multibody.plant import MultibodyPlant
from aftdeck.plant.plant import LEAST_PULSE
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.constants.site import Site


def multibody_plant(scenario: Scenario, site: Site, *, gauged: bool = False) -> MultibodyPlant:
    """Return the plant of a scenario with the plant ``rigid`` or ``flexible``; `scenario.build` has checked it."""
    arm = scenario.arm.model
    models = [
        (_compiled(scenario, site, payload, solids=False), _compiled(scenario, site, payload, solids=True))
        for payload in (None, *scenario.own_payloads)
    ]
    return MultibodyPlant(
        models,
        arm,
        travel_of_stand(arm),
        scenario.control_period,
        thrusters=_thrusters(scenario, site),
        gauged=gauged,
    )


def _thrusters(scenario: Scenario, site: Site) -> Thrusters | None:
    """Return the orbiter's jets; None if the orbiter is fixed."""
    orbiter, rule = scenario.worksite.orbiter, scenario.worksite.translation
    if scenario.orbiter == "fixed" or orbiter is None:
        return None
    force = 0.0 if rule is None else orbiter.mass * rule.speed / rule.reached_in
    jets = orbiter.jets
    if scenario.orbiter == "free" or jets is None:
        return Thrusters(site.axes, np.zeros(3), LEAST_PULSE, 0.0, 0.0, force)
    return Thrusters(site.axes, np.array(jets.torque), jets.least_pulse, jets.angle, jets.rate, force)


def _compiled(scenario: Scenario, site: Site, payload: HeldPayload | None, *, solids: bool) -> Any:
    """Return the compiled model with one payload of the scenario, or without."""
    arm = scenario.arm.model
    mass = scenario.worksite.orbiter
    orbiter = mass.in_l(arm.mount) if scenario.orbiter != "fixed" and mass is not None else None
    payloads = [one.properties for one in scenario.payloads]
    spec = arm_spec(arm, flexible=scenario.plant == "flexible", orbiter=orbiter, payloads=payloads)
    if payload is not None:
        attach(spec, payload.properties)
    if solids:
        _add_solids(spec, site)
    return spec.compile()


def _add_solids(spec: Any, site: Site) -> None:
    """Add the solids of the arm, of the worksite and of its payloads, each in the body of its frame."""
    layout, here, scene = site.layout, Pose(np.zeros(3), np.eye(3)), pose_of(site.scene)
    homes = {name: (spec.body(name), here) for name in site.arm.names}
    homes["orbiter"] = spec.body("orbiter") or spec.worldbody, scene
    homes["space"] = spec.worldbody, scene
    homes |= {payload.name: (spec.body(f"cargo.{k}"), here) for k, payload in enumerate(site.payloads)}
    frames = [layout.frames[frame] for frame in layout.frame.tolist()]
    add_solids(spec, [unpack(solid) for solid in layout.solids], frames, homes)
