"""Worksite's part of a step's frame: contacts, captures, and the poses of all payloads."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Mask
from aftdeck.bodies.separation import named
from aftdeck.plant.state import PlantState
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.observe.frame_numbers import moving
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.payloads.objective import present_objective
from aftdeck.simulation.state import State
from aftdeck.steering.layout import MASTER
from aftdeck.steering.mode import MODES
from aftdeck.tuples import Joints, Vec3
from aftdeck.worksite.capture import bar, snares
from aftdeck.worksite.report import Cargo, Hand, Near, Work
from aftdeck.worksite.watch.approach import measures
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor
from aftdeck.worksite.watch.found import CLEARANCE
from aftdeck.worksite.watch.groups import Layout

_ZERO = (0.0, 0.0, 0.0)


def work_of(flight: Flight, state: State) -> Work:
    """Return the record of the worksite as it is now."""
    site, worksite, period = flight.site, state.worksite, flight.scenario.control_period
    group, layout, essential = worksite.nearest, site.layout, worksite.contacts.essential
    inhibit = worksite.contacts.inhibit
    contacts: tuple[Near, ...] = ()
    reasons: tuple[str, ...] = ()
    if worksite.logged_contacts:
        found = worksite.watch.found
        contacts = tuple(
            near_of(layout, essential, worksite.watch, group, worksite.before, period)
            for group in worksite.contacts.groups(found)
        )
        if inhibit.arm:
            standing = worksite.contacts.standing(layout, found, flight.scenario.arm.model.units)
            reasons = tuple(contact.text for contact in standing if contact.inhibits)
    objective, conditions = present_objective(site, worksite)
    return Work(
        task=worksite.task,
        nearest=None if group < 0 else near_of(layout, essential, worksite.watch, group, worksite.before, period),
        clearance_level=state.panel.clearance,
        contacts=contacts,
        arm_inhibit=inhibit.arm,
        finger_inhibit=inhibit.finger,
        inhibits=reasons,
        objective=objective,
        conditions=conditions,
        hand=_hand(flight, worksite, loaded=state.carried.payload is not None),
        stand=None if flight.scenario.arm.model.telescope is None else state.plant.stand.position,
        orbiter=_displacement(site, worksite, state.plant),
        orbiter_velocity=_velocity(site, worksite, state.plant),
        cargo=tuple(_cargo(site, worksite, k, period) for k in range(len(site.payloads))),
        master=_master(state) if MODES[state.panel.mode].kind == "master" else None,
    )


def all_near(layout: Layout, worksite: WorksiteState, period: float) -> tuple[Near, ...]:
    """Return every monitored pair, the smallest clearance first; `period`: the control period [s]."""
    watch, essential = worksite.watch.copied(), worksite.contacts.essential
    watch.update(worksite.frames)
    found = watch.found[:, CLEARANCE]
    groups = np.flatnonzero(np.isfinite(found))
    order = groups[np.argsort(found[groups], kind="stable")].tolist()
    return tuple(near_of(layout, essential, watch, group, worksite.before, period) for group in order)


def _displacement(site: Site, worksite: WorksiteState, plant: PlantState) -> Vec3:
    """Return the displacement of the orbiter since the start, in L's axes at the start [m]."""
    if plant.bodies is None:
        return _in_l(site, worksite.orbiter)
    return _three(plant.base)


def _velocity(site: Site, worksite: WorksiteState, plant: PlantState) -> Vec3:
    """Return the velocity of the orbiter in L's axes [m/s]; on a plant with masses, that of its centre of mass."""
    if plant.bodies is None:
        return _in_l(site, worksite.orbiter_velocity)
    return _three(plant.bodies.orbiter_velocity)


def _three(values: Array) -> Vec3:
    """Return the first three values of an array."""
    x, y, z = values[:3].tolist()
    return x, y, z


def _in_l(site: Site, along: Array) -> Vec3:
    """Convert a vector from the orbiter's axes to L."""
    x, y, z = along.tolist()
    if x == y == z == 0.0:
        return _ZERO
    (a, b, c), (d, e, f), (g, h, i) = site.axes.tolist()
    return a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z


def _master(state: State) -> Joints:
    """Return the master arm's joint angles [rad]."""
    return tuple(state.command[MASTER : MASTER + len(state.plant.angles)].tolist())


def near_of(layout: Layout, essential: Mask, watch: ClearanceMonitor, group: int, before: Array, period: float) -> Near:
    """Return the record of a monitored pair.

    Args:
        layout: the solids and the groups.
        essential: (g,) 1 for pairs whose contacts belong to the task.
        watch: the monitor, which has measured the pair.
        group: the pair.
        before: (F, 12) poses of the frames one step before the measurement, in L.
        period: time between them and the measurement [s].
    """
    a, b = layout.named(group)
    touching, clearance, speed, at_a, at_b, normal, distance, of_a, of_b = measures(
        watch.found, group, layout.pairs, layout.frame, before, watch.at, period
    )
    return Near(
        a,
        b,
        clearance,
        speed,
        at_a,
        at_b,
        _ZERO if touching else normal,
        0.0 if touching else distance,
        bool(essential[group]),
        named(of_a) if touching else "",
        named(of_b) if touching else "",
    )


def _hand(flight: Flight, worksite: WorksiteState, *, loaded: bool) -> Hand:
    """Return the record of the end effector; `loaded`: whether a payload is in the grasp."""
    prong = flight.scenario.arm.model.prong
    if prong is not None:
        return bar.status(worksite.switch, worksite.prong.position, prong, holds=loaded)
    return snares.status(worksite.controls())


def _cargo(site: Site, worksite: WorksiteState, k: int, period: float) -> Cargo:
    position, orientation, velocity = moving(worksite.frames, worksite.before, site.payload_rows[k], period)
    payload = worksite.payloads[k]
    return Cargo(site.payloads[k].name, position, orientation, velocity, payload.held, payload.berth)
