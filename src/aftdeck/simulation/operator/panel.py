"""Effects of the operator's switches: selection of modes, keyed-in targets, PROCEED and STOP.

A command that cannot be carried out changes nothing; its rejection is logged.
"""

from __future__ import annotations

from aftdeck.scenario.model import Sequences
from aftdeck.scenario.target import Target
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.log import Log
from aftdeck.simulation.motion.standstill import joint_lock_reason
from aftdeck.simulation.operator.check_request import begin_check, premises
from aftdeck.simulation.operator.holds import effective_sticks
from aftdeck.simulation.operator.master import axes_of, turn_master
from aftdeck.simulation.operator.sequence import finish, next_target
from aftdeck.simulation.state import Panel, State
from aftdeck.steering.layout import AIMS, KEPT, MASTER
from aftdeck.steering.mode import MODES


def operate(flight: Flight, state: State, log: Log, inputs: Inputs, *, finished: bool = False) -> None:
    """Apply one step's inputs to the panel's switches, and set `state.command`.

    `finished`: whether `finish` has been called in this step.
    """
    panel, sequences = state.panel, flight.scenario.sequences
    if state.tick == 1:
        make_ready(sequences, state)
    if not finished:
        finish(flight, state, log)
    _set_switches(sequences, state, log, inputs)
    if inputs.mode is not None and inputs.mode != panel.mode:
        _enter(sequences, state, log, inputs.mode)
    if inputs.master is not None:
        state.command[MASTER : MASTER + len(inputs.master)] = inputs.master
    if inputs.target is not None:
        _key_in(sequences, state, log, inputs.target)
    if inputs.stop or joint_lock_reason(panel):
        _stop(panel, log)
    if inputs.proceed:
        _proceed(sequences, state, log)
    order(flight, state, log, inputs)


def order(flight: Flight, state: State, log: Log, inputs: Inputs) -> None:
    """Write the sticks that act into `state.command`."""
    panel = state.panel
    sticks = effective_sticks(panel, log, inputs)
    state.row.order(panel.flown, sticks, panel.joint, inputs.drive)
    if MODES[panel.mode].kind == "master" and any(sticks):
        turn_master(axes_of(flight.scenario.arm.model), state.rules, state.command, flight.scenario.control_period)


def _set_switches(sequences: Sequences, state: State, log: Log, inputs: Inputs) -> None:
    panel = state.panel
    if inputs.joint is not None and inputs.joint != panel.joint:
        state.measure()
        state.command[KEPT + panel.joint] = state.steering[AIMS + panel.joint]  # mode 8 holds this joint from now on
        panel.joint = inputs.joint
    if inputs.rate is not None:
        panel.rate = inputs.rate
    if inputs.payload_axes is not None and inputs.payload_axes != panel.payload_axes:
        panel.payload_axes = inputs.payload_axes
        axes = "payload axes (mode 7)" if panel.payload_axes else "the orbiter's axes (mode 4)"
        log.add("payload axes", "info", f"ORB LD rotates in {axes}")
    hand = state.worksite
    if inputs.effector is not None:
        hand.switch = inputs.effector
    if inputs.effector_mode is not None:
        hand.effector_mode = inputs.effector_mode
    if inputs.rigid is not None:
        hand.rigid = inputs.rigid
    if inputs.position_hold is not None:
        _hold_position(panel, log, on=inputs.position_hold)
    if inputs.brakes is not None and inputs.brakes != panel.brakes:
        panel.brakes = inputs.brakes
        text = "BRAKES on" if panel.brakes else "BRAKES off"
        log.add("brakes", "caution" if panel.brakes else "info", text)
    if inputs.safing is not None and inputs.safing != panel.safing:
        panel.safing = inputs.safing
        text = "SAFING: zero joint rates are commanded" if panel.safing else "SAFING cancelled"
        log.add("safing", "caution" if panel.safing else "info", text)
    if inputs.law is not None and inputs.law != panel.law:
        if panel.sequence == "in progress":
            log.reject("change of the law refused: a motion is in progress; STOP first")
        else:
            panel.law = inputs.law
            make_ready(sequences, state)


def _hold_position(panel: Panel, log: Log, *, on: bool) -> None:
    if on != panel.position_hold:
        log.add("position hold", "info", f"POSITION HOLD {'on' if on else 'off'}")
    panel.position_hold, panel.position_hold_target = on, None


def _enter(sequences: Sequences, state: State, log: Log, position: str) -> None:
    mode = MODES.get(position)
    if mode is None:
        log.reject(f"mode {position!r} refused: the modes are {', '.join(MODES)}")
        return
    if mode.loaded and state.carried.payload is None:
        log.reject(f"{position} refused: it moves a payload, and none is in the grasp")
        return
    if MODES[position].prestored and position not in sequences:
        log.reject(f"{position} refused: no points are stored for it in this scenario")
        return
    panel, joints = state.panel, len(state.plant.angles)
    state.measure()
    if mode.kind == "master":  # the master arm starts from the angles of the arm
        state.command[MASTER : MASTER + joints] = state.steering[AIMS : AIMS + joints]
    if mode.kind == "single":  # mode 8 holds the joints at these angles, theta_0
        state.command[KEPT : KEPT + joints] = state.steering[AIMS : AIMS + joints]
    panel.mode, panel.rate_hold_sticks, panel.position_hold_target, panel.point = position, None, None, 0
    panel.motion_began = state.tick - 1
    log.add("mode", "info", f"{position} entered: {mode.title}")
    make_ready(sequences, state)


def make_ready(sequences: Sequences, state: State, *, keyed: bool = False) -> None:
    """End the present motion and its check, and select the next target.

    In automatic modes, or if a target was just keyed in (`keyed`), request CMD CK of this target.
    """
    panel = state.panel
    panel.sequence, panel.check, panel.target = "idle", None, next_target(sequences, panel)
    state.checking, panel.proceeding = None, False
    if panel.target is not None and (keyed or MODES[panel.mode].kind == "automatic"):
        begin_check(state, panel.target)


def _key_in(sequences: Sequences, state: State, log: Log, target: Target) -> None:
    panel = state.panel
    if panel.sequence == "in progress":
        log.reject("target refused: a motion is in progress; STOP first")
        return
    panel.keyed = target
    log.add("target", "info", "target keyed in")
    make_ready(sequences, state, keyed=True)


def _stop(panel: Panel, log: Log) -> None:
    panel.rate_hold_sticks = None
    panel.proceeding = False
    if panel.sequence == "in progress":
        panel.sequence = "ready"
        how = "the arm is stopped" if joint_lock_reason(panel) else "the arm slows to rest"
        log.add("stop", "info", f"STOP: {how}; PROCEED continues the motion")


def _proceed(sequences: Sequences, state: State, log: Log) -> None:
    panel = state.panel
    if MODES[panel.mode].kind != "automatic":
        log.reject(f"PROCEED refused: {panel.mode} is not an automatic mode; enter OPR CMD or AUTO 1-4 first")
    elif stopped := joint_lock_reason(panel):
        log.reject(f"PROCEED refused: {stopped}")
    elif panel.sequence != "in progress":
        if panel.point >= len(sequences.get(panel.mode, ())):
            panel.point = 0  # after its last point, a sequence starts again
        panel.target = next_target(sequences, panel)
        if panel.target is None:
            log.reject("PROCEED refused: no target is keyed in")
            return
        stale = panel.check is None or panel.premises != premises(state, panel.target)
        if state.checking is None and stale:
            begin_check(state, panel.target)  # the arm may have moved since the last check
        panel.proceeding = True
