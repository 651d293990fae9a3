"""The scenario's phases as an operator: what they do with sticks and switches, step by step.

JSC-12628's phase initialisation of simulated operator inputs. A phase ends at its input time in the manual
modes, on arrival (ETA) in the automatic ones, and at its angle or time in SINGLE.
"""

from __future__ import annotations

from aftdeck.scenario.model import PhasePlan
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.log import log
from aftdeck.simulation.state import State
from aftdeck.steering.layout import ARRIVED, DT, RATE, RATE_UP, RATES
from aftdeck.steering.limiters import braked
from aftdeck.steering.mode import MODES

AT_ANGLE = 1e-9
"""How near to `joint_at` a joint has come when its phase ends [rad]."""


def play(flight: Flight, state: State) -> Inputs:
    """The inputs of the coming step; moves on to the next phase where one has ended."""
    script, phases = state.script, flight.scenario.phases
    while script.phase < len(phases) and not script.ended:
        phase = phases[script.phase]
        if script.began < 0:
            script.began = state.tick
            log(flight, state, "phase", "info", f"phase {phase.name!r} begins")
            return _opening(phase)
        if _over(flight, state, phase, state.tick):
            script.phase, script.began = script.phase + 1, -1
            continue
        return _continuing(flight, state, phase)
    if not script.ended and phases:
        script.ended = "completed"
    return Inputs(stop=True)


def conclude(flight: Flight, state: State) -> None:
    """End a script whose time has run out with this step: as completed where its last phase is over just then."""
    script, scenario = state.script, flight.scenario
    if script.ended or state.tick < scenario.ticks:
        return
    if not scenario.phases:
        script.ended = "time"
    elif script.phase == len(scenario.phases) - 1 and _over(flight, state, scenario.phases[-1], state.tick + 1):
        script.phase, script.ended = script.phase + 1, "completed"
    elif not script.ended:
        name = phase_name(flight, state)
        _fail(flight, state, f"the scenario's {scenario.duration:g} s ran out in phase {name!r}")


def phase_name(flight: Flight, state: State) -> str:
    """Name of the phase under way; the last one's once the script has ended."""
    phases = flight.scenario.phases
    return phases[min(state.script.phase, len(phases) - 1)].name if phases else ""


def _opening(phase: PhasePlan) -> Inputs:
    """Switches are set at the first step of a phase, and its sticks move from then on."""
    return Inputs(
        mode=phase.mode,
        joint=phase.joint,
        rate=phase.rate,
        law=phase.law,
        payload_axes=phase.payload_axes,
        target=phase.target,
        proceed=MODES[phase.mode].kind == "automatic",
        translation=phase.translation,
        rotation=phase.rotation,
        drive=phase.drive,
    )


def _continuing(flight: Flight, state: State, phase: PhasePlan) -> Inputs:
    if state.panel.sequence == "ready" and _waiting(flight, state):
        return Inputs(proceed=True)
    if phase.joint_at is None:
        return Inputs(translation=phase.translation, rotation=phase.rotation, drive=phase.drive)
    rules = flight.rules[phase.mode, phase.rate]
    gap = phase.joint_at - float(state.plant.angles[phase.joint])
    rate = braked(abs(gap), float(rules[RATE_UP + phase.joint]), float(rules[DT]))
    drive = min(1.0, rate / float(rules[RATE + phase.joint]))
    return Inputs(drive=drive if gap > 0.0 else -drive)


def _waiting(flight: Flight, state: State) -> bool:
    """Whether AUTO 1-4 stands at a pause point with points to go."""
    panel = state.panel
    return 0 < panel.point < len(flight.scenario.sequences.get(panel.mode, ()))


def _at_last_point(flight: Flight, state: State) -> bool:
    """Whether no point comes after the one flown to."""
    return state.panel.point + 1 >= len(flight.scenario.sequences.get(state.panel.mode, ()))


def _over(flight: Flight, state: State, phase: PhasePlan, tick: int) -> bool:
    """Whether a phase is over before a step; one that cannot end ends the script as a fault."""
    panel = state.panel
    elapsed = (tick - state.script.began) * flight.scenario.control_period
    late = phase.duration is not None and elapsed >= phase.duration - 1e-9
    match MODES[phase.mode].kind:
        case "manual" | "test":
            return late
        case "single":
            if phase.joint_at is None:
                return late
            if abs(phase.joint_at - state.plant.angles[phase.joint]) < AT_ANGLE:
                return bool(abs(state.steering[RATES + phase.joint]) < AT_ANGLE / flight.scenario.control_period)
        case "automatic":
            if panel.sequence == "idle" and (panel.check is None or panel.check.good):
                return True
            if panel.sequence == "in progress" and state.report[ARRIVED] and _at_last_point(flight, state):
                return True
            if panel.sequence == "idle" or (panel.sequence == "ready" and not _waiting(flight, state)):
                _fail(flight, state, f"phase {phase.name!r} failed: its motion was refused or given up")
    if late:
        _fail(flight, state, f"phase {phase.name!r} failed: not done within its {phase.duration:g} s")
    return False


def _fail(flight: Flight, state: State, text: str) -> None:
    state.script.ended = "fault"
    log(flight, state, "fault", "warning", text)
