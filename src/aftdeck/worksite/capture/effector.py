"""End effector: what captures a payload, and the properties in which the kinds of end effectors differ.

One module defines one kind: its table in the worksite's file, its constants, its conditions, its motion, its permitted
contacts and its part of a frame; `kinds` lists the kinds.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, Literal, NamedTuple

import msgspec

from aftdeck.arms.load import ArmModel
from aftdeck.arrays import Array
from aftdeck.worksite.capture.snare import Snare
from aftdeck.worksite.conditions import Condition, Units
from aftdeck.worksite.log_line import LogLine
from aftdeck.worksite.payload import Payload
from aftdeck.worksite.report import Motion
from aftdeck.worksite.tables import Table, Text
from aftdeck.worksite.watch.groups import Placing

Acts = Literal[0, 1, 2]
RESTS: Acts = 0
"""Nothing moves; `EndEffector.step` returns at most the reason."""
BEGINS: Acts = 1
"""A switch begins a motion."""
MOVES: Acts = 2
"""A motion goes on."""


class MadeFor(NamedTuple):
    """Arm, payloads and frames for which an end effector's constants are made.

    Attributes:
        model: the arm.
        payloads: the payloads.
        parts: for each solid of the layout, the name of its part.
        hand: row of the last joint's frame.
        effector: (12,) pose of the end effector's axes E in this frame.
        rows: rows of the payloads' frames.
    """

    model: ArmModel
    payloads: tuple[Payload, ...]
    parts: Sequence[str]
    hand: int
    effector: Array
    rows: tuple[int, ...]


class CaptureTable(Table, frozen=True, kw_only=True, tag_field="kind"):
    """Fields of the table of every kind of end effector."""

    source: Text

    def effector(self, site: MadeFor) -> EndEffector | None:
        """Return the constants of capture by the arm's end effector; None if the arm lacks what this kind needs."""
        raise NotImplementedError


class Controls(msgspec.Struct, frozen=True):
    """Controls and state of the end effector in a step.

    Attributes:
        switch: position of the end effector's switch.
        pressed: whether the switch was pressed in this step.
        mode: position of END EFFECTOR MODE.
        rigid: position of MAN CONTR.
        prong: y2 of the prong's inner face [m].
        snare: state of snares and carriage.
    """

    switch: Literal["stop", "close", "open"]
    pressed: bool
    mode: Literal["auto", "manual"]
    rigid: Literal["off", "rigid", "derigid"]
    prong: float
    snare: Snare


class Nearest(NamedTuple):
    """Payload nearest to the end effector, and the conditions of its capture."""

    payload: int
    conditions: tuple[Condition, ...]


class Moved(msgspec.Struct, frozen=True):
    """Result of a step of the end effector.

    Attributes:
        payload: payload that is now captured or released; None if there is none.
        snare: state of snares and carriage.
        lines: lines for the log.
    """

    payload: int | None
    snare: Snare
    lines: tuple[LogLine, ...] = ()


@dataclass(frozen=True, eq=False)
class EndEffector(ABC):
    """Constants of capture by one end effector at one worksite. The kinds add their conditions and contacts.

    In the methods, `frames` (F, 12) are the poses of all frames in L, `place` places solids at these poses, and a
    payload is given by its index.
    """

    hand: int
    """Row of the last joint's frame."""
    rows: tuple[int, ...]
    """Rows of the payloads' frames."""

    action: ClassVar[Literal["acquire", "capture"]]
    """Verb for capturing a payload."""

    @abstractmethod
    def nearest(self, frames: Array, place: Placing, within: float) -> Nearest | None:
        """Return the payload nearest to the end effector; None if no payload is nearer than `within` [m]."""

    @abstractmethod
    def conditions(self, frames: Array, place: Placing, payload: int) -> tuple[Condition, ...]:
        """Return the conditions of capture of a payload; () if this end effector cannot capture it."""

    def acts(self, controls: Controls) -> Acts:
        """Return what the controls do to the end effector in this step."""
        del controls
        return RESTS

    @abstractmethod
    def step(
        self, controls: Controls, held: int | None, frames: Array, place: Placing, period: float, units: Units
    ) -> Moved | None:
        """Return the state after a step, and the payload that is now captured or released; None if nothing changes.

        Args:
            controls: controls and state before the step.
            held: the payload in the grasp; None if the grasp is empty.
            frames: poses of all frames in L.
            place: places solids.
            period: control period [s].
            units: the operator's units, for the log lines.
        """

    def drawn_grasp(self, payload: int, from_pose: Array, share: float) -> Array:
        """Return the pose (12,) of a held payload in the last joint's frame, as far as the end effector has drawn it.

        Args:
            payload: the payload.
            from_pose: (12,) pose of its fixture in E at the beginning.
            share: share of the misalignment that is left, 1 to 0.
        """
        raise NotImplementedError

    def touched(self, controls: Controls, held: int | None, frames: Array, place: Placing) -> tuple[int, float] | None:
        """Return the payload that the closing end effector touches, and how far it has closed; None if there is none.

        On a plant with masses, the payload is then held with this share of the full stiffness.
        """
        del controls, held, frames, place
        return None

    def motion(self, controls: Controls) -> Motion | None:
        """Return what the end effector does at present, and for how long; None if it is at rest."""
        del controls
        return None

    def grip(self, frames: Array, payload: int) -> Array | None:
        """Return the pose (12,) in E of the fixture that the end effector draws in; None if it draws none in."""
        del frames, payload
        return None
