"""The Shuttle arm's snare end effector: wires hold the pin, a carriage draws it in, tension makes the capture rigid.

CAPTURE closes the snare ring. If the pin is then in the capture envelope, the three snare wires hold the pin, the
carriage retracts and draws the pin to its seat, and the tension builds up (rigidize). RELEASE makes the same motions in
reverse order; the pin is free once the ring is open. END EFFECTOR MODE AUTO runs the whole sequence; MAN moves the
snares only, and MAN CONTR moves carriage and tension. Sources: SCOM p. 693 (principle, order of release), SSV (times,
functions of the switches).

A state is an immutable value, which needs no copy when it is saved. Motions are exact in time: when one motion of a
sequence ends within a step, the next motion uses the remaining time. Not modelled: the pull of wires that are still
slack, motor currents, failures.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

import msgspec

from aftdeck.worksite.conditions import Condition, Units, all_hold, failure_text
from aftdeck.worksite.log_line import LogLine, rejection

Mode = Literal["AUTO", "OFF", "MAN"]
Part = Literal["ring", "carriage", "tension"]

_NO_TRAVEL = 1e-9
"""Remaining travel of a part up to which the part counts as arrived [1]. Such a remainder is due to rounding."""


class SnareTimes(msgspec.Struct, frozen=True):
    """Time of each part's travel from end to end."""

    ring: float
    """Time to close or open the snares [s]; SSV has 2.5 s [S]."""
    carriage: float
    """Time to retract or extend the carriage [s]; SSV has 7 s [S]."""
    tension: float
    """Time to rigidize or derigidize [s]; SSV has 4 s [S]."""


class SnareCommand(msgspec.Struct, frozen=True):
    """Positions of the panel's switches, and the trigger in the step in which it is pressed."""

    mode: Mode
    """Position of END EFFECTOR MODE."""
    trigger: Literal["", "capture", "release"] = ""
    contr: Literal["RIGID", "OFF", "DERIGID"] = "OFF"
    """Position of MAN CONTR; it acts in MAN for as long as it is held."""


class Snare(msgspec.Struct, frozen=True):
    """The end effector's state."""

    ring: float = 0.0
    """Position of the snare ring: 0 open, 1 closed."""
    carriage: float = 0.0
    """Position of the carriage: 0 extended, 1 retracted."""
    tension: float = 0.0
    """Tension: 0 derigidized, 1 rigid."""
    captured: bool = False
    """True if the snares hold the pin."""
    drawn: float = 0.0
    """Greatest value of `carriage` since the pin was captured. It is the share of the misalignment that the carriage
    has removed."""
    met: bool = False
    """True if the pin was in the envelope at some time since the snares began to close."""
    motion: Literal["", "capture", "release"] = ""
    """Sequence that the trigger has started; empty if none is in progress."""

    @property
    def misaligned(self) -> float:
        """Share of the misalignment at capture that the carriage has not yet removed."""
        return 1.0 - self.drawn


RIGID = Snare(ring=1.0, carriage=1.0, tension=1.0, captured=True, drawn=1.0)
"""End effector that holds a payload rigidly."""


class Flags(NamedTuple):
    """The end effector's talkbacks, as on the panel."""

    CAPTURE: bool
    EXTEND: bool
    CLOSE: bool
    OPEN: bool
    RIGID: bool
    DERIGID: bool


class Moved(NamedTuple):
    """Result of a step."""

    snare: Snare
    lines: tuple[LogLine, ...]


def flags(snare: Snare) -> Flags:
    """Return the state of the talkbacks. While a part is between its end positions, its talkbacks are off."""
    return Flags(
        CAPTURE=snare.captured,
        EXTEND=snare.carriage == 0.0,
        CLOSE=snare.ring == 1.0,
        OPEN=snare.ring == 0.0,
        RIGID=snare.tension == 1.0,
        DERIGID=snare.tension == 0.0,
    )


def advance(
    snare: Snare, times: SnareTimes, command: SnareCommand, dt: float, conditions: Sequence[Condition], units: Units
) -> Moved:
    """Return the state of the end effector after a step, with the log lines.

    Args:
        snare: the state before the step.
        times: times of the parts.
        command: switches and trigger.
        dt: the step's length [s].
        conditions: conditions of capture at the step's end, from `grapple.in_envelope`; empty if no fixture is near.
            They are used only while the ring is closing.
        units: the operator's units, for the log lines.
    """
    lines: list[LogLine] = []
    if command.trigger and (why := refusal(snare, command)):
        lines.append(rejection(f"{command.trigger.upper()} refused: {why}"))
    elif command.trigger:
        snare = msgspec.structs.replace(snare, motion=command.trigger, met=snare.met and snare.ring > 0.0)
    left = dt
    snare = _without_ended_motion(snare, command.mode)
    while stage := next_stage(snare, command):
        part, target = stage
        speed = 1.0 / float(getattr(times, part))
        before = float(getattr(snare, part))
        if part == "ring" and target == 1.0:
            snare = msgspec.structs.replace(snare, met=snare.met or _inside(conditions))
        if abs(target - before) > left * speed + _NO_TRAVEL:
            snare = _put(snare, part, before + (left * speed if target > before else -left * speed))
            break
        snare = _put(snare, part, target)
        left = max(0.0, left - abs(target - before) / speed)
        snare, more = _reached(snare, part, target, conditions, units)
        snare = _without_ended_motion(snare, command.mode)
        lines += more
    else:
        snare = msgspec.structs.replace(snare, motion="")
    return Moved(snare, tuple(lines))


def refusal(snare: Snare, command: SnareCommand) -> str:
    """Return why the trigger is rejected; empty if it is accepted."""
    if command.mode == "OFF":
        return "END EFFECTOR MODE is OFF; the trigger works in AUTO and MAN"
    extended = _extended(snare)
    if command.trigger == "capture":
        if snare.ring == 1.0 and not snare.captured:
            return "the snares are closed without the pin; RELEASE opens them"
        if not extended and not snare.captured:
            return "the carriage is not extended; MAN CONTR DERIGID, or RELEASE in AUTO, extends it"
        if snare.captured and snare.ring == 1.0 and (command.mode == "MAN" or snare.tension == 1.0):
            return "the pin is already captured"
        return ""
    if snare.ring == 0.0 and snare.motion != "capture" and (extended or command.mode == "MAN"):
        return "the snares are already open"
    if not extended and command.mode == "MAN":
        return "the carriage is not extended; MAN CONTR DERIGID extends it"
    return ""


def next_stage(snare: Snare, command: SnareCommand) -> tuple[Part, float] | None:
    """Return the part that moves next, and its target; None if nothing moves."""
    if command.mode == "OFF":
        return None
    auto = command.mode == "AUTO"
    if snare.motion == "capture" and snare.ring < 1.0:
        return "ring", 1.0
    if snare.motion == "release" and not auto:
        return "ring", 0.0
    if snare.motion == "capture" if auto else command.contr == "RIGID":
        return _next(snare, ("carriage", "tension"), 1.0)
    if snare.motion == "release" if auto else command.contr == "DERIGID":
        return _next(snare, ("tension", "carriage", "ring") if auto else ("tension", "carriage"), 0.0)
    return None


def _without_ended_motion(snare: Snare, mode: Mode) -> Snare:
    """Return the state, with `motion` empty if the mode prevents the motion, or if the motion has ended in MAN."""
    ends = mode == "OFF" or (
        mode == "MAN"
        and (snare.ring == 1.0 if snare.motion == "capture" else not _extended(snare) or snare.ring == 0.0)
    )
    return msgspec.structs.replace(snare, motion="") if ends and snare.motion else snare


def _extended(snare: Snare) -> bool:
    """Return whether the carriage is extended and derigidized, so that the snares may open and close."""
    return snare.carriage == 0.0 and snare.tension == 0.0


def _next(snare: Snare, parts: tuple[Part, ...], target: float) -> tuple[Part, float] | None:
    """Return the first part that is not at the target, and the target; None if all parts are at the target."""
    return next(((part, target) for part in parts if getattr(snare, part) != target), None)


def _put(snare: Snare, part: Part, value: float) -> Snare:
    snare = msgspec.structs.replace(snare, **{part: value})
    if part == "carriage" and snare.captured and value > snare.drawn:
        snare = msgspec.structs.replace(snare, drawn=value)
    return snare


def _inside(conditions: Sequence[Condition]) -> bool:
    """Return whether a fixture is near and within the envelope."""
    return bool(conditions) and all_hold(conditions)


def _reached(
    snare: Snare, part: Part, target: float, conditions: Sequence[Condition], units: Units
) -> tuple[Snare, tuple[LogLine, ...]]:
    """Return the state and the log lines after a part has reached its end position."""
    change = msgspec.structs.replace
    match part, target:
        case "ring", 1.0 if snare.captured:
            return snare, ()
        case "ring", 1.0 if _inside(conditions):
            return change(snare, captured=True, drawn=0.0), (LogLine("captured", "info", "CAPTURE: pin in the snares"),)
        case "ring", 1.0:
            return change(snare, motion=""), (
                LogLine("missed", "caution", f"snares closed empty: {_why(snare, conditions, units)}"),
            )
        case "ring", 0.0 if snare.captured:
            freed = change(snare, captured=False, drawn=0.0)
            return freed, (LogLine("released", "info", "RELEASE: snares open, pin free"),)
        case "tension", 1.0:
            return snare, (LogLine("rigid", "info", "end effector rigid"),)
    return snare, ()


def _why(snare: Snare, conditions: Sequence[Condition], units: Units) -> str:
    """Return why the snares closed without capturing the pin."""
    if not conditions:
        return "no grapple fixture was near"
    why = failure_text(conditions, units)
    return f"the pin left the envelope while they closed: {why}" if snare.met else why
