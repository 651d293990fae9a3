"""CMD CK in progress: part of the state, because its rehearsal takes many control steps."""

from __future__ import annotations

from typing import TYPE_CHECKING

import msgspec

from aftdeck.scenario.target import Target
from aftdeck.simulation.frame import Cause
from aftdeck.state_part import Cache, StatePart
from aftdeck.steering.mode import LawChoice
from aftdeck.tuples import Joints

if TYPE_CHECKING:
    from aftdeck.simulation.command_check.rehearsal import Rehearsal
    from aftdeck.simulation.state import State


class Way(msgspec.Struct, frozen=True):
    """Possible motion to a target: a straight line or a joint motion (`operator.ways`). CMD CK may rehearse it."""

    law: LawChoice
    joints: Joints | None
    """Mode 1's final joint angles [rad]; None for a straight line."""
    least: float
    """Lower bound of the duration of the motion [s]; 0 if no bound is known."""
    name: str
    """Text that distinguishes the way from other ways, such as ``wrist flipped``."""


class Tried(msgspec.Struct, frozen=True):
    """Result of the rehearsal of one way."""

    way: Way
    good: bool
    """Whether the motion reaches its target, or a berth fixes the payload; under `strict`, whether the motion ends."""
    cause: Cause
    seconds: float
    """Duration of the motion, or time at which it fails [s]."""
    text: str
    """Reason for the failure, final error of the motion, or berth that fixes the payload."""
    near: str
    """Text about a singularity if the motion passes near one; else empty."""


class Rehearsed(Cache):
    """Cache of the rehearsal in progress.

    Attributes:
        start: state from which the rehearsed motion starts.
        motion: the rehearsal; None until the first step of a way is rehearsed, and again after the state was copied or
            restored.
    """

    def __init__(self) -> None:
        self.start: State | None = None
        self.motion: Rehearsal | None = None

    def copied(self) -> Rehearsed:
        """Return an empty cache, because a copied state needs a rehearsal of its own."""
        return Rehearsed()


class Checking(StatePart):
    """CMD CK in progress.

    Attributes:
        target: target of the motion that is checked.
        start: encoded state from which the motion is rehearsed; None until the arm is at rest.
        ways: ways that have not been rehearsed fully; the first is in progress.
        tried: results of the rehearsals that have ended, one for each way.
        steps: number of steps rehearsed so far for the first of `ways`.
        rehearsal: cache of the rehearsal of the first of `ways`.
    """

    target: Target
    start: bytes | None = None
    ways: list[Way] = msgspec.field(default_factory=list)
    tried: list[Tried] = msgspec.field(default_factory=list)
    steps: int = 0
    rehearsal: Rehearsed = msgspec.field(default_factory=Rehearsed)


class Premises(msgspec.Struct, frozen=True):
    """Values on which a verdict of CMD CK depends; the verdict is valid while these values do not change."""

    target: Target
    law: LawChoice
    rate: str
    held: int | None
    limits: int
    attached: int
    standing: bool
    """Whether BRAKES or SAFING is on."""
    angles: tuple[float, ...]
    """(n,) measured joint angles [rad]."""
    moving: tuple[float, ...]
    """(3,) velocity of the orbiter's translation [m/s]."""
    frames: bytes
    """Digest of the poses of all coordinate frames in L after the last step: frames of the arm, of the worksite, and of
    all payloads (held, fixed or floating)."""
