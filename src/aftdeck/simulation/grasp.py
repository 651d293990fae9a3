"""Holding a payload of the worksite and letting it go: where it is then, and how the arm is steered with it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from aftdeck.bodies.pose import POSE, compose, relative
from aftdeck.kinematics.payload import Payload
from aftdeck.simulation.carried import carrying
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.floating import floating
from aftdeck.simulation.log import log
from aftdeck.simulation.state import State
from aftdeck.steering.mode import MODES
from aftdeck.worksite.motion import motion

Array = NDArray[np.float64]


def take_hold(flight: Flight, state: State, k: int) -> None:
    """From now on a cargo rides in the frame of the last joint, as it stands now (MO2SET)."""
    things = state.site
    things.cargo[k].held, things.cargo[k].floating = True, None
    regrasp(flight, state, k)
    things.contacts.forget()
    things.told = frozenset()
    things.mask(flight.site)


def regrasp(flight: Flight, state: State, k: int) -> None:
    """What is held is held as it stands now, and steered so."""
    site, things = flight.site, state.site
    grasp, inside = np.empty(POSE), np.empty(POSE)
    relative(things.frames[site.last_joint], things.frames[site.cargo_row(k)], grasp)
    relative(site.hand, grasp, inside)
    things.cargo[k].grasp, things.cargo[k].steered = grasp.tolist(), inside.tolist()
    steer_with(flight, state, k)


def steer_with(flight: Flight, state: State, k: int) -> None:
    """The steering takes the mass, the axes and, as point of resolution, the centre of what is held."""
    inside = np.array(state.site.cargo[k].steered)
    rotation = inside[3:].reshape(3, 3).copy()
    payload = Payload(flight.site.cargo[k].mass, rotation, rotation.T @ inside[:3], np.zeros(3))
    state.carried = carrying(flight.scenario, payload)


def place_held(flight: Flight, state: State) -> None:
    """Put what is held, and fixed to nothing else, where the hand is."""
    site, things = flight.site, state.site
    for k, thing in enumerate(things.cargo):
        if thing.grasp is not None and not thing.seat:
            compose(things.frames[site.last_joint], np.array(thing.grasp), things.frames[site.cargo_row(k)])


def let_go(flight: Flight, state: State, k: int) -> None:
    """Nothing is in the grasp any more; modes that move a payload are left."""
    things, panel = state.site, state.panel
    thing = things.cargo[k]
    thing.held, thing.grasp, thing.first, thing.steered = False, None, None, None
    state.carried = carrying(flight.scenario, None)
    if MODES[panel.mode].loaded:
        panel.mode, panel.held, panel.holding, panel.sequence = "ORB UNL", None, None, "idle"
        log(flight, state, "mode", "info", "ORB UNL entered: nothing is in the grasp any more")
    things.mask(flight.site)


def set_free(flight: Flight, state: State, k: int) -> None:
    """A cargo that nothing holds any more goes on as it moves, and keeps its attitude control."""
    site, things = flight.site, state.site
    row = site.cargo_row(k)
    now = motion(things.before[row], things.frames[row], flight.scenario.control_period)
    pose = things.frames[row].copy()
    pose[:3] += things.away(site)
    turn = pose[3:].reshape(3, 3).T @ np.array([now.wx, now.wy, now.wz])
    velocity = np.array([now.vx, now.vy, now.vz]) + site.axes @ things.orbiter_velocity
    things.cargo[k].floating = floating(pose, velocity, turn, site.cargo[k].limit_cycle)
    things.mask(site)
