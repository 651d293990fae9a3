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
import numpy as np

from aftdeck.arrays import Array
from aftdeck.law import law
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

    @property
    def packed(self) -> Array:
        """The times as an array (3,)."""
        return np.array([self.ring, self.carriage, self.tension])


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

    @property
    def packed(self) -> Array:
        """The state as an array (7,)."""
        motion = float(MOTIONS.index(self.motion))
        return np.array([self.ring, self.carriage, self.tension, self.captured, self.drawn, self.met, motion])


RING, CARRIAGE, TENSION, CAPTURED, DRAWN, MET, MOTION = range(7)
SNARE = 7
"""Indices in `Snare.packed`, and its length; the first three also in `SnareTimes.packed` and `PARTS`."""
PARTS: tuple[Part, ...] = ("ring", "carriage", "tension")
MODES: tuple[Mode, ...] = ("AUTO", "OFF", "MAN")
AUTO, OFF, MAN = range(3)
CONTRS = ("OFF", "RIGID", "DERIGID")
RIGIDIZES, DERIGIDIZES = 1, 2
MOTIONS: tuple[Literal["", "capture", "release"], ...] = ("", "capture", "release")
CAPTURES, RELEASES = 1, 2


def unpacked(numbers: Array) -> Snare:
    """Return the state from its array (7,)."""
    ring, carriage, tension, captured, drawn, met, motion = numbers.tolist()
    return Snare(ring, carriage, tension, captured != 0.0, drawn, met != 0.0, MOTIONS[int(motion)])


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
        numbers = snare.packed
        begin_motion(numbers, MOTIONS.index(command.trigger))
        snare = unpacked(numbers)
    left = dt
    snare = _without_ended_motion(snare, command.mode)
    while stage := next_stage(snare, command):
        part, target = stage
        numbers = snare.packed
        left = travel(
            numbers, times.packed, MODES.index(command.mode), CONTRS.index(command.contr), left, _inside(conditions)
        )
        snare = unpacked(numbers)
        if left < 0.0:
            break
        snare, more = _reached(snare, part, target, conditions, units)
        snare = _without_ended_motion(snare, command.mode)
        lines += more
    else:
        snare = msgspec.structs.replace(snare, motion="")
    return Moved(snare, tuple(lines))


def refusal(snare: Snare, command: SnareCommand) -> str:
    """Return why the trigger is rejected; empty if it is accepted."""
    return _REFUSALS[refused(snare.packed, MODES.index(command.mode), MOTIONS.index(command.trigger))]


ACCEPTED = 0
"""Result of `refused` if the trigger acts."""
_SWITCHED_OFF, _CLOSED, _RETRACTED, _CAPTURED, _OPEN, _STAYS = range(1, 7)
_REFUSALS = (
    "",
    "END EFFECTOR MODE is OFF; the trigger works in AUTO and MAN",
    "the snares are closed without the pin; RELEASE opens them",
    "the carriage is not extended; MAN CONTR DERIGID, or RELEASE in AUTO, extends it",
    "the pin is already captured",
    "the snares are already open",
    "the carriage is not extended; MAN CONTR DERIGID extends it",
)


@law
def refused(snare: Array, mode: int, trigger: int) -> int:
    """Return the number of the reason for which a trigger is rejected; `ACCEPTED` if it is not.

    Args:
        snare: (7,) `Snare.packed`.
        mode: index of END EFFECTOR MODE in `MODES`.
        trigger: index of the trigger in `MOTIONS`.
    """
    if mode == OFF:
        return _SWITCHED_OFF
    extended, captured = snare[CARRIAGE] == 0.0 and snare[TENSION] == 0.0, snare[CAPTURED] != 0.0
    if trigger == CAPTURES:
        if snare[RING] == 1.0 and not captured:
            return _CLOSED
        if not extended and not captured:
            return _RETRACTED
        if captured and snare[RING] == 1.0 and (mode == MAN or snare[TENSION] == 1.0):
            return _CAPTURED
        return ACCEPTED
    if snare[RING] == 0.0 and snare[MOTION] != CAPTURES and (extended or mode == MAN):
        return _OPEN
    return _STAYS if not extended and mode == MAN else ACCEPTED


@law
def begin_motion(snare: Array, trigger: int) -> None:
    """Begin the sequence of an accepted trigger; arguments as for `refused`."""
    snare[MOTION] = trigger
    if snare[RING] == 0.0:
        snare[MET] = 0.0


def next_stage(snare: Snare, command: SnareCommand) -> tuple[Part, float] | None:
    """Return the part that moves next, and its target; None if nothing moves."""
    part, target = next_part(snare.packed, MODES.index(command.mode), CONTRS.index(command.contr))
    return None if part < 0 else (PARTS[part], target)


@law
def next_part(snare: Array, mode: int, contr: int) -> tuple[int, float]:
    """Return the index of the part that moves next, and its target; -1 if nothing moves.

    Args:
        snare: (7,) `Snare.packed`.
        mode: index of END EFFECTOR MODE in `MODES`.
        contr: index of MAN CONTR in `CONTRS`.
    """
    auto, motion = mode == AUTO, snare[MOTION]
    if mode == OFF:
        return -1, 0.0
    if motion == CAPTURES and snare[RING] < 1.0:
        return RING, 1.0
    if motion == RELEASES and not auto:
        return RING, 0.0
    if motion == CAPTURES if auto else contr == RIGIDIZES:
        if snare[CARRIAGE] != 1.0:
            return CARRIAGE, 1.0
        return (TENSION, 1.0) if snare[TENSION] != 1.0 else (-1, 0.0)
    if motion == RELEASES if auto else contr == DERIGIDIZES:
        if snare[TENSION] != 0.0:
            return TENSION, 0.0
        if snare[CARRIAGE] != 0.0:
            return CARRIAGE, 0.0
        return (RING, 0.0) if auto and snare[RING] != 0.0 else (-1, 0.0)
    return -1, 0.0


@law
def travel(snare: Array, times: Array, mode: int, contr: int, dt: float, inside: bool) -> float:
    """Move the part that moves next towards its target, for the time `dt` [s] or until it arrives.

    Args:
        snare: (7,) `Snare.packed`; changed.
        times: (3,) `SnareTimes.packed`.
        mode: as for `next_part`.
        contr: the same.
        dt: greatest time [s].
        inside: whether a fixture is near and within the envelope; only used while the ring is closing.

    Returns:
        The time that is left once the part has arrived [s]; negative if it has not arrived, or if nothing moves.
    """
    part, target = next_part(snare, mode, contr)
    if part < 0:
        return -1.0
    speed, before = 1.0 / times[part], snare[part]
    if part == RING and target == 1.0 and inside:
        snare[MET] = 1.0
    arrives = not abs(target - before) > dt * speed + _NO_TRAVEL
    if arrives:
        snare[part] = target
    else:
        snare[part] = before + (dt * speed if target > before else -dt * speed)
    if part == CARRIAGE and snare[CAPTURED] != 0.0 and snare[part] > snare[DRAWN]:
        snare[DRAWN] = snare[part]
    return max(0.0, dt - abs(target - before) / speed) if arrives else -1.0


@law
def ends_motion(snare: Array, mode: int) -> bool:
    """Return whether a sequence ends, because the mode prevents it, or because its motion has ended in MAN."""
    if snare[MOTION] == 0.0:
        return False
    if mode == MAN and snare[MOTION] == CAPTURES:
        return bool(snare[RING] == 1.0)
    extended = snare[CARRIAGE] == 0.0 and snare[TENSION] == 0.0
    return bool(mode == OFF or (mode == MAN and (not extended or snare[RING] == 0.0)))


def _without_ended_motion(snare: Snare, mode: Mode) -> Snare:
    """Return the state, with `motion` empty if the sequence ends."""
    return msgspec.structs.replace(snare, motion="") if ends_motion(snare.packed, MODES.index(mode)) else snare


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
