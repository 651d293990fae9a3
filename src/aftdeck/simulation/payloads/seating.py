"""Fixing and release of payloads by berths: docking at a port, latching in the bay, and passive berths.

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
from aftdeck.simulation.constants.berths import Berth
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.log import Log
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.payloads.grasp import reset_grasp, start_free_flight, update_steering
from aftdeck.simulation.payloads.latch_command import NEAR, Pressed, addressed, confirmed, nearest_berth
from aftdeck.simulation.payloads.mechanism import is_blocked
from aftdeck.simulation.state import State
from aftdeck.worksite.conditions import Condition, Units, all_hold, failure_text, quantity_text
from aftdeck.worksite.seats.berthing import in_guides, ready_to_latch, retained
from aftdeck.worksite.seats.docking import DISTANCE, FOUND, approach, docking
from aftdeck.worksite.seats.draw_in import remaining
from aftdeck.worksite.seats.latches import Latches, advance


def seat(flight: Flight, state: State, log: Log, pressed: Pressed | None) -> None:
    """Fix payloads to ports, move latches, and execute LATCH or UNLATCH (`pressed`; None if neither is pressed)."""
    site, worksite = flight.site, state.worksite
    index = addressed(site, worksite, pressed)
    answer: str | None = None
    for k, payload in enumerate(worksite.cargo):
        own = pressed if k == index else None
        if payload.seat and own is None and not payload.latches.motion:
            continue
        if payload.seat:
            found = _update_fixed(flight, state, log, k, own)
        elif payload.held or own is not None:
            found = _update_unfixed(flight, worksite, log, k, own)
        else:
            continue
        answer = found if k == index else answer
    if pressed and answer != "":
        units = flight.scenario.arm.model.units
        why = answer or (
            _nearest_seat_text(site, worksite, units) if pressed == "latch" else "no payload is at a berth"
        )
        log.reject(f"{pressed.upper()} refused: {why}")


def _nearest_seat_text(site: Site, worksite: WorksiteState, units: Units) -> str:
    """Return the reason for rejecting LATCH, as text.

    The text names the unfixed payload that is nearest to its pose in a berth, and its distance from this pose.
    """
    distances = [
        (length(berth.offset(worksite.frames, site.cargo_row(k))[:3].tolist()), k, berth.seat.title)
        for k, own in enumerate(site.berths)
        for berth in own
        if not worksite.cargo[k].seat
    ]
    if not distances:
        return "no berth of this worksite accepts a payload that is not fixed already"
    distance, k, title = min(distances)
    near, allowed = quantity_text(distance, "m", units), quantity_text(NEAR, "m", units)
    return f"no payload is at a berth: {site.cargo[k].title} is {near} from the {title}, at most {allowed} allowed"


def stay_or_leave(flight: Flight, worksite: WorksiteState, plant: PlantState, log: Log, k: int) -> None:
    """Fix a payload to a passive berth after its release, or start its free flight.

    The payload is fixed if the conditions of a passive berth hold. A payload that is already fixed stays fixed.
    """
    if worksite.cargo[k].seat:
        return
    for berth in flight.site.berths[k]:
        if berth.is_passive and all_hold(conditions_at(flight.site, worksite, k, berth)):
            _fix(flight.site, worksite, log, k, berth, Latches(1.0, 1.0))
            return
    start_free_flight(flight, worksite, plant, k, from_space=False)


def _update_unfixed(flight: Flight, worksite: WorksiteState, log: Log, k: int, pressed: Pressed | None) -> str | None:
    """Fix a payload to the nearest berth if the conditions of this berth hold.

    A docking port fixes a held payload without a command, and a floating payload on LATCH.

    Returns:
        Answer to `pressed` for this payload: "" if the command was executed, or if the log already contains the answer;
        the reason if LATCH was rejected; None if LATCH was not pressed for this payload, or if no berth is near.
    """
    site, payload = flight.site, worksite.cargo[k]
    berth = nearest_berth(site, worksite.frames, k)
    if berth is None:
        payload.released_from = ""
        return None
    if not (berth.latches_automatically or pressed == "latch" or payload.released_from):
        return None
    if pressed is None and _beyond(site, worksite.frames, k, berth):
        payload.released_from = ""
        return None
    conditions, units = conditions_at(site, worksite, k, berth), flight.scenario.arm.model.units
    holds = all_hold(conditions)
    if payload.released_from and not (holds and payload.released_from == berth.seat.name):
        payload.released_from = ""
    if berth.latches_automatically:
        if holds and (pressed == "latch" or not payload.released_from):
            payload.released_from = ""
            _fix(site, worksite, log, k, berth, Latches(1.0, 1.0))
            return ""
        return failure_text(conditions, units) if pressed == "latch" else None
    if pressed != "latch":
        return None
    if berth.is_passive and payload.held:
        return failure_text(conditions, units) or f"the {berth.seat.title} fixes the payload on RELEASE"
    if berth.is_passive:
        if holds:
            _fix(site, worksite, log, k, berth, Latches(1.0, 1.0))
            log.add("latched", "info", f"{site.cargo[k].title} stays in the {berth.seat.title}")
        return failure_text(conditions, units)
    latches, lines = advance(Latches(), berth.seat.time, "latch", flight.scenario.control_period, conditions, units)
    for line in lines:
        log.add(line.kind, line.level, line.text)
    if latches.hold:
        log.add("latch", "info", f"latches of the {berth.seat.title} closing")
        _fix(site, worksite, log, k, berth, latches)
    return ""


def _update_fixed(flight: Flight, state: State, log: Log, k: int, pressed: Pressed | None) -> str | None:
    """Update a payload that is fixed to a berth: continue or reverse the latches, or undock the payload.

    Returns:
        Answer to `pressed` for this payload: "", the reason for a rejection, or None, as in `_update_unfixed`.
    """
    site, worksite, period = flight.site, state.worksite, flight.scenario.control_period
    payload, title = worksite.cargo[k], site.cargo[k].title
    berth = site.berth(k, payload.seat)
    assert berth is not None, "a fixed payload has a berth"
    if pressed == "latch":
        payload.unlatch_asked_at = 0
    if berth.is_passive:
        where = f"{title} is in the {berth.seat.title}"
        return f"{where}, which frees it at capture" if pressed else None
    only = f"nothing but the {berth.seat.title} holds {title}"
    if berth.latches_automatically:
        if pressed != "unlatch":
            return f"{title} is docked already" if pressed else None
        if confirmed(payload, state.tick, period, log, only):
            _unfix(flight, worksite, state.plant, log, k, berth)
            update_steering(flight, state)
        return ""
    before = payload.latches
    opens = pressed == "unlatch" and before.hold
    command: Pressed | Literal[""] = pressed or ""
    if opens and not confirmed(payload, state.tick, period, log, only):
        command = ""
    after, lines = advance(before, berth.seat.time, command, period, (), flight.scenario.arm.model.units)
    seated, blocked = payload.offset_in_seat, False
    if after.drawn != before.drawn:
        left = np.empty(POSE)
        remaining(np.array(payload.offset_at_fixing), after.misaligned, left)
        seated = left.tolist()
        pose = _seated_pose(worksite.frames, berth, left)
        blocked = payload.held and is_blocked(flight, worksite, log, k, pose, "latches")
    for line in lines:
        if line.kind == "refused" or not blocked:
            log.add(line.kind, line.level, line.text)
    if not blocked:
        payload.latches, payload.offset_in_seat = after, seated
        worksite.update_carrier(site, k)
    if payload.latches.motion not in ("", before.motion):
        motion = "closing" if payload.latches.motion == "latch" else "opening"
        log.add(payload.latches.motion, "info", f"latches of the {berth.seat.title} {motion}")
    if not payload.latches.hold:
        _unfix(flight, worksite, state.plant, log, k, berth)
        update_steering(flight, state)
    return "" if pressed else None


def _fix(site: Site, worksite: WorksiteState, log: Log, k: int, berth: Berth, latches: Latches) -> None:
    """Fix a payload to a berth in the payload's present pose; latches then draw it in from this pose."""
    payload = worksite.cargo[k]
    off = berth.offset(worksite.frames, site.cargo_row(k)).tolist()
    payload.seat, payload.latches, payload.offset_at_fixing, payload.offset_in_seat = berth.seat.name, latches, off, off
    worksite.floating[k] = None
    worksite.update_attachments(site)
    if berth.latches_automatically:
        log.add("docked", "info", f"{site.cargo[k].title} docked at the {berth.seat.title}")


def _unfix(flight: Flight, worksite: WorksiteState, plant: PlantState, log: Log, k: int, berth: Berth) -> None:
    """Release a payload from its berth. If the end effector does not hold the payload, start its free flight."""
    site, payload = flight.site, worksite.cargo[k]
    payload.seat, payload.released_from = "", berth.seat.name
    if payload.held:
        reset_grasp(site, worksite, k)
    else:
        start_free_flight(flight, worksite, plant, k, from_space=berth.seat.frame == "space")
    worksite.update_attachments(site)
    what = "undocked from" if berth.latches_automatically else "released by"
    text = f"{site.cargo[k].title} {what} the {berth.seat.title}"
    if payload.held:
        log.add("unseated", "info", text)
    else:
        log.add("unseated", "caution", f"{text}: it floats free")


def _seated_pose(frames: Array, berth: Berth, seated: Array) -> Array:
    """Return a payload's pose (12,) in L; `seated` (12,) is its pose relative to its final pose in the berth."""
    place, out = np.empty(POSE), np.empty(POSE)
    compose(frames[berth.row], berth.place, place)
    compose(place, seated, out)
    return out


def conditions_at(site: Site, worksite: WorksiteState, k: int, berth: Berth) -> tuple[Condition, ...]:
    """Return the conditions for fixing a payload to a berth.

    If another payload is in the berth, the failed condition "seat empty" is added.
    """
    titles = [
        site.cargo[i].title for i, payload in enumerate(worksite.cargo) if i != k and payload.seat == berth.seat.name
    ]
    occupied = tuple(Condition("seat empty", False, 1.0, 0.0, "", -1.0, f"{title} is in it") for title in titles)
    return (*_fitting(site, worksite.frames, k, berth), *occupied)


def _beyond(site: Site, frames: Array, k: int, berth: Berth) -> bool:
    """Return whether a berth is a port, and the payload's probe is farther from the port than the docking distance."""
    if berth.port is None:
        return False
    found = approached(berth, frames, site.cargo_row(k))
    return bool(found[DISTANCE] > berth.docking.distance)


def approached(berth: Berth, frames: Array, cargo_row: int) -> Array:
    """Return the results (6,) of `worksite.seats.docking.approach` for a payload's probe at a port.

    Args:
        berth: constants for fixing the payload to the port.
        frames: (F, 12) poses of all frames in L.
        cargo_row: row of the payload's frame.
    """
    assert berth.port is not None
    found, port = np.empty(FOUND), np.empty(POSE)
    compose(frames[berth.row], berth.port, port)
    approach(berth.probe, berth.tip, frames[cargo_row], port, berth.seat.envelope, found)
    return found


def _fitting(site: Site, frames: Array, k: int, berth: Berth) -> tuple[Condition, ...]:
    """Return the conditions on a payload's pose relative to its final pose in a berth."""
    if berth.port is not None:
        return docking(approached(berth, frames, site.cargo_row(k)), berth.docking)
    off = berth.offset(frames, site.cargo_row(k))
    if berth.guides is None:
        return retained(off, berth.tolerances)
    trunnions = berth.trunnion_offsets(frames, site.cargo_row(k), site.cargo[k].trunnions)
    guided = in_guides(trunnions, berth.guides)
    return (*guided, *ready_to_latch(trunnions, off, berth.guides, berth.tolerances))
