"""Worksite's part of a step: motion of orbiter, prong and payloads, contacts, capture, fixing and release."""

from __future__ import annotations

import numpy as np

from aftdeck.matrices import product
from aftdeck.plant.plant import LEAST_PULSE
from aftdeck.plant.state import Bodies
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.log import Log
from aftdeck.simulation.motion.contact_out import way_out_of_contact
from aftdeck.simulation.operator.panel import make_ready
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.payloads.capture import capture
from aftdeck.simulation.payloads.contact_log import log_contacts
from aftdeck.simulation.payloads.fixing import update_berths
from aftdeck.simulation.payloads.forces import watch_forces
from aftdeck.simulation.payloads.free_contact import drifted
from aftdeck.simulation.payloads.grasp import carried_by
from aftdeck.simulation.payloads.jets import translation_rejection
from aftdeck.simulation.payloads.surroundings import follow_payloads
from aftdeck.simulation.payloads.task_phases import change_task, task_of
from aftdeck.simulation.period.period import JUDGED
from aftdeck.simulation.period.quick import follow_bodies, inhibit_of, move_prong
from aftdeck.simulation.row.scalars import (
    FREELY,
    HINDERED,
    REJECTED,
    TASK,
    WORKS,
)
from aftdeck.simulation.state import State
from aftdeck.tuples import Vec3
from aftdeck.worksite.capture.effector import RESTS
from aftdeck.worksite.watch.contacts import Inhibit


def update_worksite(flight: Flight, state: State, log: Log, inputs: Inputs, reached: int, *, observes: bool) -> int:
    """Update the worksite to the end of the step, after the plant has moved.

    `reached` is how far compiled code has made the step (`period.period.advance`), which also explains `observes`.
    Return how far the step has come then.
    """
    site, worksite, plant = flight.site, state.worksite, state.plant
    before, was_fixed = worksite.contacts.inhibit, worksite.arm_fixed
    hindered = int(state.row.values[HINDERED])
    if plant.bodies is None and (hindered != FREELY or worksite.orbiter_rejected):
        _log_hindrance(flight, worksite, log, hindered)
    if reached < JUDGED:
        _move_worksite(flight, state, log, inputs)
        reached = follow_bodies(flight, state, observes=observes)
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
        if pressed and state.row.values[WORKS] == RESTS:  # log why the end effector does not move
            capture(flight, worksite, plant, state.panel, log, inputs, attached=state.script.attached > 0)
        change_task(worksite, int(state.row.values[TASK]), log)
        return reached
    in_grasp, attached = worksite.in_grasp, state.script.attached > 0
    capture(flight, worksite, plant, state.panel, log, inputs, attached=attached)
    update_berths(flight, worksite, plant, log, state.tick, inputs.latch)
    if worksite.in_grasp != in_grasp:
        state.carried = carried_by(flight.scenario, site, worksite, state.script)
    if worksite.arm_fixed != was_fixed and state.panel.sequence != "in progress":
        # a berth fixed or freed the arm, so CMD CK's verdict no longer applies
        make_ready(flight.scenario.sequences, state)
    change_task(worksite, task_of(site, worksite), log)
    return reached


def _move_worksite(flight: Flight, state: State, log: Log, inputs: Inputs) -> None:
    """Move what compiled code has left: payloads that float; with masses, all besides the arm."""
    site, worksite, plant, period = flight.site, state.worksite, state.plant, flight.scenario.control_period
    if plant.bodies is None:
        for k, floating in enumerate(worksite.floating):
            if floating is not None:
                worksite.floating[k] = drifted(flight, worksite, plant, log, k, floating)
                worksite.update_carrier(site, k)
    else:
        _follow_orbiter(flight, worksite, plant.bodies, log, inputs.orbiter)
        move_prong(flight, state)
        follow_payloads(site, worksite, plant, plant.bodies)
        watch_forces(site, worksite, plant.bodies, log, period)


def _log_hindrance(flight: Flight, worksite: WorksiteState, log: Log, hindered: int) -> None:
    """Log why the orbiter does not translate, once; `hindered`: `HINDERED` of the step."""
    why = ""
    if hindered == REJECTED:
        why = translation_rejection(flight, worksite, None)
    elif hindered != FREELY:
        a, b = flight.site.layout.named(hindered)
        why = f"orbiter translation refused: {a} would penetrate {b} further"
    _log_rejection(worksite, log, why)


def _log_rejection(worksite: WorksiteState, log: Log, why: str) -> None:
    """Log once why a translation of the orbiter is rejected; "" if it is not."""
    if why and not worksite.orbiter_rejected:
        log.reject(why)
    worksite.orbiter_rejected = bool(why)


def _follow_orbiter(flight: Flight, worksite: WorksiteState, bodies: Bodies, log: Log, command: Vec3) -> None:
    """Set the velocity of the translation to that of the bodies; 0 for an axis that has come to rest.

    The orbiter's displacement is part of the plant's state. If the translation is not possible, log the reason once.
    """
    velocity, why = worksite.orbiter_velocity, ""
    if any(command) or any(velocity.tolist()):
        rule = flight.site.worksite.translation
        if why := translation_rejection(flight, worksite, bodies):
            velocity[:] = 0.0
        elif rule is not None:
            velocity[:] = product(flight.site.axes.T, bodies.orbiter_velocity)
            resting = np.abs(velocity) < rule.speed / rule.reached_in * LEAST_PULSE
            velocity[(np.array(command) == 0.0) & resting] = 0.0
    _log_rejection(worksite, log, why)


def _log_inhibits(log: Log, before: Inhibit, now: Inhibit) -> None:
    """Log changes of the inhibits."""
    for name, was, is_now in (("ARM", before.arm, now.arm), ("FINGER", before.finger, now.finger)):
        if is_now and not was:
            log.add("inhibit", "warning", f"{name} INHIBIT: only motion that relieves the contact is allowed")
        elif was and not is_now:
            log.add("inhibit", "info", f"{name} INHIBIT off")
