"""Capture and release of a payload, by the prong about a bar (the report's mode 1) or by the snares about a pin."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, compose, inverse
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.constants.hand import Bar, Snares
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.log import Log
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.payloads.grasp import attach, empty_grasp, nearest_fixture, update_steering
from aftdeck.simulation.payloads.mechanism import is_blocked
from aftdeck.simulation.payloads.seating import stay_or_leave
from aftdeck.simulation.state import State
from aftdeck.worksite.berths.draw_in import remaining
from aftdeck.worksite.capture.acquisition import acquired_bar
from aftdeck.worksite.capture.grapple import in_envelope
from aftdeck.worksite.capture.snare import Snare, SnareCommand, advance
from aftdeck.worksite.conditions import Condition

_TRIGGERS: dict[str, Literal["", "capture", "release"]] = {"close": "capture", "open": "release", "stop": ""}
_CONTR: dict[str, Literal["RIGID", "OFF", "DERIGID"]] = {"rigid": "RIGID", "off": "OFF", "derigid": "DERIGID"}


def capture(flight: Flight, state: State, log: Log, inputs: Inputs) -> None:
    """Capture or release a payload if the conditions are met.

    Args:
        flight: constants of the run.
        state: state at the end of the step, with all frames updated.
        log: log of the step.
        inputs: inputs of this step; the snares are triggered if `inputs.effector` is not None.
    """
    site, worksite = flight.site, state.worksite
    k, drawn = None, worksite.snare.drawn
    if state.script.attached:
        _reject_switches(log, inputs)
    elif site.bar is not None:
        k = _move_fingers(worksite, site.bar)
    elif site.snares is not None:
        k = _move_snares(flight, worksite, log, site.snares, pressed=inputs.effector is not None)
    if k is None:
        if worksite.snare.drawn == 1.0 != drawn:
            update_steering(flight, state)
        return
    if worksite.held is None:
        _attach(site, worksite, log, k)
    else:
        empty_grasp(site, worksite, state.panel, log, k)
        stay_or_leave(flight, worksite, state.plant, log, k)
        seat = worksite.cargo[k].seat
        where = f"it stays in the {site.berth(seat).title}" if seat else "it is free"
        log.add("released", "info", f"{site.cargo[k].title} released: {where}")
    update_steering(flight, state)


def _reject_switches(log: Log, inputs: Inputs) -> None:
    """Reject every command that moves the end effector, because the scenario attaches a payload to it."""
    for switch in (inputs.effector, inputs.rigid):
        if switch in ("close", "open", "rigid", "derigid"):
            log.reject(
                f"{switch.upper()} refused: the scenario fixes its payload in the grasp; a payload of [[cargo]] can be "
                "released and captured"
            )


def _move_fingers(worksite: WorksiteState, bar: Bar) -> int | None:
    """Return the payload that the fingers now capture or release; None if there is none.

    They capture a payload if the six conditions of acquisition hold, and release it if they are too far apart.
    """
    if worksite.held is not None:
        apart = bar.fixed_finger - worksite.prong.position > bar.tolerances.spacing
        return worksite.held if apart else None
    k = acquired_bar(worksite.watch.placed, bar.bars, bar.packed)
    return k if k >= 0 else None


def _move_snares(flight: Flight, worksite: WorksiteState, log: Log, snares: Snares, *, pressed: bool) -> int | None:
    """Move the snares and the carriage by one step of CAPTURE, RELEASE or MAN CONTR.

    Returns:
        The payload that they now capture or release; None if there is none.
    """
    site, scenario = flight.site, flight.scenario
    held = k = worksite.held
    if not pressed and not worksite.snare.motion and worksite.rigid == "off":
        return None
    conditions: tuple[Condition, ...] = ()
    if held is None and (near := nearest_fixture(site, worksite.frames, math.inf)) is not None:
        k, fixture = near
        conditions = in_envelope(fixture, snares.envelope)
    command = snare_command(worksite, pressed=pressed)
    snare, lines = advance(
        worksite.snare, snares.times, command, scenario.control_period, conditions, scenario.arm.model.units
    )
    blocked = False
    if held is not None and snare.drawn != worksite.snare.drawn:
        blocked = not _draw_in(flight, worksite, log, held, snare, snares.fixture(held))
    for line in lines:
        if line.kind == "refused" or not blocked:
            log.add(line.kind, line.level, line.text)
    if blocked:
        return None
    worksite.snare = snare
    return k if snare.captured == (held is None) else None


def snare_command(worksite: WorksiteState, *, pressed: bool) -> SnareCommand:
    """Return the positions of the panel's switches for the snares; `pressed`: whether the switch was pressed now."""
    return SnareCommand(
        "AUTO" if worksite.effector_mode == "auto" else "MAN",
        _TRIGGERS[worksite.switch] if pressed else "",
        _CONTR[worksite.rigid],
    )


def _draw_in(flight: Flight, worksite: WorksiteState, log: Log, k: int, snare: Snare, fixture: Array) -> bool:
    """Draw the grapple pin of the held payload k towards its final pose.

    The payload moves in the next step. A payload that is fixed to a berth does not move (assumed; a real arm would
    yield). Travel of the carriage while the payload is fixed has no effect on the payload, even after the berth
    releases it; the payload therefore does not jump.

    Args:
        flight: constants of the run.
        worksite: state of the worksite, with all frames updated.
        log: log of the step.
        k: the payload.
        snare: end effector after this step.
        fixture: (12,) pose of the grapple fixture in the payload's axes.

    Returns:
        False if this motion would make or deepen a contact.
    """
    site, payload = flight.site, worksite.cargo[k]
    if payload.seat or payload.fixture_at_capture is None:
        return True
    left, pin, grasp, drawn = np.empty(POSE), np.empty(POSE), np.empty(POSE), np.empty(POSE)
    remaining(np.array(payload.fixture_at_capture), 1.0 - (snare.drawn - payload.drawn_at_capture), left)
    compose(site.effector, left, pin)
    compose(pin, inverse(fixture), grasp)
    compose(worksite.frames[site.last_joint], grasp, drawn)
    if is_blocked(flight, worksite, log, k, drawn, "carriage"):
        return False
    payload.grasp = grasp.tolist()
    worksite.update_carrier(site, k)
    if snare.drawn == 1.0:
        payload.steered = payload.grasp
    return True


def _attach(site: Site, worksite: WorksiteState, log: Log, k: int) -> None:
    """Attach a captured payload to the arm. The capture ends task phase 1.

    A berth that closes at release frees the payload; any other berth still fixes the payload.
    """
    payload = worksite.cargo[k]
    if payload.seat and site.berth(payload.seat).closes == "at release":
        payload.seat, payload.released_from = "", payload.seat
    attach(site, worksite, k)
    fixed = f", fixed in the {site.berth(payload.seat).title}" if payload.seat else ""
    log.add("acquired", "info", f"{site.cargo[k].title} acquired{fixed}")
