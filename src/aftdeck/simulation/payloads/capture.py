"""Capture and release of a payload, by the prong about a bar (the report's mode 1) or by the snares about a pin."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from aftdeck.bodies.pose import POSE, compose, inverse
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.constants.hand import Bar, Snares
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.log import log, log_rejection
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.payloads.grasp import attach, empty_grasp, nearest_fixture, update_steering
from aftdeck.simulation.payloads.mechanism import is_blocked
from aftdeck.simulation.payloads.seating import stay_or_leave
from aftdeck.simulation.state import State
from aftdeck.worksite.capture.acquisition import acquired_bar
from aftdeck.worksite.capture.grapple import in_envelope
from aftdeck.worksite.capture.snare import Snare, SnareCommand, advance
from aftdeck.worksite.conditions import Condition
from aftdeck.worksite.seats.draw_in import remaining

_TRIGGERS: dict[str, Literal["", "capture", "release"]] = {"close": "capture", "open": "release", "stop": ""}
_CONTR: dict[str, Literal["RIGID", "OFF", "DERIGID"]] = {"rigid": "RIGID", "off": "OFF", "derigid": "DERIGID"}


def capture(flight: Flight, state: State, inputs: Inputs) -> None:
    """Capture or release a payload if the conditions are met.

    Args:
        flight: constants of the run.
        state: state at the end of the step, with all frames updated.
        inputs: inputs of this step; the snares are triggered if `inputs.effector` is not None.
    """
    if state.script.attached:
        _reject_switches(flight, state, inputs)
    elif flight.site.bar is not None:
        _capture_by_prong(flight, state, flight.site.bar)
    elif flight.site.snares is not None:
        _move_snares(flight, state, flight.site.snares, pressed=inputs.effector is not None)


def _reject_switches(flight: Flight, state: State, inputs: Inputs) -> None:
    """Reject every command that moves the end effector, because the scenario attaches a payload to it."""
    for switch in (inputs.effector, inputs.rigid):
        if switch in ("close", "open", "rigid", "derigid"):
            log_rejection(
                flight,
                state,
                f"{switch.upper()} refused: the scenario fixes its payload in the grasp; a payload of [[cargo]] can be "
                "released and captured",
            )


def _capture_by_prong(flight: Flight, state: State, bar: Bar) -> None:
    """Capture a payload if the six conditions of acquisition hold; release it if the fingers are too far apart."""
    worksite = state.worksite
    if worksite.held is not None:
        if bar.fixed_finger - worksite.prong.position > bar.tolerances.spacing:
            _release(flight, state, worksite.held)
        return
    if (k := acquired_bar(worksite.watch.placed, bar.bars, bar.packed)) >= 0:
        _attach(flight, state, k)


def _move_snares(flight: Flight, state: State, snares: Snares, pressed: bool) -> None:
    """Move the snares and the carriage by one step of CAPTURE, RELEASE or MAN CONTR."""
    worksite, scenario = state.worksite, flight.scenario
    held = k = worksite.held
    if not pressed and not worksite.snare.motion and worksite.rigid == "off":
        return
    conditions: tuple[Condition, ...] = ()
    if held is None and (near := nearest_fixture(flight, state, math.inf)) is not None:
        k, fixture = near
        conditions = in_envelope(fixture, snares.envelope)
    command = snare_command(worksite, pressed=pressed)
    snare, lines = advance(
        worksite.snare, snares.times, command, scenario.control_period, conditions, scenario.arm.model.units
    )
    blocked = (
        held is not None and snare.drawn != worksite.snare.drawn and not _draw_in(flight, state, snares, held, snare)
    )
    for line in lines:
        if line.kind == "refused" or not blocked:
            log(flight, state, line.kind, line.level, line.text)
    if blocked:
        return
    worksite.snare = snare
    if held is None and k is not None and snare.captured:
        _attach(flight, state, k)
    elif held is not None and not snare.captured:
        _release(flight, state, held)


def snare_command(worksite: WorksiteState, *, pressed: bool) -> SnareCommand:
    """Return the positions of the panel's switches for the snares; `pressed`: whether the switch was pressed now."""
    return SnareCommand(
        "AUTO" if worksite.effector_mode == "auto" else "MAN",
        _TRIGGERS[worksite.switch] if pressed else "",
        _CONTR[worksite.rigid],
    )


def _draw_in(flight: Flight, state: State, snares: Snares, k: int, snare: Snare) -> bool:
    """Draw the grapple pin towards its final pose; return False if this motion would make or deepen a contact.

    The payload moves in the next step. A payload that is fixed to a berth does not move (assumed; a real arm would
    yield). Travel of the carriage while the payload is fixed has no effect on the payload, even after the berth
    releases it; the payload therefore does not jump.
    """
    site, worksite = flight.site, state.worksite
    payload = worksite.cargo[k]
    if payload.seat or payload.fixture_at_capture is None:
        return True
    left, pin, grasp, drawn = np.empty(POSE), np.empty(POSE), np.empty(POSE), np.empty(POSE)
    remaining(np.array(payload.fixture_at_capture), 1.0 - (snare.drawn - payload.drawn_at_capture), left)
    compose(site.effector, left, pin)
    compose(pin, inverse(snares.fixture(k)), grasp)
    compose(worksite.frames[site.last_joint], grasp, drawn)
    if is_blocked(flight, state, k, drawn, "carriage"):
        return False
    payload.grasp = grasp.tolist()
    worksite.update_carrier(site, k)
    if snare.drawn == 1.0:
        payload.steered = payload.grasp
        update_steering(flight, state)
    return True


def _attach(flight: Flight, state: State, k: int) -> None:
    """Attach a captured payload to the arm. The capture ends task phase 1.

    A passive berth frees the payload; any other berth still fixes the payload.
    """
    site, payload = flight.site, state.worksite.cargo[k]
    if payload.seat and site.is_passive_berth(payload.seat):
        payload.seat, payload.released_from = "", payload.seat
    attach(flight, state, k)
    fixed = f", fixed in the {site.seat(payload.seat).title}" if payload.seat else ""
    log(flight, state, "acquired", "info", f"{site.cargo[k].title} acquired{fixed}")


def _release(flight: Flight, state: State, k: int) -> None:
    """Release a payload, which then stays in a berth, or floats with its present velocity."""
    site, payload = flight.site, state.worksite.cargo[k]
    empty_grasp(flight, state, k)
    stay_or_leave(flight, state, k)
    where = f"it stays in the {site.seat(payload.seat).title}" if payload.seat else "it is free"
    log(flight, state, "released", "info", f"{site.cargo[k].title} released: {where}")
