"""Worksite's part of a step: motion besides the arm's, contacts, and capture, fixing and release of payloads."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.frame_poses import frames_with
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.log import log, refuse
from aftdeck.simulation.motion.contact_out import way_out_of_contact
from aftdeck.simulation.motion.motion_inhibit import slider
from aftdeck.simulation.operator.panel import make_ready
from aftdeck.simulation.payloads.capture import capture
from aftdeck.simulation.payloads.free_contact import drifted
from aftdeck.simulation.payloads.relations import permitted
from aftdeck.simulation.payloads.seating import seat
from aftdeck.simulation.payloads.task_phases import change_task
from aftdeck.simulation.state import State
from aftdeck.worksite.capture.acquisition import FOUND, PRONG, acquire
from aftdeck.worksite.free_flight import translate
from aftdeck.worksite.watch.contact_motion import looked_at, relieves, worsened
from aftdeck.worksite.watch.contact_update import look_around
from aftdeck.worksite.watch.contacts import FRAMES, Inhibit

_DRIVES = {"stop": 0.0, "close": 1.0, "open": -1.0}


def work(flight: Flight, state: State, inputs: Inputs) -> None:
    """Update the worksite to the end of the step, after the plant has moved."""
    things = state.site
    _move_orbiter(flight, state, inputs)
    _move_prong(flight, state)
    for k, floating in enumerate(things.floating):
        if floating is not None:
            things.floating[k] = drifted(flight, state, k, floating)
            things.ride(flight.site, k)
    before, fast = things.contacts.inhibit, things.fast
    _look_around(flight, state)
    _tell_contacts(flight, state, before)
    capture(flight, state, inputs)
    seat(flight, state, inputs.latch)
    if things.fast != fast and state.panel.sequence != "in progress":
        make_ready(flight, state)  # CMD CK's verdict was for the old attachment to the seat
    change_task(flight, state)


def _look_around(flight: Flight, state: State) -> None:
    """Update the poses of all frames, the clearances, the contacts and what the contacts inhibit."""
    site, things, plant, period = flight.site, state.site, state.plant, flight.scenario.control_period
    layout, watch, contacts = site.layout, things.watch, things.contacts
    things.looked[:] = watch.active
    now = look_around(
        *things.places(site),
        plant.angles,
        plant.stand.position,
        things.prong.position,
        *layout.packed,
        watch.active,
        watch.counts,
        things.before,
        things.frames,
        period,
        flight.within,
        *watch.packed,
        contacts.count,
    )
    things.nearest = now.nearest
    if now.touching or now.changed:
        things.permitted[:] = permitted(site, watch, things.frames)
        contacts.essential[:] = site.essential_while(slider(state), things.permitted)
    contacts.judge(now.touching, now.changed, site.by_prong, things.task)


def _move_orbiter(flight: Flight, state: State, inputs: Inputs) -> None:
    """Translate the orbiter; if that is not possible, log the reason once."""
    things = state.site
    why = ""
    if any(inputs.orbiter) or any(things.orbiter_velocity.tolist()):
        why = _translated(flight, state, np.array(inputs.orbiter))
    if why and not things.refused_orbiter:
        refuse(flight, state, why)
    things.refused_orbiter = bool(why)


def _translated(flight: Flight, state: State, command: Array) -> str:
    """Translate the orbiter by one step; stop it at once if the arm holds a docked payload or a contact would deepen.

    Returns:
        The reason why the orbiter does not translate; "" if it does.
    """
    site, things, rule = flight.site, state.site, flight.site.worksite.translation
    if rule is None:
        return "the orbiter does not translate at this worksite"
    held, velocity = things.held, things.orbiter_velocity
    if held is not None and things.cargo[held].seat and site.in_space(things.cargo[held].seat):
        velocity[:] = 0.0
        return "the orbiter does not translate while the arm holds a docked payload: RELEASE or UNLATCH"
    period, detrimental = flight.scenario.control_period, 1 - things.contacts.essential
    if not (things.told and np.any(detrimental & (things.contacts.count == FRAMES))):
        translate(things.orbiter, velocity, command, rule.speed, rule.reached_in, period)
        return ""
    without, here = frames_with(flight, state, things.prong.position), things.orbiter.copy()
    translate(things.orbiter, velocity, command, rule.speed, rule.reached_in, period)
    group = worsened(looked_at(things.watch, without), detrimental, frames_with(flight, state, things.prong.position))
    if group < 0:
        return ""
    things.orbiter[:], velocity[:] = here, 0.0
    a, b = site.layout.named(group)
    return f"the orbiter does not translate so: it would bring {a} deeper into {b}"


def _move_prong(flight: Flight, state: State) -> None:
    """Close or open the prong; while the finger is inhibited, only motion that relieves its contacts is allowed."""
    site, things = flight.site, state.site
    free = site.prong and not state.script.attached
    drive = _DRIVES[things.switch] if free else 0.0
    prong, period = things.prong, flight.scenario.control_period
    if drive > 0.0:
        drive *= _room(flight, state, prong.after(flight.prong, drive, period) - prong.position)
    if drive != 0.0 and things.contacts.inhibit.finger:
        before, after = (
            frames_with(flight, state, at) for at in (prong.position, prong.after(flight.prong, drive, period))
        )
        harmful = site.by_prong & (1 - things.contacts.essential)
        if not relieves(looked_at(things.watch, before), site.by_prong, harmful, after):
            drive = 0.0
    prong.move(flight.prong, drive, period)


def _room(flight: Flight, state: State, way: float) -> float:
    """Return the fraction of a distance [m] that the prong can close until it meets the bar of the held cargo."""
    site, k = flight.site, state.site.held
    if site.bar is None or k is None or (which := site.bar.which[k]) is None:
        return 1.0
    found = np.empty(FOUND)
    acquire(state.site.watch.placed, which, site.bar.packed, found)
    room = max(float(found[PRONG]), 0.0)
    return 1.0 if way <= room else room / way


def _tell_contacts(flight: Flight, state: State, before: Inhibit) -> None:
    """Log changes of the contacts and inhibits, and update the way out of the contacts."""
    things = state.site
    now = things.contacts.inhibit
    if now.changed:
        standing = things.contacts.standing(flight.site.layout, things.watch.found, flight.scenario.arm.model.units)
        for contact in standing:
            if contact.group not in things.told:
                log(flight, state, "contact", "info" if contact.essential else "caution", contact.text)
        touching = sorted(contact.group for contact in standing)
        for group in sorted(set(things.told) - set(touching)):
            a, b = flight.site.layout.named(group)
            log(flight, state, "contact", "info", f"{a} clear of {b}")
        things.told = tuple(touching)
    if now == before and not now.arm and not things.advice:
        return
    for name, was, is_now in (("ARM", before.arm, now.arm), ("FINGER", before.finger, now.finger)):
        if is_now and not was:
            log(flight, state, "inhibit", "warning", f"{name} INHIBIT: only motion that relieves the contact is flown")
        elif was and not is_now:
            log(flight, state, "inhibit", "info", f"{name} INHIBIT off")
    if now.arm:
        way_out_of_contact(flight, state)
    else:
        things.advice = None
