"""Seats: docking at a port, and berthing in the bay with its latches or, in the concept's bay, with its retention.

Remote Manipulator Simulation, mode 3 (docking), and section VII: a payload that is released where it is inserted stays
there. A payload that is both held and fixed to a seat blocks the arm until the hand or the seat releases it.
"""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, compose, pose_of, relative
from aftdeck.simulation.constants.berths import Berth
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.log import log, log_rejection
from aftdeck.simulation.payloads.grasp import regrasp, set_free
from aftdeck.simulation.payloads.latch_command import NEAR, Pressed, confirmed, meant, nearest_berth
from aftdeck.simulation.payloads.mechanism import is_blocked
from aftdeck.simulation.state import State
from aftdeck.worksite.conditions import Condition, all_hold, failure_text, quantity_text
from aftdeck.worksite.seats.berthing import in_guides, places, ready_to_latch, retained
from aftdeck.worksite.seats.docking import DISTANCE, FOUND, approach, docking
from aftdeck.worksite.seats.draw_in import remaining
from aftdeck.worksite.seats.latches import Latches, advance


def seat(flight: Flight, state: State, pressed: Pressed | None) -> None:
    """Fix cargo that reaches its seat, move latches, and carry out `pressed` (latch, unlatch or None)."""
    addressed = meant(flight, state, pressed)
    answer: str | None = None
    for k, thing in enumerate(state.worksite.cargo):
        own = pressed if k == addressed else None
        if thing.seat:
            found = _fixed(flight, state, k, own)
        elif thing.held or own is not None:
            found = _brought(flight, state, k, own)
        else:
            continue
        answer = found if k == addressed else answer
    if pressed and answer != "":
        why = answer or (_far(flight, state) if pressed == "latch" else "no payload is at a seat")
        log_rejection(flight, state, f"{pressed.upper()} refused: {why}")


def _far(flight: Flight, state: State) -> str:
    """Return the reason for rejecting LATCH: which payload is nearest to its place in a seat, and how far away."""
    site, units = flight.site, flight.scenario.arm.model.units
    ways = [
        (math.hypot(*_off(flight, state, k, berth)[:3].tolist()), k, berth.seat.title)
        for k, own in enumerate(site.berths)
        for berth in own
        if not state.worksite.cargo[k].seat
    ]
    if not ways:
        return "no payload has a place in a seat here"
    way, k, title = min(ways)
    near, allowed = quantity_text(way, "m", units), quantity_text(NEAR, "m", units)
    return f"no payload is at a seat: {site.cargo[k].title} is {near} from the {title}, at most {allowed} allowed"


def stay_or_leave(flight: Flight, state: State, k: int) -> None:
    """Keep a just released cargo in the seat where it lies, if the seat's conditions hold; otherwise set it free."""
    thing = state.worksite.cargo[k]
    if thing.seat:
        return
    for berth in flight.site.berths[k]:
        if berth.is_passive and all_hold(conditions_at(flight, state, k, berth)):
            _fix(flight, state, k, berth, Latches(1.0, 1.0))
            return
    set_free(flight, state, k, from_space=False)


def _brought(flight: Flight, state: State, k: int, pressed: Pressed | None) -> str | None:
    """Fix a cargo to the nearest seat if its conditions hold.

    A docking port takes a held cargo without a command; a floating cargo waits for LATCH.

    Returns:
        Result of `pressed` for this cargo: "" if it was carried out or already answered in the log, else the reason
        for its rejection. None if no command applies or no seat is near.
    """
    thing = state.worksite.cargo[k]
    berth = nearest_berth(flight, state, k)
    if berth is None:
        thing.released_from = ""
        return None
    if not (berth.latches_automatically or pressed == "latch" or thing.released_from):
        return None
    if pressed is None and _beyond(flight, state, k, berth):
        thing.released_from = ""
        return None
    conditions, units = conditions_at(flight, state, k, berth), flight.scenario.arm.model.units
    holds = all_hold(conditions)
    if thing.released_from and not (holds and thing.released_from == berth.seat.name):
        thing.released_from = ""
    if berth.latches_automatically:
        if holds and (pressed == "latch" or not thing.released_from):
            thing.released_from = ""
            _fix(flight, state, k, berth, Latches(1.0, 1.0))
            return ""
        return failure_text(conditions, units) if pressed == "latch" else None
    if pressed != "latch":
        return None
    if berth.is_passive and thing.held:
        return failure_text(conditions, units) or f"the {berth.seat.title} keeps what the hand lets go there: RELEASE"
    if berth.is_passive:
        if holds:
            _fix(flight, state, k, berth, Latches(1.0, 1.0))
            log(flight, state, "latched", "info", f"{flight.site.cargo[k].title} kept by the {berth.seat.title}")
        return failure_text(conditions, units)
    latches, said = advance(Latches(), berth.seat.time, "latch", flight.scenario.control_period, conditions, units)
    for line in said:
        log(flight, state, line.kind, line.level, line.text)
    if latches.hold:
        log(flight, state, "latch", "info", f"latches of the {berth.seat.title} closing")
        _fix(flight, state, k, berth, latches)
    return ""


def _fixed(flight: Flight, state: State, k: int, pressed: Pressed | None) -> str | None:
    """Continue or reverse the latches of a cargo that is fixed to a seat, and return the result as `_brought` does."""
    site, worksite = flight.site, state.worksite
    thing = worksite.cargo[k]
    berth = site.berth(k, thing.seat)
    assert berth is not None, "a cargo is fixed only where it has a place"
    if pressed == "latch":
        thing.unlatch_asked_at = 0
    if berth.is_passive:
        lies = f"{site.cargo[k].title} lies in the {berth.seat.title}"
        return f"{lies}, which keeps what the hand lets go there and lets go what it takes" if pressed else None
    if berth.latches_automatically:
        if pressed != "unlatch":
            return f"{site.cargo[k].title} is docked already" if pressed else None
        if not confirmed(flight, state, k, berth.seat.title):
            return ""
        _unfix(flight, state, k, berth)
        return ""
    before = thing.latches
    opens = pressed == "unlatch" and before.hold
    command: Pressed | Literal[""] = pressed or ""
    if opens and not confirmed(flight, state, k, berth.seat.title):
        command = ""
    after, said = advance(
        before, berth.seat.time, command, flight.scenario.control_period, (), flight.scenario.arm.model.units
    )
    seated, halted = thing.offset_in_seat, False
    if after.drawn != before.drawn:
        left = np.empty(POSE)
        remaining(np.array(thing.offset_at_fixing), after.misaligned, left)
        seated = left.tolist()
        halted = thing.held and is_blocked(flight, state, k, _in_seat(state, berth, left), "latches")
    for line in said:
        if line.kind == "refused" or not halted:
            log(flight, state, line.kind, line.level, line.text)
    if not halted:
        thing.latches, thing.offset_in_seat = after, seated
        worksite.update_carrier(site, k)
    if thing.latches.motion not in ("", before.motion):
        way = "closing" if thing.latches.motion == "latch" else "opening"
        log(flight, state, thing.latches.motion, "info", f"latches of the {berth.seat.title} {way}")
    if not thing.latches.hold:
        _unfix(flight, state, k, berth)
    return "" if pressed else None


def _fix(flight: Flight, state: State, k: int, berth: Berth, latches: Latches) -> None:
    """Fix the cargo to the seat at its present pose; the latches then draw it in."""
    worksite = state.worksite
    thing = worksite.cargo[k]
    off = _off(flight, state, k, berth).tolist()
    thing.seat, thing.latches, thing.offset_at_fixing, thing.offset_in_seat = berth.seat.name, latches, off, off
    worksite.floating[k] = None
    worksite.update_attachments(flight.site)
    if berth.latches_automatically:
        log(flight, state, "docked", "info", f"{flight.site.cargo[k].title} docked at the {berth.seat.title}")


def _unfix(flight: Flight, state: State, k: int, berth: Berth) -> None:
    """Release the cargo from its seat; the arm then carries it, or it is free."""
    site, worksite = flight.site, state.worksite
    thing = worksite.cargo[k]
    thing.seat, thing.released_from = "", berth.seat.name
    if thing.held:
        regrasp(flight, state, k)
    else:
        set_free(flight, state, k, from_space=berth.seat.frame == "space")
    worksite.update_attachments(site)
    what = "undocked from" if berth.latches_automatically else "let go by"
    text = f"{site.cargo[k].title} {what} the {berth.seat.title}"
    if thing.held:
        log(flight, state, "unseated", "info", text)
    else:
        log(flight, state, "unseated", "caution", f"{text}: nothing holds it, it is free")


def _in_seat(state: State, berth: Berth, seated: Array) -> Array:
    """Return the pose (12,), in L, of a cargo that has the pose `seated` (12,) relative to its place in a seat."""
    place, out = np.empty(POSE), np.empty(POSE)
    compose(state.worksite.frames[berth.row], berth.place, place)
    compose(place, seated, out)
    return out


def _off(flight: Flight, state: State, k: int, berth: Berth) -> Array:
    """Return a cargo's pose (12,) relative to its place in a seat."""
    frames, place, off = state.worksite.frames, np.empty(POSE), np.empty(POSE)
    compose(frames[berth.row], berth.place, place)
    relative(place, frames[flight.site.cargo_row(k)], off)
    return off


def conditions_at(flight: Flight, state: State, k: int, berth: Berth) -> tuple[Condition, ...]:
    """Return the conditions for fixing the cargo to the seat; "seat empty" is added only if it is occupied."""
    worksite = state.worksite
    there = [
        flight.site.cargo[i].title for i, one in enumerate(worksite.cargo) if i != k and one.seat == berth.seat.name
    ]
    taken = tuple(Condition("seat empty", False, 1.0, 0.0, "", -1.0, f"{title} is in it") for title in there)
    return (*_fitting(flight, state, k, berth), *taken)


def _beyond(flight: Flight, state: State, k: int, berth: Berth) -> bool:
    """Return whether a cargo's probe is beyond the docking distance of a port, so that no other condition matters."""
    if berth.port is None:
        return False
    found = approached(berth, state.worksite.frames, flight.site.cargo_row(k))
    return bool(found[DISTANCE] > berth.docking.distance)


def approached(berth: Berth, frames: Array, cargo_row: int) -> Array:
    """Return the measures (6,) of `worksite.docking` of a cargo's probe at a port; `frames` is (F, 12) in L."""
    assert berth.port is not None
    found, port = np.empty(FOUND), np.empty(POSE)
    compose(frames[berth.row], berth.port, port)
    approach(berth.probe, berth.tip, frames[cargo_row], port, berth.seat.envelope, found)
    return found


def _fitting(flight: Flight, state: State, k: int, berth: Berth) -> tuple[Condition, ...]:
    """Return the conditions on the cargo's pose relative to its place in the seat."""
    if berth.port is not None:
        return docking(approached(berth, state.worksite.frames, flight.site.cargo_row(k)), berth.docking)
    off = _off(flight, state, k, berth)
    if berth.guides is None:
        return retained(pose_of(off), berth.tolerances)
    inside = np.empty(POSE)
    relative(state.worksite.frames[berth.row], state.worksite.frames[flight.site.cargo_row(k)], inside)
    trunnions = places(flight.site.cargo[k].trunnions, pose_of(inside))
    guided = in_guides(trunnions, berth.guides)
    return (*guided, *ready_to_latch(trunnions, pose_of(off), berth.guides, berth.tolerances))
