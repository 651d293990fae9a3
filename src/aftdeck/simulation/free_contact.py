"""Contacts of a payload that nothing holds: it meets the arm, the walls and other payloads, and goes through nothing.

Of forces this plant knows nothing, so the impulse of such a contact is unknown, and what the body meets is not moved.
The contact stops the body against what it met, or reflects it where the scenario says so (`free_contact`). A body with
attitude control holds its attitude until the way is free, and then goes on in its deadband. No contact is made by a
body's own motion, so it never inhibits the arm.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Mask
from aftdeck.law import law
from aftdeck.simulation.ahead import frames_with
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.floating import Floating
from aftdeck.simulation.log import log
from aftdeck.simulation.state import State
from aftdeck.worksite.check import ARM
from aftdeck.worksite.conditions import shown
from aftdeck.worksite.found import CLEARANCE, NORMAL, POINT_A, POINT_B
from aftdeck.worksite.motion import motion
from aftdeck.worksite.restrain import looked_at, worsened
from aftdeck.worksite.watch import Watch

HALVINGS = 8
"""How often the step in which a body meets something is halved: it stops within 1/256 of its way."""


def drifted(flight: Flight, state: State, k: int, floating: Floating) -> Floating:
    """Return the free flight of a cargo a control period later, stopped or reflected by what it meets.

    Where nothing is near it is the same object, moved on.

    Args:
        flight: what never changes.
        state: with all else moved in this step.
        k: the cargo.
        floating: its free flight until now.
    """
    period, things = flight.scenario.control_period, state.site
    if not measured(things.watch.found, flight.site.of_cargo[k]):  # nothing is as near as anything moves in a step
        floating.move(period)
        floating.met = False
        return floating
    after = floating.moved(period)
    here = looked_at(things.watch, _frames(flight, state, k, floating))
    group = _met(flight, state, k, here, after)
    if group < 0:
        after.met = False
        return after
    return _stopped(flight, state, k, floating, here, group)


@law
def measured(found: Array, groups: Mask) -> bool:
    """Return whether the clearance of one of these groups, (g,) 1, was near enough to be measured."""
    near = False
    for g in range(len(groups)):
        near = near or (groups[g] != 0 and found[g, CLEARANCE] < np.inf)
    return near


def _frames(flight: Flight, state: State, k: int, floating: Floating) -> Array:
    """(F, 12) where everything is in L, with cargo k there."""
    state.site.rides[k] = floating.pose
    return frames_with(flight, state, state.site.prong.position)


def _met(flight: Flight, state: State, k: int, here: Watch, after: Floating) -> int:
    """Return the group that a motion of cargo k brings into contact, or deepens; -1: none."""
    return worsened(here, flight.site.of_cargo[k], _frames(flight, state, k, after))


def _stopped(flight: Flight, state: State, k: int, floating: Floating, here: Watch, group: int) -> Floating:
    """The body as far on its way as it gets, at rest against what it met, or reflected by it."""
    period, site = flight.scenario.control_period, flight.site
    free, share = 0.0, 0.5
    for _ in range(0 if floating.met else HALVINGS):
        clear = _met(flight, state, k, here, floating.moved((free + share) * period)) < 0
        free, share = free + share if clear else free, 0.5 * share
    stopped = floating.moved(free * period)
    first = site.layout.frames[site.layout.between_frames[group, 0]] == site.cargo[k].name
    row = here.found[group]
    into = row[NORMAL : NORMAL + 3] if first else -row[NORMAL : NORMAL + 3]
    point = row[POINT_A : POINT_A + 3] if first else row[POINT_B : POINT_B + 3]
    frames = _frames(flight, state, k, floating)
    arm = point - frames[site.cargo_row(k), :3]
    other = int(site.layout.between_frames[group, 1 if first else 0])
    against = _velocity(flight, state, site.layout.frames[other])
    surface = against + _of_arm(flight, state, frames, other, point)
    straight, turning = _closing(floating, surface, arm, into)
    reflects = flight.scenario.free_contact == "reflect" and not floating.met
    if reflects:
        stopped.motion[3:] -= 2.0 * max(straight, 0.0) * into
    else:
        stopped.motion[3:] = against
    if floating.cycle is None:
        stopped.motion[:3] *= 0.0 if not reflects else -1.0 if turning > 0.0 else 1.0
    if not floating.met:
        what, whom = site.layout.named(group) if first else reversed(site.layout.named(group))
        speed = shown(straight + turning, "m", flight.scenario.arm.model.units) + "/s"
        done = "is reflected" if reflects else "stops"
        log(flight, state, "bump", "caution", f"{what} meets {whom} at {speed} and {done}; impulse unknown")
    stopped.met = True
    return stopped


def _velocity(flight: Flight, state: State, frame: str) -> Array:
    """(3,) how fast what a body met moves in space, in L's axes [m/s]; of the arm, that of the orbiter it stands on.

    A body that stops against a part of the arm is not carried along by it.
    """
    site, things = flight.site, state.site
    for k, one in enumerate(site.cargo):
        if one.name != frame:
            continue
        if (floating := things.floating[k]) is not None:
            return floating.motion[3:].copy()
        if things.cargo[k].seat and site.in_space(things.cargo[k].seat):
            return np.zeros(3)
    return np.zeros(3) if frame == "space" else site.axes @ things.orbiter_velocity


def _of_arm(flight: Flight, state: State, frames: Array, frame: int, point: Array) -> Array:
    """(3,) how fast a point of a frame moves in L [m/s] where the arm moves it; else 0."""
    name, held = flight.site.layout.frames[frame], state.site.held
    if not name.startswith(ARM) and (held is None or name != flight.site.cargo[held].name):
        return np.zeros(3)
    now = motion(state.site.frames[frame], frames[frame], flight.scenario.control_period)
    turn = np.array([now.wx, now.wy, now.wz])
    return np.array([now.vx, now.vy, now.vz]) + np.cross(turn, point - frames[frame, :3])


def _closing(floating: Floating, against: Array, arm: Array, into: Array) -> tuple[float, float]:
    """How fast a touching point goes into what it meets, by the body's velocity and by its turning [m/s]."""
    turn = floating.pose[3:].reshape(3, 3) @ floating.motion[:3]
    return float((floating.motion[3:] - against) @ into), float(np.cross(turn, arm) @ into)
