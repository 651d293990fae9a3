"""Grasp: the connection of a held payload to the end effector, and the steering with the payload.

This module begins a grasp at capture and ends it at release. After release, the payload floats.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, compose, relative
from aftdeck.kinematics.payload import PACKED, HeldPayload
from aftdeck.matrices import product
from aftdeck.plant.state import PlantState
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.log import Log
from aftdeck.simulation.parts.carried import SteeringSetup, steering_setup
from aftdeck.simulation.parts.free_flight import floating
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.payloads.hand_poses import payload_in_hand
from aftdeck.simulation.state import Panel, Script
from aftdeck.steering.mode import MODES
from aftdeck.worksite.capture.snare import RIGID, Snare
from aftdeck.worksite.watch.motion import motion

NEAR = 3.0
"""Greatest distance of a bar or a fixture from the end effector at which its capture can be the objective [m]."""


def attach(site: Site, worksite: WorksiteState, k: int) -> None:
    """Attach a payload to the frame of the last joint, in the payload's present pose (MO2SET)."""
    worksite.payloads[k].held, worksite.floating[k] = True, None
    reset_grasp(site, worksite, k)
    worksite.update_attachments(site)


def reset_grasp(site: Site, worksite: WorksiteState, k: int) -> None:
    """Set the pose of a held payload, in its grasp and in the steering, to the present pose.

    If the carriage draws the payload in, the payload moves from this pose. The carriage's full travel reduces the
    misalignment to zero; a part of this travel reduces it in proportion.
    """
    payload = worksite.payloads[k]
    payload.grasp = payload.steered = pose_in_hand(site, worksite.frames, k).tolist()
    grip = None if site.capture is None else site.capture.grip(worksite.frames, k)
    if grip is not None:
        payload.fixture_at_capture = grip.tolist()
        payload.drawn_at_capture = worksite.snare.drawn


def carried_by(scenario: Scenario, site: Site, worksite: WorksiteState, script: Script) -> SteeringSetup:
    """Return the steering's setup for the payload in the grasp, with the rate limits of the script's phase.

    `State.carried` has to be set to it after a change of `PayloadState.steered`, `Script.attached` or `Script.limits`.

    The steering uses the mass and the axes of a worksite payload. The payload's centre is the point of resolution.
    """
    payload = None
    for k, worksite_payload in enumerate(worksite.payloads):
        if worksite_payload.held:
            payload = _payload(site, k, np.array(worksite_payload.steered))
    if script.attached:
        payload = scenario.own_payloads[script.attached - 1]
    limits = scenario.phases[script.limits].limits if script.limits >= 0 else None
    return steering_setup(scenario, payload, limits)


def set_effector(flight: Flight, worksite: WorksiteState, *, holding: bool) -> None:
    """Set the end effector to its state with a payload (prong closed, or snares rigid), or without a payload."""
    if flight.site.prong:
        worksite.prong.position = flight.prong.high if holding else flight.prong.low
    else:
        worksite.snare = RIGID if holding else Snare()


def packed_in_grasp(site: Site, worksite: WorksiteState, carried: HeldPayload | None) -> Array | None:
    """Return the payload in the grasp, in the form of `HeldPayload.packed`; None if the grasp is empty.

    The pose is the present pose, because carriage and latches move a worksite payload relative to the end effector.
    `carried` is the payload that the steering uses.
    """
    k = worksite.held
    if k is None:
        return None if carried is None else carried.packed
    packed = np.empty(PACKED)
    payload_in_hand(worksite.frames, site.last_joint, site.payload_rows[k], site.hand, packed)
    return packed


def _payload(site: Site, k: int, grasp: Array) -> HeldPayload:
    """Return payload k in the grasp; `grasp` (12,) is its pose in the frame of the last joint."""
    inside = np.empty(POSE)
    relative(site.hand, grasp, inside)
    rotation = inside[3:].reshape(3, 3).copy()
    payload = site.payloads[k]
    return HeldPayload(
        payload.mass,
        rotation,
        product(rotation.T, inside[:3]),
        np.zeros(3),
        inertia=payload.inertia,
        centre_of_mass=payload.centre_of_mass,
    )


def pose_in_hand(site: Site, frames: Array, k: int) -> Array:
    """Return a payload's pose (12,) in the frame of the last joint; `frames` (F, 12): poses of all frames in L."""
    grasp = np.empty(POSE)
    relative(frames[site.last_joint], frames[site.payload_rows[k]], grasp)
    return grasp


def empty_grasp(site: Site, worksite: WorksiteState, panel: Panel, log: Log, k: int) -> None:
    """End the grasp of payload k. If the present mode moves a payload, select ORB UNL."""
    payload = worksite.payloads[k]
    payload.held, payload.grasp, payload.fixture_at_capture, payload.steered, payload.drawn_at_capture = (
        False,
        None,
        None,
        None,
        0.0,
    )
    if MODES[panel.mode].loaded:
        panel.mode, panel.rate_hold_sticks, panel.position_hold_target, panel.sequence = "ORB UNL", None, None, "idle"
        log.add("mode", "info", "ORB UNL entered: the grasp is now empty")
    worksite.update_attachments(site)


def start_free_flight(flight: Flight, worksite: WorksiteState, plant: PlantState, k: int, *, from_space: bool) -> None:
    """Start the free flight of a released payload, with its present motion and its attitude control.

    If the payload was fixed in space (`from_space`), its velocity is zero. Otherwise, it keeps its velocity, which
    includes the orbiter's velocity.
    """
    site = flight.site
    row = site.payload_rows[k]
    now = motion(worksite.before[row], worksite.frames[row], flight.scenario.control_period)
    pose = worksite.frames[row].copy()
    pose[:3] += site.scene[:3] - worksite.frames[site.space_row, :3]
    if plant.bodies is not None:
        compose(plant.base, worksite.frames[row], pose)
    turn = product(pose[3:].reshape(3, 3).T, np.array([now.wx, now.wy, now.wz]))
    velocity = np.array([now.vx, now.vy, now.vz]) + product(site.axes, worksite.orbiter_velocity)
    if from_space:
        velocity[:] = 0.0
    worksite.floating[k] = floating(pose, velocity, turn, site.payloads[k].limit_cycle)
    worksite.update_attachments(site)
