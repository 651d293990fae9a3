"""Initial state of a run, and re-initialisation to a task phase of the scenario (the report's input 2)."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from aftdeck.bodies.pose import HERE
from aftdeck.errors import ScenarioError
from aftdeck.kinematics.observe import observe
from aftdeck.scenario.fit import TOLERANCE
from aftdeck.scenario.model import Scenario, Start
from aftdeck.scenario.schema import Part
from aftdeck.scenario.target import Target
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.frame_poses import frames_at, frames_with_prong_at
from aftdeck.simulation.operator.panel import make_ready
from aftdeck.simulation.parts.carried import steering_setup
from aftdeck.simulation.parts.free_flight import at_start
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.payloads.alignment import count
from aftdeck.simulation.payloads.forces import held_by
from aftdeck.simulation.payloads.grasp import attach, carried_by, set_effector
from aftdeck.simulation.payloads.objective import holding
from aftdeck.simulation.payloads.relations import permitted
from aftdeck.simulation.payloads.task_phases import change_task, task_of
from aftdeck.simulation.state import State, new_state
from aftdeck.steering.layout import KEPT, MASTER, RATES, TWIST
from aftdeck.steering.mode import MODES
from aftdeck.worksite.berths.latches import SHUT
from aftdeck.worksite.conditions import failure_text, quantity_text


def initial_state(flight: Flight, start: Start | None = None, used: State | None = None) -> State:
    """Return the state before the first step.

    Args:
        flight: constants of the run.
        start: initial conditions that replace those of the scenario; None for those of the scenario.
        used: a state of a run with the same constants, which is no longer needed: the new state is made in its row.

    Raises:
        ScenarioError: initial conditions give a held payload that the end effector could not have captured in this
            pose, or, on a plant with contact forces, begin with one part inside another. Without `start`, those of the
            parts of the problem are checked too.
    """
    scenario = flight.scenario
    state = _state_at(flight, scenario.start if start is None else start, used)
    found = {"initial": state}
    if start is None:
        found |= {
            f"initialise.{part}": _state_at(flight, begin)
            for part, begin in scenario.parts.items()
            if begin.grasped or flight.plant.has_contact_forces
        }
    problems = [
        f"{scenario.name}: {problem}" for name, at in found.items() for problem in _misfits(flight, at.worksite, name)
    ]
    if problems:
        raise ScenarioError(problems)
    state.panel.keyed = _first_target(scenario)
    return state


def _misfits(flight: Flight, worksite: WorksiteState, name: str) -> Iterator[str]:
    """Yield the reasons for which no run can begin in a state, whose conditions have the key `name` in the file."""
    units = flight.scenario.arm.model.units
    k = worksite.held
    if k is not None and (why := failure_text(holding(flight.site, worksite, k), units)):
        yield f"{name}.grasped: {flight.site.payloads[k].title} cannot have been captured in this pose: {why}"
    if not flight.plant.has_contact_forces:
        return
    overlaps = [
        f"{contact.a} is {quantity_text(contact.depth, 'm', units)} inside {contact.b}"
        for contact in worksite.contacts.standing(flight.site.layout, worksite.watch.found, units)
        if contact.depth > TOLERANCE and not worksite.permitted[contact.group]
    ]
    if overlaps:
        yield f"{name}: starts where {'; '.join(overlaps)}: the plant {flight.scenario.plant!r} would throw them apart"


def _first_target(scenario: Scenario) -> Target | None:
    """Return the target that is keyed in at the start: in a run that begins in OPR CMD, that of the first phase."""
    if scenario.mode != "OPR CMD" or not scenario.phases:
        return None
    target = scenario.phases[0].target
    return target if isinstance(target, Target) else None


def _state_at(flight: Flight, start: Start, used: State | None = None) -> State:
    """Return the state with the initial conditions `start`, before the first step; `used` as for `initial_state`."""
    scenario = flight.scenario
    state = new_state(flight, steering_setup(scenario, scenario.payload))
    if used is not None:
        state.renew_row(used.row)
    _set_to_start(flight, state, start)
    return state


def initialise(flight: Flight, state: State, part: Part) -> None:
    """Re-initialise the run to the initial conditions that the scenario gives for `part`."""
    parts, log = flight.scenario.parts, state.log(flight.scenario.control_period)
    if part not in parts:
        available = f"this scenario has {', '.join(parts)}" if parts else "this scenario has no such starts"
        log.reject(f"initialisation to {part} refused: {available}")
        return
    task = state.worksite.task
    state.replace_with(_state_at(flight, parts[part]))
    state.panel.motion_began, state.script.attached = state.tick - 1, 0 if flight.scenario.payload is None else 1
    state.carried = carried_by(flight.scenario, flight.site, state.worksite, state.script)
    if MODES[state.panel.mode].loaded and state.carried.payload is None:
        state.panel.mode = "ORB UNL"  # the present mode needs a payload, but the arm holds none
    log.add("initialise", "info", f"initialised to {part}")
    state.worksite.task = task
    change_task(state.worksite, task_of(flight.site, state.worksite), log)
    if state.tick > 1:  # in the first step, `operate` calls `make_ready`
        make_ready(flight.scenario.sequences, state)


def _set_to_start(flight: Flight, state: State, start: Start) -> None:
    """Set the arm and the worksite of a new state to the initial conditions `start`."""
    site, worksite, scenario = flight.site, state.worksite, flight.scenario
    plant, joints = state.plant, len(start.angles)
    plant.angles[:], plant.rates[:] = start.angles, start.rates
    plant.stand.position = start.stand
    plant.commanded[:] = start.angles
    observe(state.arm.model.links, start.angles, start.rates, state.observed)
    state.command[MASTER : MASTER + joints] = state.command[KEPT : KEPT + joints] = start.angles
    state.steering[RATES : RATES + joints], state.steering[TWIST : TWIST + 6] = start.rates, state.observed[12:18]
    state.measure()
    frames = worksite.frames
    for k, payload in enumerate(site.payloads):
        if payload.start.berth:
            worksite.payloads[k].berth, worksite.payloads[k].latches = payload.start.berth, SHUT
            worksite.payloads[k].offset_at_fixing = worksite.payloads[k].offset_in_berth = list(HERE)
        else:
            worksite.floating[k] = at_start(site, k)
    worksite.update_attachments(site)
    frames[:] = frames_with_prong_at(site, worksite, plant, worksite.prong.position)
    if state.script.attached:
        set_effector(flight, worksite, holding=True)
        frames[:] = frames_with_prong_at(site, worksite, plant, worksite.prong.position)
    if start.grasped is not None:
        k = start.grasped.payload
        set_effector(flight, worksite, holding=True)
        angles, stand = start.grasped.angles, start.grasped.stand
        frames[:] = frames_at(site, worksite, plant, angles, stand, worksite.prong.position)
        worksite.payloads[k].berth, worksite.payloads[k].released_from = "", worksite.payloads[k].berth
        attach(site, worksite, k)
        state.carried = carried_by(flight.scenario, flight.site, state.worksite, state.script)
        frames[:] = frames_with_prong_at(site, worksite, plant, worksite.prong.position)
    poses = frames[site.space_row + 1 :].copy()
    motions = np.array([np.zeros(6) if one is None else one.motion for one in worksite.floating]).reshape(-1, 6)
    flight.plant.begin(plant, state.script.attached, poses, motions, worksite.prong.position)
    if plant.bodies is not None:
        for k, one in enumerate(worksite.payloads):
            plant.bodies.held_for[k] = [math.inf if by else 0.0 for by in held_by(site, one)]
    worksite.before[:] = frames
    worksite.monitored_before[:] = worksite.watch.active
    worksite.watch.look_near(frames, worksite.watch.active, flight.within)
    worksite.permitted[:] = permitted(flight, state, worksite.watch, frames)
    worksite.contacts.update(worksite.watch.found, worksite.watch.near, site.by_prong, worksite.task)
    count(flight, state)
    worksite.watch.look_near(frames, worksite.watch.counts, flight.within)
    worksite.nearest = worksite.watch.nearest(worksite.watch.counts)
    change_task(worksite, task_of(site, worksite), state.log(scenario.control_period))
