"""Worksite's part of a step: motion of orbiter, prong and payloads, contacts, capture, fixing and release."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.matrices import product
from aftdeck.plant.plant import LEAST_PULSE
from aftdeck.plant.state import Bodies, PlantState
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.frame_poses import frames_with_prong_at
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.log import Log
from aftdeck.simulation.motion.contact_out import way_out_of_contact
from aftdeck.simulation.motion.motion_inhibit import sliding_payload
from aftdeck.simulation.operator.panel import make_ready
from aftdeck.simulation.parts.worksite_state import DRIVES, WorksiteState
from aftdeck.simulation.payloads.capture import capture
from aftdeck.simulation.payloads.contact_log import log_contacts
from aftdeck.simulation.payloads.fixing import update_berths
from aftdeck.simulation.payloads.forces import watch_forces
from aftdeck.simulation.payloads.free_contact import drifted
from aftdeck.simulation.payloads.grasp import carried_by
from aftdeck.simulation.payloads.jets import translation_rejection
from aftdeck.simulation.payloads.relations import permitted
from aftdeck.simulation.payloads.surroundings import follow_bodies
from aftdeck.simulation.payloads.task_phases import change_task, task_of
from aftdeck.simulation.period.period import JUDGED, SEEN, contacts
from aftdeck.simulation.period.quick import inhibit_of
from aftdeck.simulation.row.scalars import CHANGED, LEAST, NEAREST, PRONG_AT, STAND, TASK, TOUCHING, WORKS
from aftdeck.simulation.state import State
from aftdeck.tuples import Vec3
from aftdeck.worksite.capture.effector import RESTS
from aftdeck.worksite.free_flight import translate
from aftdeck.worksite.watch.contact_motion import looked_at, relieves, worst_new_contact
from aftdeck.worksite.watch.contacts import FRAMES, Inhibit


def update_worksite(flight: Flight, state: State, log: Log, inputs: Inputs, reached: int) -> None:
    """Update the worksite to the end of the step, after the plant has moved.

    `reached` tells how far compiled code has made the step (`period.period.advance`).
    """
    site, worksite, plant = flight.site, state.worksite, state.plant
    before, was_fixed = worksite.contacts.inhibit, worksite.arm_fixed
    if reached < SEEN:
        _move_worksite(flight, state, log, inputs)
        _update_contacts(flight, state)
    elif reached == SEEN:
        touching, changed = state.row.values[TOUCHING] != 0.0, state.row.values[CHANGED] != 0.0
        _judge(flight, worksite, plant, state.panel.mode, touching=touching, changed=changed)
    else:
        worksite.contacts.inhibit = inhibit_of(state)
    log_contacts(site.layout, worksite, plant.bodies, log, flight.scenario.arm.model.units)
    now = worksite.contacts.inhibit
    if now != before:
        _log_inhibits(log, before, now)
    if now.arm:
        way_out_of_contact(flight, state)
    elif worksite.advice is not None:
        worksite.advice = None
    if reached > JUDGED:
        pressed = inputs.effector is not None or inputs.rigid is not None
        if pressed and state.row.values[WORKS] == RESTS:  # the log tells why the end effector does not move
            capture(flight, worksite, plant, state.panel, log, inputs, attached=state.script.attached > 0)
        change_task(worksite, int(state.row.values[TASK]), log)
        return
    in_grasp, attached = worksite.in_grasp, state.script.attached > 0
    capture(flight, worksite, plant, state.panel, log, inputs, attached=attached)
    update_berths(flight, worksite, plant, log, state.tick, inputs.latch)
    if worksite.in_grasp != in_grasp:
        state.carried = carried_by(flight.scenario, site, worksite, state.script)
    if worksite.arm_fixed != was_fixed and state.panel.sequence != "in progress":
        # a berth fixed or freed the arm, so CMD CK's verdict no longer applies
        make_ready(flight.scenario.sequences, state)
    change_task(worksite, task_of(site, worksite), log)


def _move_worksite(flight: Flight, state: State, log: Log, inputs: Inputs) -> None:
    """Move the orbiter, the prong and the payloads that float."""
    site, worksite, plant, period = flight.site, state.worksite, state.plant, flight.scenario.control_period
    _move_orbiter(flight, worksite, plant, log, inputs.orbiter)
    _move_prong(flight, worksite, plant, attached=state.script.attached > 0)
    if plant.bodies is None:
        for k, floating in enumerate(worksite.floating):
            if floating is not None:
                worksite.floating[k] = drifted(flight, worksite, plant, log, k, floating)
                worksite.update_carrier(site, k)
    else:
        follow_bodies(site, worksite, plant, plant.bodies)
        watch_forces(site, worksite, plant.bodies, log, period)


def _update_contacts(flight: Flight, state: State) -> None:
    """Update the poses of all frames, the clearances, the contacts, and the inhibits that the contacts cause."""
    worksite, plant, scalars = state.worksite, state.plant, state.row.scalars
    scalars[STAND], scalars[PRONG_AT] = plant.stand.position, worksite.prong.position
    contacts(*flight.packed, *state.row.packed, plant.frames)
    values = state.row.values = scalars.tolist()
    worksite.nearest, worksite.watch.least = int(values[NEAREST]), values[LEAST]
    touching, changed = values[TOUCHING] != 0.0, values[CHANGED] != 0.0
    _judge(flight, worksite, plant, state.panel.mode, touching=touching, changed=changed)


def _judge(
    flight: Flight, worksite: WorksiteState, plant: PlantState, mode: str, *, touching: bool, changed: bool
) -> None:
    """Update which contacts belong to the task, and the inhibits that contacts cause."""
    site, watch, counted = flight.site, worksite.watch, worksite.contacts
    if touching or changed or (plant.bodies is not None and plant.bodies.touches):
        worksite.permitted[:] = permitted(site, watch, worksite.frames)
        sliding = sliding_payload(worksite.held, mode) if flight.inhibits else None
        counted.essential[:] = site.essential_while(sliding, worksite.permitted)
    counted.judge(touching, changed, site.by_prong, worksite.task, inhibits=flight.inhibits)


def _move_orbiter(flight: Flight, worksite: WorksiteState, plant: PlantState, log: Log, command: Vec3) -> None:
    """Translate the orbiter. If the translation is blocked, log the reason once."""
    why = ""
    if any(command) or any(worksite.orbiter_velocity.tolist()):
        why = _try_translation(flight, worksite, plant, np.array(command))
    if why and not worksite.orbiter_rejected:
        log.reject(why)
    worksite.orbiter_rejected = bool(why)


def _try_translation(flight: Flight, worksite: WorksiteState, plant: PlantState, command: Array) -> str:
    """Translate the orbiter by one step.

    The orbiter stops at once if the arm holds a docked payload, or if the translation would deepen a detrimental
    contact.

    Returns:
        The reason why the orbiter cannot translate; "" if it can.
    """
    site, rule = flight.site, flight.site.worksite.translation
    velocity = worksite.orbiter_velocity
    if why := translation_rejection(flight, worksite, plant.bodies):
        velocity[:] = 0.0
        return why
    assert rule is not None, "`translation_rejection` rejects a translation without a rule"
    if plant.bodies is not None:
        _follow_translation(site, worksite, plant.bodies, command)
        return ""
    period, detrimental = flight.scenario.control_period, 1 - worksite.contacts.essential
    if not (flight.inhibits and worksite.logged_contacts and np.any(detrimental & (worksite.contacts.count == FRAMES))):
        translate(worksite.orbiter, velocity, command, rule.speed, rule.reached_in, period)
        return ""
    without, here = frames_with_prong_at(site, worksite, plant, worksite.prong.position), worksite.orbiter.copy()
    translate(worksite.orbiter, velocity, command, rule.speed, rule.reached_in, period)
    after = frames_with_prong_at(site, worksite, plant, worksite.prong.position)
    group = worst_new_contact(looked_at(worksite.watch, without), detrimental, after)
    if group < 0:
        return ""
    worksite.orbiter[:], velocity[:] = here, 0.0
    a, b = site.layout.named(group)
    return f"orbiter translation refused: {a} would penetrate {b} further"


def _follow_translation(site: Site, worksite: WorksiteState, bodies: Bodies, command: Array) -> None:
    """Set the velocity of the translation to that of the bodies; 0 for an axis that has come to rest.

    The orbiter's displacement is part of the plant's state.
    """
    velocity, rule = worksite.orbiter_velocity, site.worksite.translation
    assert rule is not None, "an orbiter that translates has a rule"
    velocity[:] = product(site.axes.T, bodies.orbiter_velocity)
    velocity[(command == 0.0) & (np.abs(velocity) < rule.speed / rule.reached_in * LEAST_PULSE)] = 0.0


def _move_prong(flight: Flight, worksite: WorksiteState, plant: PlantState, *, attached: bool) -> None:
    """Close or open the prong. Under FINGER INHIBIT, only motion that relieves the prong's contacts is allowed.

    `attached`: whether the scenario attaches a payload, so that the prong cannot move.
    """
    site = flight.site
    free = site.prong and not attached
    drive = DRIVES[worksite.switch] if free else 0.0
    prong, period = worksite.prong, flight.scenario.control_period
    if drive > 0.0:
        drive *= _closing_fraction(site, worksite, prong.after(flight.prong, drive, period) - prong.position)
    if drive != 0.0 and worksite.contacts.inhibit.finger:
        before, after = (
            frames_with_prong_at(site, worksite, plant, at)
            for at in (prong.position, prong.after(flight.prong, drive, period))
        )
        harmful = site.by_prong & (1 - worksite.contacts.essential)
        if not relieves(looked_at(worksite.watch, before), site.by_prong, harmful, after):
            drive = 0.0
    prong.move(flight.prong, drive, period)


def _closing_fraction(site: Site, worksite: WorksiteState, distance: float) -> float:
    """Return the fraction of `distance` [m] that the prong moves until it touches the held payload's bar; at most 1."""
    k = worksite.held
    if site.capture is None or k is None:
        return 1.0
    clearance = site.capture.until_touch(worksite.watch.placed, k)
    return 1.0 if distance <= clearance else clearance / distance


def _log_inhibits(log: Log, before: Inhibit, now: Inhibit) -> None:
    """Log changes of the inhibits."""
    for name, was, is_now in (("ARM", before.arm, now.arm), ("FINGER", before.finger, now.finger)):
        if is_now and not was:
            log.add("inhibit", "warning", f"{name} INHIBIT: only motion that relieves the contact is allowed")
        elif was and not is_now:
            log.add("inhibit", "info", f"{name} INHIBIT off")
