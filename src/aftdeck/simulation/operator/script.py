"""Inputs from the scenario's script: sticks and switches of its phases. The script replaces an operator.

Source: JSC-12628, phase initialisation of simulated operator inputs. A phase in a manual mode ends at its input time. A
phase in an automatic mode ends at arrival (ETA). A phase in SINGLE ends at its joint angle or time.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.plant.linear_actuator import Slide
from aftdeck.plant.plant import Plant
from aftdeck.scenario.model import PhasePlan, Sequences
from aftdeck.scenario.target import RelativeTarget, Target
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.motion.stopping import is_at_rest
from aftdeck.simulation.operator.relative_target import resolve_target
from aftdeck.simulation.payloads.grasp import carried_by, set_effector
from aftdeck.simulation.state import Panel, Script, State
from aftdeck.steering.layout import AIMS, ARRIVED, DT, RATE, RATE_UP, RATES, SPEED, TURN
from aftdeck.steering.limiters import braked
from aftdeck.steering.mode import MODES
from aftdeck.tuples import Vec3


class Kept(NamedTuple):
    """Stick inputs of a phase, and what they depend on."""

    phase: PhasePlan
    telescope: float
    rules: Array
    inputs: Inputs


def play(flight: Flight, state: State) -> Inputs:
    """Return the script's inputs for the coming step; begin the next phase if the present phase has ended."""
    script, phases = state.script, flight.scenario.phases
    while script.phase < len(phases) and not script.ended:
        phase = phases[script.phase]
        if script.began < 0:
            script.began, state.panel.motion_began = state.tick, state.tick - 1
            state.log(flight.scenario.control_period).add("phase", "info", f"phase {phase.name!r} begins")
            given = phase.target
            target = resolve_target(flight, state.worksite, given) if isinstance(given, RelativeTarget) else given
            if isinstance(target, str):
                _fail(flight, state, f"phase {phase.name!r} failed: {target}")
                continue
            _prepare(flight, state, phase)
            return _first_inputs(phase, target, _sticks(flight, state, phase))
        if MODES[phase.mode].kind == "master":
            state.measure()
        if _has_ended(flight, state, phase, state.tick):
            script.phase, script.began = script.phase + 1, -1
            continue
        return _later_inputs(flight, state, phase)
    if not script.ended and phases:
        script.ended = "completed"
    return Inputs(stop=True)


def hand_over(flight: Flight, state: State) -> None:
    """Cancel the rate limits of the script's phase, because an operator now supplies the inputs."""
    if state.script.limits >= 0:
        state.script.limits = -1
        state.carried = carried_by(flight.scenario, flight.site, state.worksite, state.script)


def _prepare(flight: Flight, state: State, phase: PhasePlan) -> None:
    """Apply JSC-12628's phase initialisation: set the phase's rate limits, and attach or detach its payload."""
    script = state.script
    limits = script.phase if phase.limits is not None else -1
    if limits == script.limits and phase.attaches is None:
        return
    script.limits = limits
    if phase.attaches is not None:
        script.attached = phase.attaches
        set_effector(flight, state.worksite, holding=phase.attaches > 0)
    state.carried = carried_by(flight.scenario, flight.site, state.worksite, state.script)


def end_if_time_is_up(flight: Flight, state: State) -> None:
    """End the script if the scenario's duration ends with this step.

    If the last phase ends at the same time, the script is completed; if a phase is still in progress, the script ends
    with "fault". A scenario without phases ends with "time".
    """
    script, scenario = state.script, flight.scenario
    if script.ended or state.tick < scenario.ticks:
        return
    if not scenario.phases:
        script.ended = "time"
    elif script.phase == len(scenario.phases) - 1 and _has_ended(flight, state, scenario.phases[-1], state.tick + 1):
        script.phase, script.ended = script.phase + 1, "completed"
    elif not script.ended:
        name = phase_name(scenario.phases, script)
        _fail(flight, state, f"the scenario's duration of {scenario.duration:g} s ended in phase {name!r}")


def phase_name(phases: tuple[PhasePlan, ...], script: Script) -> str:
    """Return the name of the present phase, or of the last phase if all have ended; "" if there are no phases."""
    return phases[min(script.phase, len(phases) - 1)].name if phases else ""


def _first_inputs(phase: PhasePlan, target: Target | None, sticks: Inputs) -> Inputs:
    """Return the inputs of a phase's first step: its switches and sticks. Later steps do not repeat the switches."""
    return Inputs(
        mode=phase.mode,
        joint=phase.joint,
        rate=phase.rate,
        law=phase.law,
        payload_axes=phase.payload_axes,
        target=target,
        proceed=MODES[phase.mode].kind == "automatic",
        translation=sticks.translation,
        rotation=sticks.rotation,
        drive=sticks.drive,
        master=phase.master,
        effector=phase.effector,
        latch=phase.latch,
        brakes=phase.brakes,
        safing=phase.safing,
        telescope=sticks.telescope,
        orbiter=phase.orbiter,
    )


def _later_inputs(flight: Flight, state: State, phase: PhasePlan) -> Inputs:
    if state.panel.sequence == "ready" and _between_points(flight.scenario.sequences, state.panel):
        return Inputs(proceed=True)
    if phase.joint_at is None:
        return _sticks(flight, state, phase)
    rules = state.carried.rules[phase.mode, phase.rate, MODES[phase.mode].laws[0]]
    state.measure()
    gap = phase.joint_at - float(state.steering[AIMS + phase.joint])
    rate = braked(abs(gap), float(rules[RATE_UP + phase.joint]), float(rules[DT]))
    drive = min(1.0, rate / float(rules[RATE + phase.joint]))
    telescope = _telescope(flight, state.plant.stand, phase.stand_at)
    return Inputs(drive=drive if gap > 0.0 else -drive, telescope=telescope, orbiter=phase.orbiter)


def _sticks(flight: Flight, state: State, phase: PhasePlan) -> Inputs:
    """Return the stick inputs of a phase in a manual mode. They are kept, because most steps of a phase repeat them."""
    telescope = _telescope(flight, state.plant.stand, phase.stand_at)
    rules = state.carried.rules[phase.mode, phase.rate, MODES[phase.mode].laws[0]]
    kept = state.carried.sticks
    if kept is None or kept.phase is not phase or kept.telescope != telescope or kept.rules is not rules:
        most = float(rules[SPEED]), float(rules[TURN]), float(rules[RATE + phase.joint])
        kept = state.carried.sticks = Kept(phase, telescope, rules, _deflected(phase, telescope, most))
    return kept.inputs


def _deflected(phase: PhasePlan, telescope: float, most: tuple[float, float, float]) -> Inputs:
    """Return the stick inputs of a phase.

    Args:
        phase: the phase.
        telescope: drive of the telescope.
        most: rates at full deflection: POR speed [m/s], POR angular rate [rad/s], joint rate [rad/s].
    """
    speed, turn, rate = most
    drive = phase.drive if phase.joint_rate is None else phase.joint_rate / max(rate, abs(phase.joint_rate))
    return Inputs(
        translation=phase.translation if phase.velocity is None else _deflection(phase.velocity, speed),
        rotation=phase.rotation if phase.angular_velocity is None else _deflection(phase.angular_velocity, turn),
        drive=drive,
        telescope=telescope,
        orbiter=phase.orbiter,
    )


def _deflection(rate: Vec3, most: float) -> Vec3:
    """Return the stick deflection for a velocity; a velocity beyond the limit is reduced and keeps its direction."""
    full = max(most, *map(abs, rate))
    return rate[0] / full, rate[1] / full, rate[2] / full


def _telescope(flight: Flight, stand: Slide, demanded: float | None) -> float:
    """Return the telescope's drive, in [-1, 1], for a demanded length [m]; 0.0 if none is demanded."""
    if demanded is None:
        return 0.0
    return max(-1.0, min(1.0, (demanded - stand.position) / (flight.telescope.rate * flight.scenario.control_period)))


def _between_points(sequences: Sequences, panel: Panel) -> bool:
    """Return whether AUTO 1-4 has reached at least one point of its sequence, but not the last."""
    return 0 < panel.point < len(sequences.get(panel.mode, ()))


def _at_last_point(sequences: Sequences, panel: Panel) -> bool:
    """Return whether the present point is the last point of the sequence."""
    return panel.point + 1 >= len(sequences.get(panel.mode, ()))


def _has_ended(flight: Flight, state: State, phase: PhasePlan, tick: int) -> bool:
    """Return whether a phase has ended before step `tick`. If the phase has failed, end the script with "fault"."""
    elapsed = (tick - state.script.began) * flight.scenario.control_period
    late = phase.duration is not None and elapsed >= phase.duration - 1e-9
    if phase.until is not None or phase.stand_at is not None:
        if _conditions_hold(flight.plant, state, phase):
            return True
        if late:
            _fail(flight, state, f"phase {phase.name!r} failed: not {_awaited(phase)} within its {phase.duration:g} s")
        return False
    if phase.timed:
        return late
    if _arrived(flight, state, phase):
        return True
    if late:
        _fail(flight, state, f"phase {phase.name!r} failed: not done within its {phase.duration:g} s")
    return False


def _arrived(flight: Flight, state: State, phase: PhasePlan) -> bool:
    """Return whether a phase has reached its target. If CMD CK or the motion failed, end the script with "fault"."""
    panel = state.panel
    if MODES[phase.mode].kind == "master":
        late = np.abs(state.plant.angles - state.steering[AIMS : AIMS + len(state.plant.angles)]).max()  # of the servos
        return bool(state.report[ARRIVED] and late < flight.plant.accuracy.angle)
    if phase.joint_at is not None:
        at_angle = abs(phase.joint_at - state.plant.angles[phase.joint]) < flight.plant.accuracy.angle
        return bool(at_angle and abs(state.steering[RATES + phase.joint]) < flight.plant.accuracy.rate)
    if panel.sequence == "idle" and (panel.check is None or panel.check.good):
        return True
    if panel.sequence == "in progress" and state.report[ARRIVED] and _at_last_point(flight.scenario.sequences, panel):
        return True
    if panel.sequence == "idle" or (
        panel.sequence == "ready" and not _between_points(flight.scenario.sequences, state.panel)
    ):
        _fail(flight, state, f"phase {phase.name!r} failed: its motion was rejected or abandoned")
    return False


def _conditions_hold(plant: Plant, state: State, phase: PhasePlan) -> bool:
    """Return whether a phase's end conditions hold: its event has occurred, and the telescope has reached `stand_at`.

    A condition that the phase does not have is ignored.
    """
    at_length = phase.stand_at is None or abs(state.plant.stand.position - phase.stand_at) < plant.accuracy.length
    match phase.until:
        case None:
            return at_length
        case "at rest":
            return at_length and is_at_rest(state)
        case event:
            return at_length and state.worksite.has_occurred(event)


def _awaited(phase: PhasePlan) -> str:
    """Return the conditions for which a phase waits, as text: its event, and its length of the telescope."""
    stand = f"telescope at {phase.stand_at:g} m" if phase.stand_at is not None else ""
    return " and ".join(part for part in (phase.until or "", stand) if part)


def _fail(flight: Flight, state: State, text: str) -> None:
    state.script.ended = "fault"
    state.log(flight.scenario.control_period).add("fault", "warning", text)
