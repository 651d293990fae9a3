"""Looking at the arm after a step: the frame, and the log's lines about stops and singularities."""

from __future__ import annotations

import math
from typing import cast

import numpy as np
from numpy.typing import NDArray

from aftdeck.frames import Rows, angle_between
from aftdeck.kinematics.observe import CARRIED, OBSERVED, observe, observe_payload
from aftdeck.kinematics.singular import NAMES
from aftdeck.simulation.acting import acting_limits
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.frame import AT_HARD, FREE, PAST_REACH, PAST_SOFT, Frame, Goal, Level, Six, Vec3
from aftdeck.simulation.log import log, spoken
from aftdeck.simulation.look_work import look_work
from aftdeck.simulation.panel import law_of
from aftdeck.simulation.state import State
from aftdeck.simulation.ways_out import ways_out
from aftdeck.steering.layout import (
    DEMAND,
    DRIVE,
    RATE,
    RATES,
    RATIO,
    REMAINING,
    SPEED,
    STICKS,
    TURN,
    TWIST,
)
from aftdeck.steering.mode import MODES

Array = NDArray[np.float64]

_ALL_FREE = (FREE,) * 6
TOUCHING = 1e-6
"""How near to a hard stop counts as at it [rad]."""
_BACK_TEXTS = {PAST_REACH: "back inside its soft stop", PAST_SOFT: "off its hard stop"}
_ZONE_TEXTS = {FREE: "clear of its limits", PAST_REACH: "past its reach limit", PAST_SOFT: "past its soft stop",
               AT_HARD: "at its hard stop"}  # fmt: skip


def look(flight: Flight, state: State, by_script: bool, phase: str) -> Frame:
    """The frame after the step just made, with its log lines; `state.events` is taken up in it."""
    scenario, panel = flight.scenario, state.panel
    seen_array = np.empty(OBSERVED)
    observe(state.arm.model.links, state.plant.angles, state.plant.rates, seen_array)
    seen_array[17] -= state.plant.stand.velocity  # the whole arm rides on its stand, which lengthens against axis 3
    seen = seen_array.tolist()
    angles = state.plant.angles.tolist()
    zones = _zones(flight, angles)
    singular = tuple(name for name, d in zip(NAMES, seen[18:], strict=True) if abs(d) < scenario.arm.model.singular)
    _tell_changes(flight, state, zones, singular, seen[18:])
    rules = state.carried.rules[panel.mode, panel.rate].tolist()
    command, steering, report = state.command.tolist(), state.steering.tolist(), state.report.tolist()
    points = len(scenario.sequences.get(panel.mode, ()))
    position, orientation = _vec3(seen, 0), _rows(seen, 3)
    resolution, twist, payload = _carried(flight, state, position, seen_array, seen)
    return Frame(
        tick=state.tick,
        time_s=round(state.tick * scenario.control_period, 9),
        phase=phase,
        by="script" if by_script else "hand",
        mode=panel.mode,
        law=law_of(panel),
        law_choice=panel.law,
        payload_axes=panel.payload_axes,
        rate_hold=panel.held is not None,
        position_hold=panel.position_hold,
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
        angles_commanded=_six(state.commanded.tolist(), 0),
        rates_commanded=_six(steering, RATES),
        rate_limits=_six(rules, RATE),
        zones=cast("tuple[int, int, int, int, int, int]", zones),
        position=position,
        orientation=orientation,
        resolution=resolution,
        payload=payload,
        twist=twist,
        twist_commanded=_six(steering, TWIST),
        twist_demanded=_six(report, DEMAND),
        por_limits=(rules[SPEED], rules[TURN]),
        ratio=report[RATIO],
        limits=acting_limits(flight, state),
        singularity=_vec3(seen, 18),
        singular=singular,
        ways_out=ways_out(flight, state, zones, singular),
        goal=_goal(state, position, orientation, report[REMAINING]),
        work=look_work(flight, state),
        events=tuple(state.events),
        views=state.cameras.views,
    )


def _carried(
    flight: Flight, state: State, position: Vec3, seen_array: Array, seen: list[float]
) -> tuple[Vec3, Six, tuple[Vec3, Rows] | None]:
    """The point of resolution, its twist, and the payload in the grasp, if any."""
    held = state.carried.payload
    if held is None:
        return position, _six(seen, 12), None
    carried_array = np.empty(CARRIED)
    observe_payload(seen_array, held.packed, carried_array)
    carried = carried_array.tolist()
    payload = (_vec3(carried, 0), _rows(carried, 3))
    if not MODES[state.panel.mode].loaded or flight.scenario.strict:  # the source moves the tip in every mode
        return position, _six(seen, 12), payload
    return _vec3(carried, 12), (seen[12], seen[13], seen[14], carried[15], carried[16], carried[17]), payload


def _vec3(values: list[float], at: int) -> Vec3:
    return values[at], values[at + 1], values[at + 2]


def _rows(values: list[float], at: int) -> Rows:
    return _vec3(values, at), _vec3(values, at + 3), _vec3(values, at + 6)


def _six(values: list[float], at: int) -> Six:
    return values[at], values[at + 1], values[at + 2], values[at + 3], values[at + 4], values[at + 5]


def _zones(flight: Flight, angles: list[float]) -> tuple[int, ...]:
    for q, (low, high) in zip(angles, flight.reach, strict=True):
        if not low <= q <= high:
            break
    else:
        return _ALL_FREE
    return tuple(
        FREE
        if reach[0] <= q <= reach[1]
        else PAST_REACH
        if soft[0] <= q <= soft[1]
        else PAST_SOFT
        if hard[0] + TOUCHING < q < hard[1] - TOUCHING
        else AT_HARD
        for q, reach, soft, hard in zip(angles, flight.reach, flight.soft, flight.hard, strict=True)
    )


def _tell_changes(
    flight: Flight, state: State, zones: tuple[int, ...], singular: tuple[str, ...], distances: list[float]
) -> None:
    """Log what has changed: joints that pass a limit, singularities that come near."""
    panel, joints = state.panel, flight.scenario.arm.joints
    if zones != panel.zones:
        for joint, old, new in zip(joints, panel.zones, zones, strict=True):
            if new != old:
                level: Level = "caution" if new > old else "info"
                text = _ZONE_TEXTS[new] if new > old or new == FREE else _BACK_TEXTS[new]
                log(flight, state, "limit", level, f"{spoken(joint)} {text}")
        panel.zones = zones
    if singular != panel.singular:
        for name, distance in zip(NAMES, distances, strict=True):
            if name in singular and name not in panel.singular:
                log(flight, state, "singular", "caution", f"{name} singularity near: {abs(distance):.2f} of 1")
            elif name in panel.singular and name not in singular:
                log(flight, state, "singular", "info", f"{name} singularity left behind")
        panel.singular = singular


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
