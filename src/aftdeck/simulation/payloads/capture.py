"""Capture and release of a payload by the end effector (the report's mode 1)."""

from __future__ import annotations

import numpy as np

from aftdeck.bodies.pose import POSE, compose
from aftdeck.plant.state import PlantState
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.log import Log
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.payloads.fixing import stay_or_leave
from aftdeck.simulation.payloads.grasp import attach, empty_grasp
from aftdeck.simulation.payloads.mechanism import is_blocked
from aftdeck.simulation.state import Panel
from aftdeck.worksite.capture.effector import EndEffector, Moved
from aftdeck.worksite.capture.snare import Snare


def capture(
    flight: Flight,
    worksite: WorksiteState,
    plant: PlantState,
    panel: Panel,
    log: Log,
    inputs: Inputs,
    *,
    attached: bool,
) -> None:
    """Capture or release a payload if the conditions are met.

    Args:
        flight: constants of the run.
        worksite: state of the worksite at the end of the step, with all frames updated.
        plant: state of the plant.
        panel: state of the panel.
        log: log of the step.
        inputs: inputs of this step; the snares are triggered if `inputs.effector` is not None.
        attached: whether the scenario attaches a payload, so that the end effector cannot move.
    """
    site, k = flight.site, None
    if attached:
        _reject_switches(log, inputs)
    elif site.capture is not None:
        controls = worksite.controls(pressed=inputs.effector is not None)
        moved = site.capture.step(
            controls, worksite.held, worksite.frames, worksite.watch.place, flight.scenario.control_period,
            flight.scenario.arm.model.units,
        )  # fmt: skip
        if moved is not None:
            k = _move(flight, worksite, log, site.capture, moved)
    if k is None:
        return
    if worksite.held is None:
        _attach(site, worksite, log, k)
    else:
        empty_grasp(site, worksite, panel, log, k)
        stay_or_leave(flight, worksite, plant, log, k)
        berth = worksite.payloads[k].berth
        where = f"it stays in the {site.berth(berth).title}" if berth else "it is free"
        log.add("released", "info", f"{site.payloads[k].title} released: {where}")


def _reject_switches(log: Log, inputs: Inputs) -> None:
    """Reject every command that moves the end effector, because the scenario attaches a payload to it."""
    for switch in (inputs.effector, inputs.rigid):
        if switch in ("close", "open", "rigid", "derigid"):
            log.reject(
                f"{switch.upper()} refused: the scenario fixes its payload in the grasp; a payload of [[cargo]] can be "
                "released and captured"
            )


def _move(flight: Flight, worksite: WorksiteState, log: Log, device: EndEffector, moved: Moved) -> int | None:
    """Apply a step of the end effector, unless it would draw a held payload into a contact.

    Returns:
        The payload that it now captures or releases; None if there is none.
    """
    held, blocked = worksite.held, False
    if held is not None and moved.snare.drawn != worksite.snare.drawn:
        blocked = not _draw_in(flight, worksite, log, held, moved.snare, device)
    for line in moved.lines:
        if line.kind == "refused" or not blocked:
            log.add(line.kind, line.level, line.text)
    if blocked:
        return None
    worksite.snare = moved.snare
    return moved.payload


def _draw_in(flight: Flight, worksite: WorksiteState, log: Log, k: int, snare: Snare, device: EndEffector) -> bool:
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
        device: constants of the end effector.

    Returns:
        False if this motion would make or deepen a contact.
    """
    site, payload = flight.site, worksite.payloads[k]
    if payload.berth or payload.fixture_at_capture is None:
        return True
    drawn, left = np.empty(POSE), 1.0 - (snare.drawn - payload.drawn_at_capture)
    grasp = device.drawn_grasp(k, np.array(payload.fixture_at_capture), left)
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
    payload = worksite.payloads[k]
    if payload.berth and site.berth(payload.berth).closes == "at release":
        payload.berth, payload.released_from = "", payload.berth
    attach(site, worksite, k)
    fixed = f", fixed in the {site.berth(payload.berth).title}" if payload.berth else ""
    log.add("acquired", "info", f"{site.payloads[k].title} acquired{fixed}")
