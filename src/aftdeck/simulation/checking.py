"""CMD CK under way: a part of the state, since its rehearsal goes on over many control steps."""

from __future__ import annotations

from hashlib import sha256
from typing import TYPE_CHECKING

import msgspec

from aftdeck.scenario.target import Target
from aftdeck.simulation.frame import Cause, Six
from aftdeck.state_part import Cache, StatePart
from aftdeck.steering.mode import LawChoice

if TYPE_CHECKING:
    from aftdeck.simulation.rehearsal import Rehearsal
    from aftdeck.simulation.state import State


class Way(msgspec.Struct, frozen=True):
    """One way to a target that CMD CK may rehearse."""

    law: LawChoice
    joints: Six | None
    """Mode 1's final joint angles [rad]; None: a straight line."""
    least: float
    """The shortest time that it can take [s]; 0 where that is not known."""
    name: str
    """What sets it apart from other ways, for people: ``wrist turned over``."""


class Tried(msgspec.Struct, frozen=True):
    """How a way went."""

    way: Way
    good: bool
    """Whether it reaches its target; under `strict` whether it comes to its end."""
    cause: Cause
    seconds: float
    """How long it takes, or when it fails [s]."""
    text: str
    """Why it fails, or by how much it ends beside its target, for people."""
    near: str
    """A singularity that is passed near, for people; empty: none."""


class Rehearsed(Cache):
    """The rehearsal under way.

    Attributes:
        start: the state from which it set out.
        of: the motion flown ahead of time.
    """

    def __init__(self) -> None:
        self.start: State | None = None
        self.of: Rehearsal | None = None

    def copied(self) -> Rehearsed:
        """Return that of a copied state, which flies its own."""
        return Rehearsed()


class Checking(StatePart):
    """CMD CK under way.

    Attributes:
        target: what is checked.
        start: the state from which the motion is rehearsed, encoded; None until the arm is at rest.
        ways: still to be rehearsed, the one under way first.
        tried: rehearsed.
        steps: how far the first of `ways` has been rehearsed.
        rehearsal: of the first of `ways`.
    """

    target: Target
    start: bytes | None = None
    ways: list[Way] = msgspec.field(default_factory=list)
    tried: list[Tried] = msgspec.field(default_factory=list)
    steps: int = 0
    rehearsal: Rehearsed = msgspec.field(default_factory=Rehearsed)


def begin_check(state: State, target: Target) -> None:
    """Ask for CMD CK of a target; `simulation.check` carries it out, step by step."""
    state.panel.check, state.panel.sequence = None, "checking"
    state.checking = Checking(target)


class Premises(msgspec.Struct, frozen=True):
    """What a verdict of CMD CK rests on: where it is the same, the verdict still holds."""

    target: Target
    law: LawChoice
    rate: str
    held: int | None
    limits: int
    attached: int
    standing: bool
    """BRAKES or SAFING is on."""
    angles: tuple[float, ...]
    """(6,) as measured [rad]."""
    moving: tuple[float, ...]
    """(3,) how fast the orbiter translates [m/s]."""
    frames: bytes
    """Digest of where everything is in L as last looked at: what the arm holds, the worksite and what floats."""


def premises(state: State, target: Target) -> Premises:
    """Return what a verdict on this target would rest on now."""
    panel, things, script = state.panel, state.site, state.script
    return Premises(
        target,
        panel.law,
        panel.rate,
        things.held,
        script.limits,
        script.attached,
        panel.brakes or panel.safing,
        tuple(state.plant.angles.tolist()),
        tuple(things.orbiter_velocity.tolist()),
        sha256(things.frames.data).digest(),
    )
