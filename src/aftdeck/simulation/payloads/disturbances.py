"""Disturbances of a step: which act, where, and as what the plant and the frame receive them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import pose_of
from aftdeck.errors import InputError
from aftdeck.frames import Pose
from aftdeck.kinematics.payload import HeldPayload
from aftdeck.matrices import length, product
from aftdeck.plant.plant import Push, Pushed
from aftdeck.scenario.disturbance import ORBITER, SPACE, TIP, Disturbance
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.payload import PART
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.frame import Wrench
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.log import Log
from aftdeck.simulation.state import Script, State
from aftdeck.tuples import plain_vector
from aftdeck.worksite.payload import Payload


def check_disturbances(flight: Flight, state: State, given: Iterable[Disturbance]) -> None:
    """Check disturbances that a caller gives as inputs of the next step.

    Raises:
        InputError: the plant has no forces, a body or a coordinate frame does not exist or cannot move now, or a number
            is not plausible.
    """
    attached = _attached(flight.scenario, state.script)
    for one in given:
        if wrong := flight.scenario.disturbable.problem(one):
            raise InputError(f"disturbances: {wrong[0]}: {wrong[1]}")
        if _wrench(flight, state.worksite.frames, state.plant.base, attached, one, 1.0) is None:
            raise InputError(f"disturbances: on {one.on!r}, in the axes of {one.frame!r}: no payload is attached now")


def disturb(flight: Flight, state: State, log: Log, inputs: Inputs) -> None:
    """Find the disturbances that act in this step, planned ones and those of the inputs; log what begins and ends."""
    planned, before = flight.scenario.disturbances, state.disturbances
    if not (planned or inputs.disturbances or before) or state.plant.bodies is None:
        return
    acting = tuple(_acting(flight, state, inputs))
    state.disturbances = acting
    now, was = {one.body for one in acting}, {one.body for one in before}
    for one in acting:
        if one.body not in was:
            was.add(one.body)
            size = f"{length(one.force):.4g} N, {length(one.torque):.4g} N m"
            log.add("disturbance", "info", f"disturbance of {one.body} begins: {size}")
    for name in sorted(was - now):
        log.add("disturbance", "info", f"disturbance of {name} ends")


def _acting(flight: Flight, state: State, inputs: Inputs) -> Iterator[Wrench]:
    frames, base, period = state.worksite.frames, state.plant.base, flight.scenario.control_period
    attached, time = _attached(flight.scenario, state.script), (state.tick - 1) * period
    given = [(one, 1.0) for one in inputs.disturbances]
    given += [(one.disturbance, one.share(time, period)) for one in flight.scenario.disturbances]
    for disturbance, share in given:
        if share > 0.0 and (wrench := _wrench(flight, frames, base, attached, disturbance, share)) is not None:
            yield wrench


def _attached(scenario: Scenario, script: Script) -> HeldPayload | None:
    """Return the scenario's own payload that is attached now; None if none is."""
    return scenario.own_payloads[script.attached - 1] if script.attached else None


def _wrench(
    flight: Flight, frames: Array, base: Array, attached: HeldPayload | None, given: Disturbance, share: float
) -> Wrench | None:
    """Return a disturbance in L; None if it needs the scenario's own payload, and none is attached."""
    axes = _axes(flight, frames, base, attached, given.frame)
    place = _place(flight, frames, attached, given)
    if axes is None or place is None:
        return None
    return Wrench(
        given.on,
        plain_vector(share * product(axes, np.array(given.force))),
        plain_vector(share * product(axes, np.array(given.torque))),
        plain_vector(place),
    )


def pushes(payloads: tuple[Payload, ...], disturbances: tuple[Wrench, ...], base_row: Array) -> Iterator[Push]:
    """Yield what disturbances do to the plant's bodies, in the axes of space.

    Args:
        payloads: the payloads.
        disturbances: the disturbances of this step, in L.
        base_row: (12,) pose of L in the frame that is fixed in space and coincided with L at the start.
    """
    base = pose_of(base_row)
    bodies: dict[str, Pushed] = {TIP: "hand", PART: "attached", ORBITER: "orbiter"}
    bodies |= {one.name: k for k, one in enumerate(payloads)}
    for one in disturbances:
        on = bodies[one.body]
        force, torque = (product(base.rotation, np.array(vector)) for vector in (one.force, one.torque))
        yield Push(on, force, torque, base.position + product(base.rotation, np.array(one.position)))


def _axes(flight: Flight, frames: Array, base: Array, attached: HeldPayload | None, name: str) -> Array | None:
    """Return the axes (3, 3) of a coordinate frame in L, as columns."""
    match name:
        case "L":
            return np.eye(3)
        case "orbiter" | "panel":
            return flight.scenario.arm.model.mount.rotation.T
        case _ if name == SPACE:
            return base[3:].reshape(3, 3).T
        case _:
            found = _frame(flight.site, frames, attached, name)
            return None if found is None else found[0].rotation


def _place(flight: Flight, frames: Array, attached: HeldPayload | None, given: Disturbance) -> Array | None:
    """Return the point (3,) in L at which a disturbance's force acts [m]."""
    if given.on == ORBITER:
        mount = flight.scenario.arm.model.mount
        if given.at is not None:
            return mount.from_("orbiter", Pose(np.array(given.at), np.eye(3))).position
        assert flight.scenario.worksite.orbiter is not None, "an orbiter that moves has a mass"
        return flight.scenario.worksite.orbiter.in_l(mount).centre
    found = _frame(flight.site, frames, attached, given.on)
    if found is None:
        return None
    pose, centre = found
    return pose.position + product(pose.rotation, centre if given.at is None else np.array(given.at))


def _frame(site: Site, frames: Array, attached: HeldPayload | None, name: str) -> tuple[Pose, Array] | None:
    """Return the true pose in L of the tip or a payload, and in its axes the point (3,) at which forces act [m].

    None for the scenario's own payload if it is not `attached`. `frames` are (F, 12) poses of all frames in L.
    """
    for k, payload in enumerate(site.payloads):
        if name == payload.name:
            return pose_of(frames[site.payload_rows[k]]), payload.centre_of_mass
    last, hand = pose_of(frames[site.last_joint]), pose_of(site.hand)
    tip = Pose(last.position + product(last.rotation, hand.position), product(last.rotation, hand.rotation))
    if name == TIP:
        return tip, np.zeros(3)
    return None if attached is None else (attached.pose(tip), attached.centre_of_mass)
