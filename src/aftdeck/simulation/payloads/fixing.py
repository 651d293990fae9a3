"""Fixing and release of payloads by berths. `Berth.closes` and `Berth.instant` tell when a berth does so.

Source: Remote Manipulator Simulation, mode 3 (docking), and section VII: a payload that is inserted and released stays
where it is. A payload that is both held and fixed to a berth blocks the arm until the end effector or the berth
releases the payload.
"""

from __future__ import annotations

from typing import Literal

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, compose
from aftdeck.matrices import length
from aftdeck.plant.state import PlantState
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.log import Log
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.payloads.grasp import reset_grasp, start_free_flight
from aftdeck.simulation.payloads.latch_command import Pressed, addressed, confirmed, nearest_berth
from aftdeck.simulation.payloads.mechanism import is_blocked
from aftdeck.worksite.berths.berth import Fit
from aftdeck.worksite.berths.latches import OPEN, SHUT, Latches, advance
from aftdeck.worksite.berths.on_way import NEAR
from aftdeck.worksite.conditions import Condition, Units, all_hold, failure_text, quantity_text
from aftdeck.worksite.draw_in import remaining


def update_berths(
    flight: Flight, worksite: WorksiteState, plant: PlantState, log: Log, tick: int, pressed: Pressed | None
) -> None:
    """Fix payloads to berths that close by themselves, move latches, and execute LATCH or UNLATCH (`pressed`).

    `tick` is the number of the control step.
    """
    site = flight.site
    index = addressed(site, worksite, pressed)
    answer: str | None = None
    for k, payload in enumerate(worksite.payloads):
        own = pressed if k == index else None
        if payload.berth and own is None and not payload.latches.motion:
            continue
        if payload.berth:
            found = _update_fixed(flight, worksite, plant, log, tick, k, own)
        elif payload.held or own is not None:
            found = _update_unfixed(flight, worksite, log, k, own)
        else:
            continue
        answer = found if k == index else answer
    if pressed and answer != "":
        units = flight.scenario.arm.model.units
        why = answer or (
            _nearest_berth_text(site, worksite, units) if pressed == "latch" else "no payload is at a berth"
        )
        log.reject(f"{pressed.upper()} refused: {why}")


def _nearest_berth_text(site: Site, worksite: WorksiteState, units: Units) -> str:
    """Return the reason for rejecting LATCH, as text.

    The text names the unfixed payload that is nearest to its pose in a berth, and its distance from this pose.
    """
    distances = [
        (length(fit.offset(worksite.frames, site.payload_rows[k])[:3].tolist()), k, fit.berth.title)
        for k, own in enumerate(site.fits)
        for fit in own
        if not worksite.payloads[k].berth
    ]
    if not distances:
        return "no berth of this worksite accepts a payload that is not fixed already"
    distance, k, title = min(distances)
    near, allowed = quantity_text(distance, "m", units), quantity_text(NEAR, "m", units)
    return f"no payload is at a berth: {site.payloads[k].title} is {near} from the {title}, at most {allowed} allowed"


def stay_or_leave(flight: Flight, worksite: WorksiteState, plant: PlantState, log: Log, k: int) -> None:
    """Fix a payload after its release to a berth that closes then, or start its free flight.

    The payload is fixed if the conditions of such a berth hold. A payload that is already fixed stays fixed.
    """
    if worksite.payloads[k].berth:
        return
    for fit in flight.site.fits[k]:
        if fit.berth.closes == "at release" and all_hold(conditions_at(flight.site, worksite, k, fit)):
            _fix(flight.site, worksite, log, k, fit, SHUT)
            return
    start_free_flight(flight, worksite, plant, k, from_space=False)


def _update_unfixed(flight: Flight, worksite: WorksiteState, log: Log, k: int, pressed: Pressed | None) -> str | None:
    """Fix a payload to the nearest berth if the conditions of this berth hold.

    A berth that closes by itself fixes a held payload without a command, and a floating payload on LATCH.

    Returns:
        Answer to `pressed` for this payload: "" if the command was executed, or if the log already contains the answer;
        the reason if LATCH was rejected; None if LATCH was not pressed for this payload, or if no berth is near.
    """
    site, payload = flight.site, worksite.payloads[k]
    fit = nearest_berth(site, worksite.frames, k)
    if fit is None:
        payload.released_from = ""
        return None
    berth, row = fit.berth, site.payload_rows[k]
    by_itself = berth.closes == "by itself"
    if not (by_itself or pressed == "latch" or payload.released_from):
        return None
    if pressed is None and fit.has_left(worksite.frames, row):
        payload.released_from = ""
        return None
    conditions, units = conditions_at(site, worksite, k, fit), flight.scenario.arm.model.units
    holds = all_hold(conditions)
    if payload.released_from and not (holds and payload.released_from == berth.name):
        payload.released_from = ""
    if pressed != "latch" and not (by_itself and holds and not payload.released_from):
        return None
    if berth.closes == "at release" and payload.held:
        return failure_text(conditions, units) or f"the {berth.title} fixes the payload on RELEASE"
    if by_itself and holds:
        payload.released_from = ""
    if berth.instant:
        if holds:
            _fix(site, worksite, log, k, fit, SHUT)
            if not berth.docks:
                log.add("latched", "info", f"{site.payloads[k].title} stays in the {berth.title}")
        return failure_text(conditions, units)
    latches, lines = advance(OPEN, berth.time, "latch", flight.scenario.control_period, conditions, units)
    for line in lines:
        log.add(line.kind, line.level, line.text)
    if latches.hold:
        log.add("latch", "info", f"latches of the {berth.title} closing")
        _fix(site, worksite, log, k, fit, latches)
    return ""


def _update_fixed(
    flight: Flight, worksite: WorksiteState, plant: PlantState, log: Log, tick: int, k: int, pressed: Pressed | None
) -> str | None:
    """Update a payload that is fixed to a berth: continue or reverse the latches, or undock the payload.

    Returns:
        Answer to `pressed` for this payload: "", the reason for a rejection, or None, as in `_update_unfixed`.
    """
    site, period = flight.site, flight.scenario.control_period
    payload, title = worksite.payloads[k], site.payloads[k].title
    fit = site.fit(k, payload.berth)
    assert fit is not None, "a fixed payload has a berth"
    berth = fit.berth
    if pressed == "latch":
        payload.unlatch_asked_at = 0
    if berth.closes == "at release":
        return f"{title} is in the {berth.title}, which frees it at capture" if pressed else None
    only = f"nothing but the {berth.title} holds {title}"
    if berth.instant:
        if pressed != "unlatch":
            return f"{title} is {'docked' if berth.docks else 'latched'} already" if pressed else None
        if confirmed(payload, tick, period, log, only):
            _unfix(flight, worksite, plant, log, k, fit)
        return ""
    before = payload.latches
    opens = pressed == "unlatch" and before.hold
    command: Pressed | Literal[""] = pressed or ""
    if opens and not confirmed(payload, tick, period, log, only):
        command = ""
    after, lines = advance(before, berth.time, command, period, (), flight.scenario.arm.model.units)
    seated, blocked = payload.offset_in_berth, False
    if after.drawn != before.drawn:
        left = np.empty(POSE)
        remaining(np.array(payload.offset_at_fixing), after.misaligned, left)
        seated = left.tolist()
        pose = _seated_pose(worksite.frames, fit, left)
        blocked = payload.held and is_blocked(flight, worksite, log, k, pose, "latches")
    for line in lines:
        if line.kind == "refused" or not blocked:
            log.add(line.kind, line.level, line.text)
    if not blocked:
        payload.latches, payload.offset_in_berth = after, seated
        worksite.update_carrier(site, k)
    if payload.latches.motion not in ("", before.motion):
        motion = "closing" if payload.latches.motion == "latch" else "opening"
        log.add(payload.latches.motion, "info", f"latches of the {berth.title} {motion}")
    if not payload.latches.hold:
        _unfix(flight, worksite, plant, log, k, fit)
    return "" if pressed else None


def _fix(site: Site, worksite: WorksiteState, log: Log, k: int, fit: Fit, latches: Latches) -> None:
    """Fix a payload to a berth in the payload's present pose; latches then draw it in from this pose."""
    payload, berth = worksite.payloads[k], fit.berth
    off = fit.offset(worksite.frames, site.payload_rows[k]).tolist()
    payload.berth, payload.latches, payload.offset_at_fixing, payload.offset_in_berth = berth.name, latches, off, off
    worksite.floating[k] = None
    worksite.update_attachments(site)
    if berth.docks:
        log.add("docked", "info", f"{site.payloads[k].title} docked at the {berth.title}")


def _unfix(flight: Flight, worksite: WorksiteState, plant: PlantState, log: Log, k: int, fit: Fit) -> None:
    """Release a payload from its berth. If the end effector does not hold the payload, start its free flight."""
    site, payload, berth = flight.site, worksite.payloads[k], fit.berth
    payload.berth, payload.released_from = "", berth.name
    if payload.held:
        reset_grasp(site, worksite, k)
    else:
        start_free_flight(flight, worksite, plant, k, from_space=berth.frame == "space")
    worksite.update_attachments(site)
    what = "undocked from" if berth.docks else "released by"
    text = f"{site.payloads[k].title} {what} the {berth.title}"
    if payload.held:
        log.add("unseated", "info", text)
    else:
        log.add("unseated", "caution", f"{text}: it floats free")


def _seated_pose(frames: Array, fit: Fit, seated: Array) -> Array:
    """Return a payload's pose (12,) in L; `seated` (12,) is its pose relative to its final pose in the berth."""
    place, out = np.empty(POSE), np.empty(POSE)
    compose(frames[fit.row], fit.place, place)
    compose(place, seated, out)
    return out


def conditions_at(site: Site, worksite: WorksiteState, k: int, fit: Fit) -> tuple[Condition, ...]:
    """Return the conditions for fixing a payload to a berth.

    If another payload is in the berth, the failed condition "seat empty" is added.
    """
    titles = [
        site.payloads[i].title
        for i, payload in enumerate(worksite.payloads)
        if i != k and payload.berth == fit.berth.name
    ]
    occupied = tuple(Condition("seat empty", False, 1.0, 0.0, "", -1.0, f"{title} is in it") for title in titles)
    return (*fit.conditions(worksite.frames, site.payload_rows[k]), *occupied)
