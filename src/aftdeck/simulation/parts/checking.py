"""CMD CK in progress: part of the state, because its rehearsal takes many control steps."""

from __future__ import annotations

from typing import TYPE_CHECKING

import msgspec

from aftdeck.scenario.target import Target
from aftdeck.simulation.frame import Cause, Six
from aftdeck.state_part import Cache, StatePart
from aftdeck.steering.mode import LawChoice

if TYPE_CHECKING:
    from aftdeck.simulation.command_check.rehearsal import Rehearsal
    from aftdeck.simulation.state import State


class Way(msgspec.Struct, frozen=True):
    """One way to a target that CMD CK may rehearse."""

    law: LawChoice
    joints: Six | None
    """Mode 1's final joint angles [rad]; None for a straight line."""
    least: float
    """Lower bound of the time that the way takes [s]; 0 if it is not known."""
    name: str
    """Text that distinguishes the way from other ways: ``wrist flipped``."""


class Tried(msgspec.Struct, frozen=True):
    """Result of rehearsing one way."""

    way: Way
    good: bool
    """Whether the motion reaches its target or a berth fixes the payload; under `strict`, whether the motion ends."""
    cause: Cause
    seconds: float
    """Duration of the motion, or time at which it fails [s]."""
    text: str
    """Reason of the failure, final error of the motion, or berth that fixes the payload."""
    near: str
    """Singularity that the motion passes near, as text; empty if there is none."""


class Rehearsed(Cache):
    """Rehearsal in progress.

    Attributes:
        start: state from which the rehearsed motion starts.
        motion: rehearsal of the motion.
    """

    def __init__(self) -> None:
        self.start: State | None = None
        self.motion: Rehearsal | None = None

    def copied(self) -> Rehearsed:
        """Return an empty cache: a copied state makes its own rehearsal."""
        return Rehearsed()


class Checking(StatePart):
    """CMD CK in progress.

    Attributes:
        target: target that is checked.
        start: encoded state from which the motion is rehearsed; None until the arm is at rest.
        ways: ways still to be rehearsed, the present one first.
        tried: results of the ways that have been rehearsed.
        steps: number of rehearsed steps of the first of `ways`.
        rehearsal: rehearsal of the first of `ways`.
    """

    target: Target
    start: bytes | None = None
    ways: list[Way] = msgspec.field(default_factory=list)
    tried: list[Tried] = msgspec.field(default_factory=list)
    steps: int = 0
    rehearsal: Rehearsed = msgspec.field(default_factory=Rehearsed)


class Premises(msgspec.Struct, frozen=True):
    """Values on which a verdict of CMD CK depends; the verdict is valid while they stay equal."""

    target: Target
    law: LawChoice
    rate: str
    held: int | None
    limits: int
    attached: int
    standing: bool
    """Whether BRAKES or SAFING is on."""
    angles: tuple[float, ...]
    """(6,) measured joint angles [rad]."""
    moving: tuple[float, ...]
    """(3,) velocity of the orbiter's translation [m/s]."""
    frames: bytes
    """Digest of all frames in L after the last step: payload in the grasp, worksite and floating payloads."""
