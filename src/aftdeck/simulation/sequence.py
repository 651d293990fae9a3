"""Automatic motions under way: their end, the points of AUTO 1-4, pause and fly-by, and giving up.

A pause point is flown to and waited at until PROCEED. A fly-by point is only come near: inside its sphere the
arm goes on to the next one without slowing to rest (mode 2; modes 1 and 3 fly to it and go on at once).
"""

from __future__ import annotations

from aftdeck.scenario.target import Target
from aftdeck.simulation.check import command_check, set_course
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.log import log
from aftdeck.simulation.miss import miss
from aftdeck.simulation.standstill import held_fast, standing
from aftdeck.simulation.state import Panel, State
from aftdeck.steering.layout import ANGLE, ARRIVED, DISTANCE, RATIO
from aftdeck.steering.rehearsal import GIVEN_UP, STANDSTILL

_STANDSTILLS = {
    "": "a limit holds the arm at a standstill",
    "contact": "a contact holds the arm at a standstill",
}


def next_target(flight: Flight, panel: Panel) -> Target | None:
    """Where the present automatic mode goes next: the keyed-in pose, or the sequence's point."""
    points = flight.scenario.sequences.get(panel.mode)
    if points is None:
        return panel.keyed
    return points[panel.point].target if panel.point < len(points) else None


def begin(flight: Flight, state: State, target: Target) -> None:
    """Set an automatic motion under way: it sets off with this step, or once the arm stands (`steering.course`)."""
    set_course(state, target, state.command)
    state.panel.target, state.panel.sequence, state.panel.blocked = target, "in progress", 0


def finish(flight: Flight, state: State) -> None:
    """End an automatic motion that the last step has brought to its target, or that a limit holds."""
    panel = state.panel
    if panel.sequence != "in progress":
        return
    points = flight.scenario.sequences.get(panel.mode, ())
    point = points[panel.point] if points else None
    passing = (
        point is not None
        and not point.pause
        and panel.law == "closed loop"
        and panel.point + 1 < len(points)
        and state.report[DISTANCE] <= flight.scenario.fly_by
        and state.report[ANGLE] <= flight.scenario.fly_by_turn
    )
    if state.report[ARRIVED] or passing:
        _arrive(flight, state, passing)
        return
    panel.blocked = panel.blocked + 1 if state.report[RATIO] < STANDSTILL else 0
    if panel.blocked * flight.scenario.control_period >= GIVEN_UP:
        panel.sequence, panel.blocked = "ready", 0
        halt = state.site.halt
        why = held_fast(flight, state) if halt == "seat" else standing(state.panel) or _STANDSTILLS[halt]
        log(flight, state, "blocked", "caution", f"automatic motion given up: {why}")


def _arrive(flight: Flight, state: State, passing: bool) -> None:
    panel = state.panel
    points = flight.scenario.sequences.get(panel.mode, ())
    panel.sequence = "idle"
    if not points:
        _tell_arrival(flight, state, "target", passing)
        return
    _tell_arrival(flight, state, f"{panel.mode}, point {panel.point + 1} of {len(points)}", passing)
    waits = points[panel.point].pause
    panel.point += 1
    if panel.point == len(points):
        panel.target, panel.check = None, None
        log(flight, state, "sequence", "info", f"{panel.mode} complete")
        return
    panel.target = points[panel.point].target
    panel.check = command_check(flight, state, panel.target)
    if not panel.check.good:
        log(flight, state, "check", "caution", f"{panel.mode} stands: CMD CK {panel.check.text}")
    elif waits:
        panel.sequence = "ready"
        log(flight, state, "check", "info", f"pause point: PROCEED goes on; CMD CK {panel.check.text}")
    else:
        begin(flight, state, panel.target)


def _tell_arrival(flight: Flight, state: State, name: str, passing: bool) -> None:
    """Log that a target is passed, reached or missed, and by how much."""
    target = state.panel.target
    beside = "" if passing or target is None else miss(flight, state.arm, state.plant.angles, target)
    if beside:
        log(flight, state, "arrived", "caution", f"{name} missed: the motion ended {beside} it")
    else:
        log(flight, state, "arrived", "info", f"{name} {'passed' if passing else 'reached'}")
