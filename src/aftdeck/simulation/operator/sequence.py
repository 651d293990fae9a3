"""Start and end of automatic motions: to a keyed-in target, or through the points of AUTO 1-4.

At a pause point, the arm stops until PROCEED. In mode 2 the arm does not stop at a fly-by point: inside the sphere
about the point, it continues to the next point. In modes 1 and 3 the arm comes to rest at a fly-by point, and continues
at once. If the arm is at a standstill for too long, the motion is abandoned.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.errors import AftdeckError
from aftdeck.scenario.model import Scenario, Sequences
from aftdeck.scenario.target import Target
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.log import Log
from aftdeck.simulation.motion.standstill import joint_lock_reason, latched_payload_reason
from aftdeck.simulation.operator.check_request import begin_check
from aftdeck.simulation.operator.final_error import final_error_text
from aftdeck.simulation.operator.ways import final_angles
from aftdeck.simulation.state import Ending, Panel, State
from aftdeck.steering.layout import ANGLE, ARRIVED, DISTANCE, LAW, MASTER, MOTION_ACTIVE, PLAN, RATIO, TARGET
from aftdeck.steering.mode import AUTOMATIC_LAWS, LawChoice
from aftdeck.steering.rehearsal import MAX_STOPPED_TIME, STANDSTILL
from aftdeck.tuples import Joints

_STANDSTILLS = {
    "": "a limit holds the arm at a standstill",
    "contact": "a contact holds the arm at a standstill",
}


def next_target(sequences: Sequences, panel: Panel) -> Target | None:
    """Return the next target of the present mode: the sequence's next point in AUTO 1-4, else the keyed-in pose.

    None if there is no next point or no keyed-in pose.
    """
    points = sequences.get(panel.mode)
    if points is None:
        return panel.keyed
    return points[panel.point].target if panel.point < len(points) else None


def begin(state: State, target: Target, joints: Joints | None = None) -> None:
    """Begin an automatic motion. If the arm is moving, it first comes to rest (`steering.course`).

    Args:
        state: state of the run; OPERIN's values are written to its `command`.
        target: final pose of the tip.
        joints: mode 1's final joint angles [rad]; if None, `ways.final_angles` computes them.

    Raises:
        UnreachableError, SingularityError: no joint angles put the tip at the target.
    """
    command, panel = state.command, state.panel
    final = final_angles(state, target) if joints is None else joints
    command[LAW], command[MOTION_ACTIVE] = AUTOMATIC_LAWS[panel.law], 0.0
    command[TARGET : TARGET + 3] = target.position
    command[TARGET + 3 : TARGET + 12] = np.ravel(target.rotation)
    command[PLAN:MASTER] = 0.0
    command[PLAN : PLAN + len(final)] = final
    panel.target, panel.sequence, panel.blocked = target, "in progress", 0


def finish(flight: Flight, state: State, log: Log) -> bool:
    """End the automatic motion if it reached its target in the last step, or if the arm stood still for too long.

    Return whether it has ended, or goes on to the next point.
    """
    panel = state.panel
    panel.ending, panel.final_error = "", ""
    if panel.sequence != "in progress":
        return False
    distance, turn = fly_by(flight.scenario, panel)
    passing = bool(state.report[DISTANCE] <= distance and state.report[ANGLE] <= turn)
    still = state.report[RATIO] < STANDSTILL
    inside = flight.plant.has_servos and _inside(flight.scenario, state.panel.law, state.command, state.report)
    if inside or state.report[ARRIVED] or passing or (still and not _final_error(flight, state)):
        _arrive(flight, state, log, passing, inside=inside)
        return True
    panel.blocked = panel.blocked + 1 if still else 0
    abandoned = panel.blocked * flight.scenario.control_period >= MAX_STOPPED_TIME
    if abandoned:
        panel.sequence, panel.blocked, panel.ending = "ready", 0, "given up"
        halt = state.worksite.halt
        why = (
            latched_payload_reason(flight.site, state.worksite)
            if halt == "seat"
            else joint_lock_reason(state.panel) or _STANDSTILLS[halt]
        )
        log.add("blocked", "caution", f"automatic motion abandoned: {why}")
    return abandoned


def fly_by(scenario: Scenario, panel: Panel) -> tuple[float, float]:
    """Return the distance [m] and the angle [rad] within which mode 2 goes on to the next point; -1 if it does not."""
    points = scenario.sequences.get(panel.mode, ())
    goes_on = bool(points) and panel.law == "closed loop" and panel.point + 1 < len(points)
    if not goes_on or points[panel.point].pause:
        return -1.0, -1.0
    return scenario.fly_by, scenario.fly_by_turn


def _inside(scenario: Scenario, law: LawChoice, command: Array, report: Array) -> bool:
    """Return whether mode 2 has brought the tip into the end sphere.

    With servos, mode 2 ends there without waiting for rest: an arm that bends never comes to rest under mode 2, whose
    demanded speed changes too steeply with the distance near the target.
    """
    if scenario.strict or law != "closed loop" or command[MOTION_ACTIVE] == 0.0:
        return False
    return bool(report[DISTANCE] <= scenario.near and report[ANGLE] <= scenario.near_turn)


def _final_error(flight: Flight, state: State) -> str:
    """Return the final error at the present target as text; "" if the target is reached or there is no target."""
    target = state.panel.target
    return "" if target is None else final_error_text(flight.scenario, state.arm, state.plant.angles, target)


def _arrive(flight: Flight, state: State, log: Log, passing: bool, *, inside: bool) -> None:
    """Start the motion to a sequence's next point, wait for PROCEED at a pause point, or end the motion.

    If the encoders have seen the tip inside the end sphere (`inside`), the target is reached, although an arm with
    masses still moves.
    """
    panel = state.panel
    points = flight.scenario.sequences.get(panel.mode, ())
    final_error = "" if passing or inside else _final_error(flight, state)
    name = f"{panel.mode}, point {panel.point + 1} of {len(points)}" if points else "target"
    _log_arrival(log, name, passing, final_error)
    continues = bool(points) and panel.point + 1 < len(points) and not points[panel.point].pause
    panel.point += 1 if points else 0
    if continues:
        try:
            begin(state, points[panel.point].target)
            if passing:  # mode 2 does not plan from rest, so the arm need not come to rest first
                state.command[MOTION_ACTIVE], panel.motion_began = 1.0, state.tick - 1
        except AftdeckError as error:
            _end(panel, "given up", final_error)
            log.add("check", "caution", f"{panel.mode} stopped: {error}")
        return
    _end(panel, "missed" if final_error else "reached", final_error)
    if not points:
        return
    if panel.point == len(points):
        panel.target, panel.check = None, None
        log.add("sequence", "info", f"{panel.mode} complete")
        return
    panel.target = points[panel.point].target
    log.add("sequence", "info", "pause point: PROCEED continues the sequence")
    begin_check(state, panel.target)


def _end(panel: Panel, ending: Ending, final_error: str) -> None:
    panel.sequence, panel.ending, panel.final_error = "idle", ending, final_error


def _log_arrival(log: Log, name: str, passing: bool, final_error: str) -> None:
    """Log that a target was passed, reached or missed, with the final error."""
    if final_error:
        log.add("arrived", "caution", f"{name} missed: final error {final_error}")
    else:
        log.add("arrived", "info", f"{name} {'passed' if passing else 'reached'}")
