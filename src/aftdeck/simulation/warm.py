"""Compilation of all laws before a run. Compilation during the run would delay steps by seconds."""

from __future__ import annotations

import contextlib

from msgspec.structs import replace

from aftdeck.bodies.placed import (
    along_axes,
    carried,
    components,
    composed,
    inverted,
    matrix_product,
    motion_left,
    motions_along,
    transposed,
    turned,
    twist_along,
)
from aftdeck.elementary import atan2
from aftdeck.errors import AftdeckError
from aftdeck.frames import quaternion_of_rows
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.target import target_at
from aftdeck.simulation.begin import initial_state
from aftdeck.simulation.constants.flight import Flight, run_constants
from aftdeck.simulation.fly import complete
from aftdeck.simulation.frame import Placed
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.motion.contact_out import way_out_of_contact
from aftdeck.simulation.observe.arm_events import log_arm_events
from aftdeck.simulation.observe.look import frame_of
from aftdeck.simulation.observe.look_ahead import MOST_S, look_ahead
from aftdeck.simulation.payloads.alignment import count
from aftdeck.simulation.payloads.fixing import conditions_at
from aftdeck.simulation.payloads.grasp import attach, carried_by, empty_grasp, start_free_flight
from aftdeck.simulation.payloads.objective import present_objective
from aftdeck.simulation.payloads.task_phases import change_task, task_of
from aftdeck.simulation.period.period import DRIVEN, NOTHING
from aftdeck.simulation.state import State
from aftdeck.simulation.step import step
from aftdeck.state_part import digest
from aftdeck.steering.limiters import rate_ratio
from aftdeck.steering.mode import AUTOMATIC_LAWS
from aftdeck.worksite.watch.contact_motion import worst_new_contact
from aftdeck.worksite.watch.contacts import two_frames


def warm_up(scenario: Scenario) -> None:
    """Call every law once, which compiles it: run a few steps of the scenario in a new state."""
    flight = run_constants(scenario, gauged=True)
    state = initial_state(flight)
    arm = scenario.arm
    here = target_at(arm.forward(scenario.initial_angles))
    step(flight, state, Inputs())
    frame_of(flight, state, digest(state))
    quaternion_of_rows(here.rotation)  # recordings contain quaternions
    atan2(0.0, 1.0)  # cameras are aimed with it
    _guide(Placed(here.position, here.rotation))
    rate_ratio(state.rules, state.steering)
    for law in AUTOMATIC_LAWS:
        step(flight, state, Inputs(mode="OPR CMD", law=law, target=here, proceed=True))
        step(flight, state, Inputs(stop=True))
    with contextlib.suppress(AftdeckError):  # the start pose may be singular
        arm.inverse(here.pose, near=scenario.initial_angles)
    look_ahead(flight, state, MOST_S, (3, 1))
    _rest_of_step(flight, state)
    step(flight, state, Inputs(mode="SINGLE"))
    step(flight, state, None)
    contacts = state.worksite.contacts
    two_frames(contacts.count, contacts.essential, contacts.arm, flight.site.by_prong, state.worksite.task)
    way_out_of_contact(flight, state)
    worst_new_contact(state.worksite.watch, flight.site.detrimental, state.worksite.frames)
    if flight.site.capture is not None:
        closing = replace(state.worksite.controls(pressed=True), switch="close")
        worksite, units = state.worksite, arm.model.units
        flight.site.capture.step(
            closing, None, worksite.frames, worksite.watch.place, flight.scenario.control_period, units
        )
    if flight.site.payloads:
        present_objective(flight.site, state.worksite)
        _carry(flight, state)


def _guide(tip: Placed) -> None:
    """Compute the remaining motion along the sticks, as the operator's guide, a pilot and an environment do."""
    transposed(tip.orientation)
    composed(*tip, *inverted(*carried(*tip, *tip, *tip)))
    matrix_product(tip.orientation, tip.orientation)
    motion, _, _ = motion_left(*tip, *tip, tip.position)
    along_axes(*motion, tip.position, tip.orientation, tip.orientation)
    twist_along((*tip.position, *tip.position), tip.orientation, tip.orientation)
    motions_along(*motion, tip.position, (*tip.position, *tip.position), tip.orientation, tip.orientation)
    components(turned(tip.orientation, tip.position), tip.orientation)


def _carry(flight: Flight, state: State) -> None:
    """Attach the first payload, evaluate its berths, and release it."""
    site, worksite, log = flight.site, state.worksite, state.log(flight.scenario.control_period)
    worksite.payloads[0].berth = ""
    attach(site, worksite, 0)
    state.carried = carried_by(flight.scenario, flight.site, state.worksite, state.script)
    change_task(worksite, task_of(site, worksite), log)
    frame_of(flight, state, digest(state))
    worksite.watch.update(worksite.frames)
    for fit in site.fits[0]:
        conditions_at(site, worksite, 0, fit)
    empty_grasp(site, worksite, state.panel, log, 0)
    state.carried = carried_by(flight.scenario, flight.site, state.worksite, state.script)
    start_free_flight(flight, worksite, state.plant, 0, from_space=False)
    step(flight, state, None)
    _rest_of_step(flight, state)


def _rest_of_step(flight: Flight, state: State) -> None:
    """Make the part of a step that follows the steering, as far as Python can make it."""
    log = state.log(flight.scenario.control_period)
    complete(flight, state, log, Inputs(), DRIVEN if state.plant.bodies is None else NOTHING, observes=True)
    count(flight, state)
    log_arm_events(flight, state, log, complete=False)
