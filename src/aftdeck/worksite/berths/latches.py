"""Payload retention latches: they close on trunnions that are ready, draw the payload into its berth, and release it.

All latches of a berth move together. Sources: SCOM p. 704 and SSV (times).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

import msgspec

from aftdeck.worksite.conditions import Condition, Units, all_hold, rejection_text
from aftdeck.worksite.log_line import LogLine, rejection

_NO_TRAVEL = 1e-9
"""Greatest remaining travel that counts as a rounding error, and therefore as zero [1]."""


class Latches(msgspec.Struct, frozen=True):
    """State of a berth's latches: an immutable value, which needs no copy when it is saved."""

    closed: float = 0.0
    """Position of the latches: 0 released, 1 latched."""
    drawn: float = 0.0
    """Greatest value of `closed` since the latches began to close. It is the share of the payload's misalignment that
    the latches have removed."""
    motion: Literal["", "latch", "unlatch"] = ""
    """Motion in progress; empty if the latches do not move."""

    @property
    def hold(self) -> bool:
        """Whether the latches hold the payload: they do unless they are completely released."""
        return self.closed > 0.0

    @property
    def misaligned(self) -> float:
        """Remaining misalignment, as a fraction of the misalignment when the latches began to close."""
        return 1.0 - self.drawn


OPEN, SHUT = Latches(), Latches(1.0, 1.0)


class Moved(NamedTuple):
    """Result of a step."""

    latches: Latches
    lines: tuple[LogLine, ...]


def advance(
    latches: Latches,
    time: float,
    command: Literal["", "latch", "unlatch"],
    dt: float,
    conditions: Sequence[Condition],
    units: Units,
) -> Moved:
    """Return the state of the latches after a step, with the log lines.

    Args:
        latches: the state before the step.
        time: time from released to latched [s]; 30 s with two motors, 60 s with one [F]; 0 if they close at once.
        command: command of this step; "" for none. A motion continues to its end without further commands, unless the
            opposite command stops it.
        dt: the step's length [s].
        conditions: conditions of latching, from `berthing.ready_to_latch`; empty if no payload is near. They are used
            only for the command LATCH while the latches are released.
        units: the operator's units, for the log lines.
    """
    lines: list[LogLine] = []
    if command and (why := _rejection(latches, command, conditions, units)):
        lines.append(rejection(why))
    elif command:
        latches = msgspec.structs.replace(latches, motion=command)
    if not latches.motion:
        return Moved(latches, tuple(lines))
    target = 1.0 if latches.motion == "latch" else 0.0
    remaining = target - latches.closed
    travel = dt / time if time > 0.0 else 1.0
    if abs(remaining) > travel + _NO_TRAVEL:
        closed = latches.closed + (travel if remaining > 0.0 else -travel)
        return Moved(_put(latches, closed), tuple(lines))
    if remaining:
        lines.append(
            LogLine("latched", "info", "latched") if target else LogLine("unlatched", "info", "latches released")
        )
    return Moved(msgspec.structs.replace(_put(latches, target), motion=""), tuple(lines))


def _put(latches: Latches, closed: float) -> Latches:
    return msgspec.structs.replace(latches, closed=closed, drawn=max(latches.drawn, closed) if closed else 0.0)


def _rejection(
    latches: Latches, command: Literal["", "latch", "unlatch"], conditions: Sequence[Condition], units: Units
) -> str:
    """Return why a command is rejected; empty if it is accepted."""
    if command == "unlatch":
        return "" if latches.hold else "UNLATCH refused: the latches are already released"
    if latches.closed == 1.0:
        return "LATCH refused: the latches are already closed"
    if latches.hold or (conditions and all_hold(conditions)):
        return ""
    return rejection_text("LATCH", conditions, units) or "LATCH refused: no payload is at the latches"
