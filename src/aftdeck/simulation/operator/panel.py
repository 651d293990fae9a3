"""Effects of the operator's switches: selection of modes, keyed-in targets, PROCEED and STOP.

A command that cannot be carried out changes nothing; its rejection is logged.
"""

from __future__ import annotations

from aftdeck.scenario.target import Target
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.log import log, log_rejection
from aftdeck.simulation.motion.standstill import joint_lock_reason
from aftdeck.simulation.operator.check_request import begin_check, premises
from aftdeck.simulation.operator.holds import effective_sticks
from aftdeck.simulation.operator.master import turn_master
from aftdeck.simulation.operator.sequence import finish, next_target
from aftdeck.simulation.state import State
from aftdeck.steering.layout import AIMS, DRIVE, JOINT, KEPT, LAW, MASTER, STICKS
from aftdeck.steering.mode import MODES


def operate(flight: Flight, state: State, inputs: Inputs) -> None:
    """Apply one step's inputs to the panel's switches, and set `state.command`."""
    panel = state.panel
    if state.tick == 1:
        make_ready(flight, state)
    finish(flight, state)
    _set_switches(flight, state, inputs)
    if inputs.mode is not None and inputs.mode != panel.mode:
        _enter(flight, state, inputs.mode)
    if inputs.master is not None:
        state.command[MASTER : MASTER + 6] = inputs.master
    if inputs.target is not None:
        _key_in(flight, state, inputs.target)
    if inputs.stop or joint_lock_reason(panel):
        _stop(flight, state)
    if inputs.proceed:
        _proceed(flight, state)
    command = state.command
    sticks = effective_sticks(flight, state, inputs)
    command[LAW] = panel.flown
    command[STICKS : STICKS + 6] = sticks
    command[JOINT], command[DRIVE] = panel.joint, inputs.drive
    if MODES[panel.mode].kind == "master" and any(sticks):
        turn_master(flight, state)


def _set_switches(flight: Flight, state: State, inputs: Inputs) -> None:
    panel = state.panel
    if inputs.joint is not None and inputs.joint != panel.joint:
        state.command[KEPT + panel.joint] = state.steering[AIMS + panel.joint]  # mode 8 holds this joint from now on
        panel.joint = inputs.joint
    if inputs.rate is not None:
        panel.rate = inputs.rate
    if inputs.payload_axes is not None and inputs.payload_axes != panel.payload_axes:
        panel.payload_axes = inputs.payload_axes
        axes = "payload axes (mode 7)" if panel.payload_axes else "the orbiter's axes (mode 4)"
        log(flight, state, "payload axes", "info", f"ORB LD rotates in {axes}")
    hand = state.worksite
    if inputs.effector is not None:
        hand.switch = inputs.effector
    if inputs.effector_mode is not None:
        hand.effector_mode = inputs.effector_mode
    if inputs.rigid is not None:
        hand.rigid = inputs.rigid
    if inputs.position_hold is not None:
        _hold_position(flight, state, inputs.position_hold)
    if inputs.brakes is not None and inputs.brakes != panel.brakes:
        panel.brakes = inputs.brakes
        text = "BRAKES on" if panel.brakes else "BRAKES off"
        log(flight, state, "brakes", "caution" if panel.brakes else "info", text)
    if inputs.safing is not None and inputs.safing != panel.safing:
        panel.safing = inputs.safing
        text = "SAFING: zero joint rates are commanded" if panel.safing else "SAFING cancelled"
        log(flight, state, "safing", "caution" if panel.safing else "info", text)
    if inputs.law is not None and inputs.law != panel.law:
        if panel.sequence == "in progress":
            log_rejection(
                flight,
                state,
                "change of the law refused: a motion is in progress; STOP first",
            )
        else:
            panel.law = inputs.law
            make_ready(flight, state)


def _hold_position(flight: Flight, state: State, on: bool) -> None:
    panel = state.panel
    if on != panel.position_hold:
        log(flight, state, "position hold", "info", f"POSITION HOLD {'on' if on else 'off'}")
    panel.position_hold, panel.position_hold_target = on, None


def _enter(flight: Flight, state: State, position: str) -> None:
    mode = MODES.get(position)
    if mode is None:
        log_rejection(flight, state, f"mode {position!r} refused: the modes are {', '.join(MODES)}")
        return
    if mode.loaded and state.carried.payload is None:
        log_rejection(flight, state, f"{position} refused: it moves a payload, and none is in the grasp")
        return
    if MODES[position].prestored and position not in flight.scenario.sequences:
        log_rejection(flight, state, f"{position} refused: no points are stored for it in this scenario")
        return
    panel = state.panel
    if mode.kind == "master":  # the master arm starts from the angles of the arm
        state.command[MASTER : MASTER + 6] = state.steering[AIMS : AIMS + 6]
    if mode.kind == "single":  # mode 8 holds the joints at these angles, theta_0
        state.command[KEPT : KEPT + 6] = state.steering[AIMS : AIMS + 6]
    panel.mode, panel.rate_hold_sticks, panel.position_hold_target, panel.point = position, None, None, 0
    panel.motion_began = state.tick - 1
    log(flight, state, "mode", "info", f"{position} entered: {mode.title}")
    make_ready(flight, state)


def make_ready(flight: Flight, state: State, *, keyed: bool = False) -> None:
    """End the present motion and its check, and select the next target.

    In automatic modes, or if a target was just keyed in (`keyed`), request CMD CK of this target.
    """
    panel = state.panel
    panel.sequence, panel.check, panel.target = "idle", None, next_target(flight, panel)
    state.checking, panel.proceeding = None, False
    if panel.target is not None and (keyed or MODES[panel.mode].kind == "automatic"):
        begin_check(state, panel.target)


def _key_in(flight: Flight, state: State, target: Target) -> None:
    panel = state.panel
    if panel.sequence == "in progress":
        log_rejection(flight, state, "target refused: a motion is in progress; STOP first")
        return
    panel.keyed = target
    log(flight, state, "target", "info", "target keyed in")
    make_ready(flight, state, keyed=True)


def _stop(flight: Flight, state: State) -> None:
    panel = state.panel
    panel.rate_hold_sticks = None
    panel.proceeding = False
    if panel.sequence == "in progress":
        panel.sequence = "ready"
        how = "the arm is stopped" if joint_lock_reason(panel) else "the arm slows to rest"
        log(flight, state, "stop", "info", f"STOP: {how}; PROCEED continues the motion")


def _proceed(flight: Flight, state: State) -> None:
    panel = state.panel
    if MODES[panel.mode].kind != "automatic":
        log_rejection(
            flight,
            state,
            f"PROCEED refused: {panel.mode} is not an automatic mode; enter OPR CMD or AUTO 1-4 first",
        )
    elif stopped := joint_lock_reason(panel):
        log_rejection(flight, state, f"PROCEED refused: {stopped}")
    elif panel.sequence != "in progress":
        if panel.point >= len(flight.scenario.sequences.get(panel.mode, ())):
            panel.point = 0  # after its last point, a sequence starts again
        panel.target = next_target(flight, panel)
        if panel.target is None:
            log_rejection(flight, state, "PROCEED refused: no target is keyed in")
            return
        stale = panel.check is None or panel.premises != premises(state, panel.target)
        if state.checking is None and stale:
            begin_check(state, panel.target)  # the arm may have moved since the last check
        panel.proceeding = True
