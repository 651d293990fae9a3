"""Worksite's part of a step: motion of orbiter, prong and payloads, contacts, capture, fixing and release."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.matrices import product
from aftdeck.plant.plant import LEAST_PULSE
from aftdeck.plant.state import Bodies
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.frame_poses import frames_with_prong_at
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.log import log, log_rejection
from aftdeck.simulation.motion.contact_out import way_out_of_contact
from aftdeck.simulation.motion.motion_inhibit import sliding_payload
from aftdeck.simulation.operator.panel import make_ready
from aftdeck.simulation.payloads.capture import capture
from aftdeck.simulation.payloads.contact_log import log_contacts
from aftdeck.simulation.payloads.forces import watch_forces
from aftdeck.simulation.payloads.free_contact import drifted
from aftdeck.simulation.payloads.jets import translation_rejection
from aftdeck.simulation.payloads.relations import permitted
from aftdeck.simulation.payloads.seating import seat
from aftdeck.simulation.payloads.surroundings import follow_bodies
from aftdeck.simulation.payloads.task_phases import change_task
from aftdeck.simulation.state import State
from aftdeck.worksite.capture.acquisition import PRONG
from aftdeck.worksite.free_flight import translate
from aftdeck.worksite.watch.contact_motion import looked_at, relieves, worst_new_contact
from aftdeck.worksite.watch.contact_update import update_contacts
from aftdeck.worksite.watch.contacts import FRAMES, Inhibit

_DRIVES = {"stop": 0.0, "close": 1.0, "open": -1.0}


def update_worksite(flight: Flight, state: State, inputs: Inputs) -> None:
    """Update the worksite to the end of the step, after the plant has moved."""
    worksite = state.worksite
    _move_orbiter(flight, state, inputs)
    _move_prong(flight, state)
    if state.plant.bodies is None:
        for k, floating in enumerate(worksite.floating):
            if floating is not None:
                worksite.floating[k] = drifted(flight, state, k, floating)
                worksite.update_carrier(flight.site, k)
    else:
        follow_bodies(flight, state, state.plant.bodies)
        watch_forces(flight, state, state.plant.bodies)
    before, was_fixed = worksite.contacts.inhibit, worksite.arm_fixed
    _update_contacts(flight, state)
    log_contacts(flight, state)
    _log_inhibits(flight, state, before)
    capture(flight, state, inputs)
    seat(flight, state, inputs.latch)
    if worksite.arm_fixed != was_fixed and state.panel.sequence != "in progress":
        make_ready(flight, state)  # a berth fixed or freed the arm, so CMD CK's verdict no longer applies
    change_task(flight, state)


def _update_contacts(flight: Flight, state: State) -> None:
    """Update the poses of all frames, the clearances, the contacts, and the inhibits that the contacts cause."""
    site, worksite, plant, period = flight.site, state.worksite, state.plant, flight.scenario.control_period
    layout, watch, contacts = site.layout, worksite.watch, worksite.contacts
    worksite.monitored_before[:] = watch.active
    touching, changed, worksite.nearest, watch.least = update_contacts(
        *worksite.places(site),
        plant.angles,
        plant.stand.position,
        worksite.prong.position,
        plant.frames,
        plant.base,
        *layout.packed,
        watch.active,
        watch.counts,
        worksite.before,
        worksite.frames,
        period,
        flight.within,
        *watch.packed,
        contacts.count,
    )
    if touching or changed or (plant.bodies is not None and plant.bodies.touches):
        worksite.permitted[:] = permitted(site, watch, worksite.frames)
        contacts.essential[:] = site.essential_while(sliding_payload(flight, state), worksite.permitted)
    contacts.judge(touching, changed, site.by_prong, worksite.task, inhibits=flight.inhibits)


def _move_orbiter(flight: Flight, state: State, inputs: Inputs) -> None:
    """Translate the orbiter. If the translation is blocked, log the reason once."""
    worksite = state.worksite
    why = ""
    if any(inputs.orbiter) or any(worksite.orbiter_velocity.tolist()):
        why = _try_translation(flight, state, np.array(inputs.orbiter))
    if why and not worksite.orbiter_rejected:
        log_rejection(flight, state, why)
    worksite.orbiter_rejected = bool(why)


def _try_translation(flight: Flight, state: State, command: Array) -> str:
    """Translate the orbiter by one step.

    The orbiter stops at once if the arm holds a docked payload, or if the translation would deepen a detrimental
    contact.

    Returns:
        The reason why the orbiter cannot translate; "" if it can.
    """
    site, worksite, rule = flight.site, state.worksite, flight.site.worksite.translation
    velocity = worksite.orbiter_velocity
    if why := translation_rejection(flight, state):
        velocity[:] = 0.0
        return why
    assert rule is not None, "`translation_rejection` rejects a translation without a rule"
    if state.plant.bodies is not None:
        _follow_translation(flight, state, state.plant.bodies, command)
        return ""
    period, detrimental = flight.scenario.control_period, 1 - worksite.contacts.essential
    if not (flight.inhibits and worksite.logged_contacts and np.any(detrimental & (worksite.contacts.count == FRAMES))):
        translate(worksite.orbiter, velocity, command, rule.speed, rule.reached_in, period)
        return ""
    without, here = frames_with_prong_at(flight, state, worksite.prong.position), worksite.orbiter.copy()
    translate(worksite.orbiter, velocity, command, rule.speed, rule.reached_in, period)
    group = worst_new_contact(
        looked_at(worksite.watch, without), detrimental, frames_with_prong_at(flight, state, worksite.prong.position)
    )
    if group < 0:
        return ""
    worksite.orbiter[:], velocity[:] = here, 0.0
    a, b = site.layout.named(group)
    return f"orbiter translation refused: {a} would penetrate {b} further"


def _follow_translation(flight: Flight, state: State, bodies: Bodies, command: Array) -> None:
    """Set the velocity of the translation to that of the bodies; 0 for an axis that has come to rest.

    The orbiter's displacement is part of the plant's state.
    """
    velocity, rule = state.worksite.orbiter_velocity, flight.site.worksite.translation
    assert rule is not None, "an orbiter that translates has a rule"
    velocity[:] = product(flight.site.axes.T, bodies.orbiter_velocity)
    velocity[(command == 0.0) & (np.abs(velocity) < rule.speed / rule.reached_in * LEAST_PULSE)] = 0.0


def _move_prong(flight: Flight, state: State) -> None:
    """Close or open the prong. Under FINGER INHIBIT, only motion that relieves the prong's contacts is allowed."""
    site, worksite = flight.site, state.worksite
    free = site.prong and not state.script.attached
    drive = _DRIVES[worksite.switch] if free else 0.0
    prong, period = worksite.prong, flight.scenario.control_period
    if drive > 0.0:
        drive *= _closing_fraction(flight, state, prong.after(flight.prong, drive, period) - prong.position)
    if drive != 0.0 and worksite.contacts.inhibit.finger:
        before, after = (
            frames_with_prong_at(flight, state, at) for at in (prong.position, prong.after(flight.prong, drive, period))
        )
        harmful = site.by_prong & (1 - worksite.contacts.essential)
        if not relieves(looked_at(worksite.watch, before), site.by_prong, harmful, after):
            drive = 0.0
    prong.move(flight.prong, drive, period)


def _closing_fraction(flight: Flight, state: State, distance: float) -> float:
    """Return the fraction of `distance` [m] that the prong moves until it touches the held payload's bar; at most 1."""
    site, k = flight.site, state.worksite.held
    if site.bar is None or k is None or (found := site.bar.measured(state.worksite.watch.placed, k)) is None:
        return 1.0
    clearance = max(float(found[PRONG]), 0.0)
    return 1.0 if distance <= clearance else clearance / distance


def _log_inhibits(flight: Flight, state: State, before: Inhibit) -> None:
    """Log changes of the inhibits, and update the escape direction out of the contacts."""
    worksite = state.worksite
    now = worksite.contacts.inhibit
    if now == before and not now.arm and not worksite.advice:
        return
    for name, was, is_now in (("ARM", before.arm, now.arm), ("FINGER", before.finger, now.finger)):
        if is_now and not was:
            log(
                flight, state, "inhibit", "warning", f"{name} INHIBIT: only motion that relieves the contact is allowed"
            )
        elif was and not is_now:
            log(flight, state, "inhibit", "info", f"{name} INHIBIT off")
    if now.arm:
        way_out_of_contact(flight, state)
    else:
        worksite.advice = None
