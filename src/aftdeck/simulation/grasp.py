"""Holding a payload of the worksite and letting it go: where it is then, and how the arm is steered with it."""

from __future__ import annotations

import math

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, compose, relative
from aftdeck.kinematics.payload import Payload
from aftdeck.simulation.carried import carrying
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.floating import floating
from aftdeck.simulation.log import log
from aftdeck.simulation.site import Site
from aftdeck.simulation.state import State
from aftdeck.steering.mode import MODES
from aftdeck.worksite.motion import motion
from aftdeck.worksite.snare import Snare

NEAR = 3.0
"""A bar or a fixture farther from the hand than this [m] is not yet being captured."""


def take_hold(flight: Flight, state: State, k: int) -> None:
    """From now on a cargo rides in the frame of the last joint, as it stands now (MO2SET)."""
    things = state.site
    things.cargo[k].held, things.floating[k] = True, None
    regrasp(flight, state, k)
    things.settle(flight.site)


def regrasp(flight: Flight, state: State, k: int) -> None:
    """What is held is held as it stands now, and steered so; the carriage draws in what is left from here on."""
    thing = state.site.cargo[k]
    thing.grasp = thing.steered = in_hand(flight, state, k).tolist()
    if (fixture := fixture_in_hand(flight.site, state.site.frames, k)) is not None:
        thing.first, thing.since = fixture.tolist(), state.site.snare.drawn
    steer(flight, state)


def steer(flight: Flight, state: State) -> None:
    """The steering takes what is in the grasp, and the limits of the script's phase.

    Of a payload of the worksite that is its mass, its axes and, as point of resolution, its centre.
    """
    scenario, script, payload = flight.scenario, state.script, None
    for k, thing in enumerate(state.site.cargo):
        if thing.held:
            payload = _payload(flight, k, np.array(thing.steered))
    if script.attached:
        payload = scenario.own_payloads[script.attached - 1]
    limits = scenario.phases[script.limits].limits if script.limits >= 0 else None
    state.carried = carrying(scenario, payload, limits)


def put_effector(flight: Flight, state: State, *, holding: bool) -> None:
    """Put the end effector as it is with a payload in its grasp, the prong closed or the snares rigid, or with none."""
    things = state.site
    if flight.site.prong:
        things.prong.position = flight.prong.high if holding else flight.prong.low
    else:
        held = Snare(ring=1.0, carriage=1.0, tension=1.0, captured=True, drawn=1.0)
        things.snare = held if holding else Snare()


def in_grasp(flight: Flight, state: State) -> Payload | None:
    """What the arm holds as it stands now against the hand, to which carriage and latches turn it; None: nothing."""
    k = state.site.held
    return state.carried.payload if k is None else _payload(flight, k, in_hand(flight, state, k))


def _payload(flight: Flight, k: int, grasp: Array) -> Payload:
    """What is held so, as the arm's laws take it."""
    inside = np.empty(POSE)
    relative(flight.site.hand, grasp, inside)
    rotation = inside[3:].reshape(3, 3).copy()
    return Payload(flight.site.cargo[k].mass, rotation, rotation.T @ inside[:3], np.zeros(3))


def in_hand(flight: Flight, state: State, k: int) -> Array:
    """(12,) a cargo's pose in the frame of the last joint."""
    site, frames, grasp = flight.site, state.site.frames, np.empty(POSE)
    relative(frames[site.last_joint], frames[site.cargo_row(k)], grasp)
    return grasp


def fixture_in_hand(site: Site, frames: Array, k: int) -> Array | None:
    """(12,) the grapple fixture of a cargo in the end effector's axes E; None where it has none for this hand.

    Args:
        site: what never changes.
        frames: (F, 12) in L.
        k: which cargo.
    """
    fixture = site.snares.fixtures[k] if site.snares is not None else None
    if fixture is None:
        return None
    effector, place, found = np.empty(POSE), np.empty(POSE), np.empty(POSE)
    compose(frames[site.last_joint], site.effector, effector)
    compose(frames[site.cargo_row(k)], fixture, place)
    relative(effector, place, found)
    return found


def nearest_fixture(flight: Flight, state: State, within: float = NEAR) -> tuple[int, Array] | None:
    """The cargo whose fixture is nearest to the end effector, and that (12,) in its axes, if one is so near [m]."""
    best, least = None, within
    for k in range(len(flight.site.cargo)):
        fixture = fixture_in_hand(flight.site, state.site.frames, k)
        if fixture is not None and (away := math.hypot(*fixture[:3].tolist())) < least:
            best, least = (k, fixture), away
    return best


def let_go(flight: Flight, state: State, k: int) -> None:
    """Nothing is in the grasp any more; modes that move a payload are left."""
    things, panel = state.site, state.panel
    thing = things.cargo[k]
    thing.held, thing.grasp, thing.first, thing.steered, thing.since = False, None, None, None, 0.0
    steer(flight, state)
    if MODES[panel.mode].loaded:
        panel.mode, panel.held, panel.holding, panel.sequence = "ORB UNL", None, None, "idle"
        log(flight, state, "mode", "info", "ORB UNL entered: nothing is in the grasp any more")
    things.settle(flight.site)


def set_free(flight: Flight, state: State, k: int, from_space: bool) -> None:
    """A cargo that nothing holds any more goes on as it moves, and keeps its attitude control.

    What was fixed in space rests there; what was held moves as the hand did, with the orbiter's velocity.
    """
    site, things = flight.site, state.site
    row = site.cargo_row(k)
    now = motion(things.before[row], things.frames[row], flight.scenario.control_period)
    pose = things.frames[row].copy()
    pose[:3] += site.scene[:3] - things.frames[site.space_row, :3]
    turn = pose[3:].reshape(3, 3).T @ np.array([now.wx, now.wy, now.wz])
    velocity = np.array([now.vx, now.vy, now.vz]) + site.axes @ things.orbiter_velocity
    if from_space:
        velocity[:] = 0.0
    things.floating[k] = floating(pose, velocity, turn, site.cargo[k].limit_cycle)
    things.settle(site)
