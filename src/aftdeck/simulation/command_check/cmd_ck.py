"""CMD CK: rehearsal of the motion to a target, spread over control steps, for the verdict GOOD or FAIL."""

from __future__ import annotations

import numpy as np

from aftdeck.errors import AftdeckError
from aftdeck.plant.spread import NO_SPREAD
from aftdeck.simulation.command_check.rehearsal import Rehearsal
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.frame import Check
from aftdeck.simulation.log import Log
from aftdeck.simulation.motion.standstill import joint_lock_reason, latched_payload_reason
from aftdeck.simulation.operator.check_request import premises
from aftdeck.simulation.operator.sequence import begin
from aftdeck.simulation.operator.ways import ways
from aftdeck.simulation.parts.checking import Checking, Tried
from aftdeck.simulation.resume import resume
from aftdeck.simulation.state import State
from aftdeck.state_part import encoded
from aftdeck.steering.layout import MEASURED
from aftdeck.steering.mode import MODES
from aftdeck.worksite.conditions import quantity_text

STEPS = 50
"""Number of steps that are rehearsed in one control step; their computation takes 1 to 3 ms."""


def check(flight: Flight, state: State, log: Log) -> None:
    """Continue CMD CK. After a GOOD verdict, light READY, or begin the motion if PROCEED was pressed."""
    checking, panel = state.checking, state.panel
    verdict = None if checking is None else _continue_check(flight, state, checking)
    if checking is not None and verdict is not None:
        state.checking = None
        panel.check, panel.premises = verdict, premises(_start(flight, checking) or state, checking.target)
        panel.sequence = "ready" if verdict.good and MODES[panel.mode].kind == "automatic" else "idle"
        log.add("check", "info" if verdict.good else "caution", f"CMD CK {verdict.text}")
        _log_failed_ways(log, checking)
    if panel.proceeding and state.checking is None:
        panel.proceeding = False
        if panel.check is None or not panel.check.good or panel.target is None:
            log.reject(f"PROCEED refused: CMD CK {panel.check.text if panel.check else ''}")
        else:
            begin(state, panel.target, panel.check.joints)
            log.add("proceed", "info", "PROCEED: the arm flies to its target")


def _continue_check(flight: Flight, state: State, checking: Checking) -> Check | None:
    """Continue a check; return None until the check is done.

    In an automatic mode the check waits until the arm is at rest, because the motion starts from rest.
    """
    if checking.start is None:
        state.measure()
        moving = np.abs(state.steering[MEASURED : MEASURED + len(state.plant.angles)]).max() > 0.0
        if moving and MODES[state.panel.mode].kind == "automatic":
            return None
        if stopped := joint_lock_reason(state.panel):
            return Check(False, f"FAIL: {stopped}", cause="switch")
        if latched := latched_payload_reason(flight.site, state.worksite):
            return Check(False, f"FAIL: {latched}", cause="seat")
        try:
            checking.ways = list(ways(flight.scenario, state, checking.target, state.panel.law))
        except AftdeckError as error:
            return Check(False, f"FAIL: {error}", cause="reach")
        checking.rehearsal.start = start = state.fork()
        checking.start = encoded(start)
    return _rehearse_steps(flight, checking)


def _rehearse_steps(flight: Flight, checking: Checking) -> Check | None:
    """Rehearse up to `STEPS` steps; return the verdict once all ways (`operator.ways`) are done, else None."""
    left = STEPS
    while left > 0:
        if not checking.ways and not _more_ways(flight, checking):
            return _verdict(flight, checking)
        way, cache = checking.ways[0], checking.rehearsal
        best = min((tried.seconds for tried in checking.tried if tried.good), default=np.inf)
        if way.least >= best:
            checking.ways.pop(0)
            continue
        if cache.motion is None:
            start = _start(flight, checking)
            assert start is not None, "a rehearsal has a start state"
            cache.motion = Rehearsal(flight.rehearsed, start, checking.target, way)
            cache.motion.advance(checking.steps)  # after a restore, repeat the steps rehearsed before the save
        outcome = cache.motion.advance(left)
        left -= max(cache.motion.steps - checking.steps, 1)
        checking.steps = cache.motion.steps
        if outcome is not None:
            checking.tried.append(outcome)
            checking.ways.pop(0)
            checking.steps, cache.motion = 0, None
    return None


def _start(flight: Flight, checking: Checking) -> State | None:
    """Return the state from which the motion is rehearsed; None before the rehearsal starts."""
    cache = checking.rehearsal
    if cache.start is None and checking.start is not None:
        cache.start = resume(flight.rehearsed, checking.start)
    return cache.start


def _more_ways(flight: Flight, checking: Checking) -> bool:
    """If the ways along a straight line failed, find the ways by joints; return whether there is one to rehearse.

    If a berth or a switch caused the failure, do not look for ways by joints, because these causes stop every motion of
    the arm.
    """
    start, tried = _start(flight, checking), checking.tried
    assert start is not None, "a rehearsal has a start state"
    if any(result.good or result.way.law == "position" or result.cause in ("seat", "switch") for result in tried):
        return False
    try:
        checking.ways = list(ways(flight.scenario, start, checking.target, "position"))
    except AftdeckError:
        return False
    return True


def _verdict(flight: Flight, checking: Checking) -> Check:
    """Return the verdict from the results of all rehearsed ways.

    The rehearsal has no masses; on a plant with masses, the text states by how much the motion can differ.

    GOOD if one or more motions by the selected steering law succeeded; the verdict describes the quickest of them. Else
    FAIL, with the reason why the first motion failed. If a motion in mode 1 (by joints) succeeded, the text of FAIL
    names this motion.
    """
    first, start = checking.tried[0], _start(flight, checking)
    assert start is not None, "a rehearsal has a start state"
    good = sorted((tried for tried in checking.tried if tried.good), key=lambda tried: tried.seconds)
    best = next((tried for tried in good if tried.way.law == first.way.law), None)
    if best is not None:
        parts = [f"GOOD: {best.seconds:.0f} s{_with_masses(flight, start, best)}", best.text, best.near]
        return Check(True, ", ".join(part for part in parts if part), best.seconds, "", best.way.joints)
    when = "" if first.cause == "miss" else f", after {first.seconds:.0f} s"
    why = f"FAIL: {first.text}{when}"
    if good:
        why = f"FAIL in a straight line; GOOD by joints: {good[0].seconds:.0f} s. In the line: {first.text}{when}"
    return Check(False, why, first.seconds, first.cause)


def _with_masses(flight: Flight, start: State, tried: Tried) -> str:
    """Return by how much the motion can differ from its rehearsal, as text; "" on the kinematic plant."""
    spread = flight.plant.spread(tried.way.law, loaded=start.carried.payload is not None)
    if spread == NO_SPREAD:
        return ""
    off = quantity_text(spread.miss, "m", flight.scenario.arm.model.units, figures=2)
    longest = tried.seconds * (1.0 + spread.longer) + spread.later
    later = f"{longest:.0f} s and " if spread.longer or spread.later else ""
    return f" without masses, with masses up to {later}{off} off"


def _log_failed_ways(log: Log, checking: Checking) -> None:
    """Log why each way by joints failed, if more than one way was rehearsed."""
    if len(checking.tried) > 1:
        for tried in checking.tried:
            if not tried.good and tried.way.law == "position":
                text = f"way rejected, {tried.way.name}: {tried.text}, after {tried.seconds:.0f} s"
                log.add("check", "info", text)
