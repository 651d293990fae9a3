"""Payload retention latches: they close on trunnions that are ready, draw the payload into its seat, and open again.

All latches of a seat go together. Sources: SCOM p. 704 and SSV (times).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

import msgspec

from aftdeck.worksite.conditions import Condition, all_hold, refusal
from aftdeck.worksite.said import Said, refused

_THERE = 1e-9
"""Latches so near to their end [1] are there: rounding, not travel."""


class Latches(msgspec.Struct, frozen=True):
    """The state of a seat's latches; a frozen value and so its own save."""

    closed: float = 0.0
    """0 released, 1 latched."""
    drawn: float = 0.0
    """How far the payload has been drawn in since they began to close: their farthest."""
    motion: Literal["", "latch", "unlatch"] = ""

    @property
    def hold(self) -> bool:
        """Whether they hold the payload: from when they begin to close until they are released."""
        return self.closed > 0.0

    @property
    def misaligned(self) -> float:
        """The fraction that is left of the misalignment at which they began to close."""
        return 1.0 - self.drawn


class Moved(NamedTuple):
    """A step's result."""

    latches: Latches
    said: tuple[Said, ...]


def advance(
    latches: Latches,
    time: float,
    command: Literal["", "latch", "unlatch"],
    dt: float,
    conditions: Sequence[Condition],
) -> Moved:
    """The state after a step.

    Args:
        latches: the state before it.
        time: from released to latched [s]; 30 s with two motors, 60 s with one [F].
        command: given in this step; a motion goes on to its end by itself, or until the other command.
        dt: the step's length [s].
        conditions: of latching, as `berthing.ready_to_latch` says them; empty where no payload is near. They matter
            only for LATCH on released latches.
    """
    said: list[Said] = []
    if command and (why := _refusal(latches, command, conditions)):
        said.append(refused(why))
    elif command:
        latches = msgspec.structs.replace(latches, motion=command)
    if not latches.motion:
        return Moved(latches, tuple(said))
    target = 1.0 if latches.motion == "latch" else 0.0
    way = target - latches.closed
    travel = dt / time
    if abs(way) > travel + _THERE:
        closed = latches.closed + (travel if way > 0.0 else -travel)
        return Moved(_put(latches, closed), tuple(said))
    if way:
        said.append(Said("latched", "info", "latched") if target else Said("unlatched", "info", "latches released"))
    return Moved(msgspec.structs.replace(_put(latches, target), motion=""), tuple(said))


def _put(latches: Latches, closed: float) -> Latches:
    return msgspec.structs.replace(latches, closed=closed, drawn=max(latches.drawn, closed) if closed else 0.0)


def _refusal(latches: Latches, command: Literal["", "latch", "unlatch"], conditions: Sequence[Condition]) -> str:
    """Why a command is not obeyed; empty where it is."""
    if command == "unlatch":
        return "" if latches.hold else "UNLATCH refused: the latches are released already"
    if latches.closed == 1.0:
        return "LATCH refused: latched already"
    if latches.hold or (conditions and all_hold(conditions)):
        return ""
    return refusal("LATCH", conditions) or "LATCH refused: no payload is at the latches"
