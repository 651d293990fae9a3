"""Frame of a step, built from the state after the step."""

from __future__ import annotations

import math

import numpy as np

from aftdeck.frames import Rows, angle_between
from aftdeck.kinematics.observe import CARRIED, observe_link, observe_payload
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.frame import Frame, Goal, Placed, Six, Times, Vec3
from aftdeck.simulation.motion.active_limits import acting_limits
from aftdeck.simulation.observe.look_work import look_work
from aftdeck.simulation.payloads.grasp import in_grasp
from aftdeck.simulation.state import State
from aftdeck.steering.layout import (
    DEMAND,
    DRIVE,
    GO,
    RATE,
    RATES,
    RATIO,
    REMAINING,
    SPEED,
    STICKS,
    TURN,
    TURN_REMAINING,
    TWIST,
)
from aftdeck.steering.mode import MODES


def look(flight: Flight, state: State, seal: bytes) -> Frame:
    """Return the frame of the last step, with its log lines and the state's digest; leave the state unchanged."""
    scenario, panel = flight.scenario, state.panel
    seen, angles = state.seen.tolist(), state.plant.angles.tolist()
    rules = state.rules.tolist()
    command, steering, report = state.command.tolist(), state.steering.tolist(), state.report.tolist()
    points = len(scenario.sequences.get(panel.mode, ()))
    position, orientation = _vec3(seen, 0), _rows(seen, 3)
    resolution, twist, payload = _carried(flight, state, position, seen)
    return Frame(
        tick=state.tick,
        time_s=round(state.tick * scenario.control_period, 9),
        phase=state.phase,
        by="script" if state.by_script else "hand",
        mode=panel.mode,
        law=panel.flown,
        law_choice=panel.law,
        payload_axes=panel.payload_axes,
        rate_hold=panel.held is not None,
        position_hold=panel.position_hold,
        brakes=panel.brakes,
        safing=panel.safing,
        joint=panel.joint,
        rate=panel.rate,
        sequence=panel.sequence,
        point=min(panel.point + 1, points) if points else 0,
        points=points,
        check=panel.check,
        translation=_vec3(command, STICKS + 3),
        rotation=_vec3(command, STICKS),
        drive=command[DRIVE],
        angles=_six(angles, 0),
        rates=_six(state.plant.rates.tolist(), 0),
        angles_commanded=_six(state.plant.commanded.tolist(), 0),
        rates_commanded=_six(steering, RATES),
        rate_limits=_six(rules, RATE),
        zones=panel.zones,
        position=position,
        orientation=orientation,
        wrist_pitch=_wrist_pitch(flight, state),
        resolution=resolution,
        payload=payload,
        attached=state.script.attached,
        twist=twist,
        twist_commanded=_six(steering, TWIST),
        twist_demanded=_six(report, DEMAND),
        por_limits=(rules[SPEED], rules[TURN]),
        ratio=report[RATIO],
        limits=acting_limits(flight, state),
        singularity=_vec3(seen, 18),
        singular=panel.singular,
        ways_out=state.ways_out,
        goal=_goal(state, position, orientation, report[REMAINING]),
        times=_times(flight, state),
        work=look_work(flight, state),
        events=tuple(state.events),
        views=state.views,
        sha256=seal.hex(),
    )


def _carried(flight: Flight, state: State, position: Vec3, seen: list[float]) -> tuple[Vec3, Six, Placed | None]:
    """Return the point of resolution, its twist, and the payload in the grasp (None if the grasp is empty)."""
    held = in_grasp(flight, state)
    if held is None:
        return position, _six(seen, 12), None
    carried_array = np.empty(CARRIED)
    observe_payload(state.seen, held.packed, carried_array)
    carried = carried_array.tolist()
    payload = Placed(_vec3(carried, 0), _rows(carried, 3))
    if not MODES[state.panel.mode].loaded or flight.scenario.strict:  # the source moves the tip in every mode
        return position, _six(seen, 12), payload
    return _vec3(carried, 12), (seen[12], seen[13], seen[14], carried[15], carried[16], carried[17]), payload


def _wrist_pitch(flight: Flight, state: State) -> Rows:
    """Return LNKAGE's T_B5 (see `observe_link`)."""
    model, axes = flight.scenario.arm.model, np.empty((3, 3))
    observe_link(model.links, state.plant.angles, model.mount.rotation, axes)
    return _rows(axes.ravel().tolist(), 0)


def _times(flight: Flight, state: State) -> Times:
    """Return TP, ETA and ETAP; the laws report the time that remains at the beginning of a step."""
    panel, period, report = state.panel, flight.scenario.control_period, state.report
    steered = (state.tick - 1 - panel.began) * period
    eta = etap = None
    if panel.sequence == "in progress":
        if state.command[GO] != 0.0:
            eta = steered + float(report[REMAINING])
            etap = None if panel.law == "position" else steered + float(report[TURN_REMAINING])
    elif state.by_script and state.phase and not state.script.ended:
        phase = flight.scenario.phases[state.script.phase]
        eta = phase.duration if phase.timed else None
    return Times(steered + period, eta, etap)


def _vec3(values: list[float], at: int) -> Vec3:
    return values[at], values[at + 1], values[at + 2]


def _rows(values: list[float], at: int) -> Rows:
    return _vec3(values, at), _vec3(values, at + 3), _vec3(values, at + 6)


def _six(values: list[float], at: int) -> Six:
    return values[at], values[at + 1], values[at + 2], values[at + 3], values[at + 4], values[at + 5]


def _goal(state: State, position: Vec3, orientation: Rows, remaining: float) -> Goal | None:
    target = state.panel.target
    if target is None:
        return None
    return Goal(
        target.position,
        target.rotation,
        math.dist(target.position, position),
        angle_between(target.rotation, orientation),
        remaining if state.panel.sequence == "in progress" else 0.0,
    )
