"""Contacts of a floating payload (the body) with the arm, the walls and other payloads.

The plant does not model forces. The impulse of such a contact is therefore unknown, and the contact does not move the
other part. The contact stops the body, or reflects it if the scenario's `free_contact` is "reflect". While a contact
stops a body with attitude control, the body keeps its attitude; afterwards it continues in its deadband. The body stops
just before the contact, so that its motion never inhibits the arm.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Mask
from aftdeck.law import law
from aftdeck.matrices import dots, product
from aftdeck.plant.state import PlantState
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.frame_poses import frames_with_prong_at
from aftdeck.simulation.log import Log
from aftdeck.simulation.parts.free_flight import Floating
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.worksite.conditions import quantity_text
from aftdeck.worksite.file.check import ARM
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor
from aftdeck.worksite.watch.contact_motion import looked_at, worst_new_contact
from aftdeck.worksite.watch.found import NORMAL, POINT_A, POINT_B
from aftdeck.worksite.watch.motion import motion

HALVINGS = 8
"""Number of bisections that find the time of a contact within a step.

The body stops before the contact, at a distance of at most 1/256 of the step's motion.
"""


def drifted(
    flight: Flight, worksite: WorksiteState, plant: PlantState, log: Log, k: int, floating: Floating
) -> Floating:
    """Return the free flight of a payload one control period later, stopped or reflected if the payload touches a part.

    If no part is near, `floating` itself is moved and returned.

    Args:
        flight: constants of the run.
        worksite: state of the worksite, in which everything else has already moved in this step.
        plant: state of the plant after its motion.
        log: log of the step.
        k: the payload.
        floating: the payload's free flight before this step.
    """
    site, period = flight.site, flight.scenario.control_period
    if not measured(worksite.watch.near, site.of_payload[k]):  # no part is near enough to touch in this step
        floating.move(period)
        floating.met = False
        return floating
    after = floating.moved(period)
    here = looked_at(worksite.watch, _frames(site, worksite, plant, k, floating))
    group = worst_new_contact(here, site.of_payload[k], _frames(site, worksite, plant, k, after))
    if group < 0:
        after.met = False
        return after
    return _stopped(flight, worksite, plant, log, k, floating, here, group)


@law
def measured(near: Mask, groups: Mask) -> bool:
    """Return whether any pair in `groups` (g,) has a measured clearance, and so a 1 in `near` (g,)."""
    found = False
    for g in range(len(groups)):
        found = found or (groups[g] != 0 and near[g] != 0)
    return found


def _frames(site: Site, worksite: WorksiteState, plant: PlantState, k: int, floating: Floating) -> Array:
    """Set payload k to the pose of a free flight, and return the poses of all frames in L, (F, 12)."""
    worksite.poses_in_carrier[k] = floating.pose
    return frames_with_prong_at(site, worksite, plant, worksite.prong.position)


def _stopped(
    flight: Flight, worksite: WorksiteState, plant: PlantState, log: Log, k: int, floating: Floating,
    here: ClearanceMonitor, group: int,
) -> Floating:  # fmt: skip
    """Return the free flight of payload k after the contact of pair `group` has stopped or reflected it.

    A contact that did not exist in the last step is logged.
    """
    site, period = flight.site, flight.scenario.control_period
    free, share = 0.0, 0.5
    for _ in range(0 if floating.met else HALVINGS):
        later = _frames(site, worksite, plant, k, floating.moved((free + share) * period))
        clear = worst_new_contact(here, site.of_payload[k], later) < 0
        free, share = free + share if clear else free, 0.5 * share
    stopped = floating.moved(free * period)
    first = site.layout.frames[site.layout.between_frames[group, 0]] == site.payloads[k].name
    row = here.found[group]
    normal = row[NORMAL : NORMAL + 3] if first else -row[NORMAL : NORMAL + 3]
    point = row[POINT_A : POINT_A + 3] if first else row[POINT_B : POINT_B + 3]
    frames = _frames(site, worksite, plant, k, floating)
    lever = point - frames[site.payload_rows[k], :3]
    other = int(site.layout.between_frames[group, 1 if first else 0])
    other_velocity = _velocity(site, worksite, site.layout.frames[other])
    surface = other_velocity + _of_arm(site, worksite, frames, other, point, period)
    approach, sweep = _closing(floating, surface, lever, normal)
    reflects = flight.scenario.free_contact == "reflect" and not floating.met
    if reflects:
        stopped.motion[3:] -= 2.0 * max(approach, 0.0) * normal
    else:
        stopped.motion[3:] = other_velocity
    if floating.cycle is None:
        stopped.motion[:3] *= 0.0 if not reflects else -1.0 if sweep > 0.0 else 1.0
    if not floating.met:
        own_part, other_part = site.layout.named(group) if first else reversed(site.layout.named(group))
        speed = quantity_text(approach + sweep, "m", flight.scenario.arm.model.units) + "/s"
        done = "is reflected" if reflects else "stops"
        text = f"{own_part} touches {other_part} at {speed} and {done}; impulse unknown"
        log.add("bump", "caution", text)
    stopped.met = True
    return stopped


def _velocity(site: Site, worksite: WorksiteState, frame: str) -> Array:
    """Return the velocity in space (3,) of the frame that a body touched, in L's axes [m/s].

    Parts of the arm count as moving with the orbiter, because a body that the arm stops does not move with the arm.
    """
    for k, payload in enumerate(site.payloads):
        if payload.name != frame:
            continue
        if (floating := worksite.floating[k]) is not None:
            return floating.motion[3:].copy()
        if worksite.payloads[k].berth and site.in_space(worksite.payloads[k].berth):
            return np.zeros(3)
    return np.zeros(3) if frame == "space" else product(site.axes, worksite.orbiter_velocity)


def _of_arm(site: Site, worksite: WorksiteState, frames: Array, frame: int, point: Array, period: float) -> Array:
    """Return the velocity in L (3,) of a point of a frame that the arm moves [m/s]; zeros for any other frame.

    Args:
        site: constants of the worksite.
        worksite: its state, with the frames before this step's motion of the arm.
        frames: (F, 12) poses of all frames in L after this motion.
        frame: row of the frame.
        point: (3,) the point, in L [m].
        period: control period [s].
    """
    name, held = site.layout.frames[frame], worksite.held
    if not name.startswith(ARM) and (held is None or name != site.payloads[held].name):
        return np.zeros(3)
    now = motion(worksite.frames[frame], frames[frame], period)
    turn = np.array([now.wx, now.wy, now.wz])
    return np.array([now.vx, now.vy, now.vz]) + np.cross(turn, point - frames[frame, :3])


def _closing(floating: Floating, other_velocity: Array, lever: Array, normal: Array) -> tuple[float, float]:
    """Return two terms of the closing speed at the contact: from the relative velocity, and from the rotation [m/s]."""
    turn = product(floating.pose[3:].reshape(3, 3), floating.motion[:3])
    return float(dots(floating.motion[3:] - other_velocity, normal)), float(dots(np.cross(turn, lever), normal))
