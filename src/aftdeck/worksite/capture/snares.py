"""Snare end effector of the Shuttle's arm: it captures the pin of a payload's grapple fixture."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import inf
from typing import ClassVar, Literal

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, compose, inverse, relative, row_of, rows, vec3
from aftdeck.law import law
from aftdeck.matrices import length
from aftdeck.tuples import Rows, Vec3
from aftdeck.units import Angle, Length, Time
from aftdeck.worksite.capture.effector import (
    BEGINS,
    MOVES,
    RESTS,
    Acts,
    CaptureTable,
    Controls,
    EndEffector,
    MadeFor,
    Moved,
    Nearest,
)
from aftdeck.worksite.capture.grapple import CaptureEnvelope, in_envelope
from aftdeck.worksite.capture.snare import (
    Part,
    Snare,
    SnareCommand,
    SnareTimes,
    advance,
    flags,
    next_stage,
    refusal,
)
from aftdeck.worksite.conditions import Condition, Units, all_hold
from aftdeck.worksite.draw_in import remaining
from aftdeck.worksite.report import Hand, Motion
from aftdeck.worksite.tables import positive
from aftdeck.worksite.watch.groups import Placing

InEffector = tuple[Vec3, Rows]
"""Position and rotation of a grapple fixture in the end effector's axes E."""
WIDER, WIDEST = 2.0, 2.4
"""Factors on the capture envelope's radius and angles [1] (assumed). Alignment begins inside the envelope widened by
the first factor, and ends outside the envelope widened by the second."""
_TRIGGERS: dict[str, Literal["", "capture", "release"]] = {"close": "capture", "open": "release", "stop": ""}
_CONTR: dict[str, Literal["RIGID", "OFF", "DERIGID"]] = {"rigid": "RIGID", "off": "OFF", "derigid": "DERIGID"}


_TEXTS: dict[tuple[Part, bool], str] = {
    ("ring", True): "snares close",
    ("ring", False): "snares open",
    ("carriage", True): "carriage retracts",
    ("carriage", False): "carriage extends",
    ("tension", True): "rigidizing",
    ("tension", False): "derigidizing",
}
"""Text of each part's motion, towards 1 (True) and towards 0 (False)."""


class SnareFile(CaptureTable, frozen=True, kw_only=True, tag="snare"):
    """Capture envelope of the Shuttle's end effector for a grapple fixture, and the durations of its motions."""

    radial: Length
    """Greatest distance of the fixture from the end effector's axis."""
    nearest: Length
    """Least coordinate of the fixture along the end effector's axis: 0 in the rigid position, positive outwards."""
    farthest: Length
    """Greatest coordinate of the fixture along the end effector's axis, with the same origin and sign as `nearest`."""
    pitch: Angle
    """Greatest pitch of the fixture in either direction."""
    yaw: Angle
    """Greatest yaw of the fixture in either direction."""
    roll: Angle
    """Greatest roll of the fixture in either direction."""
    ring: Time
    """Time to close or open the snares."""
    carriage: Time
    """Time to retract or extend the carriage."""
    tension: Time
    """Time to rigidize or derigidize."""

    def __post_init__(self) -> None:
        """Reject values that are not above zero, and a `nearest` that is not less than `farthest` (ValueError)."""
        positive(radial=self.radial, pitch=self.pitch, yaw=self.yaw, roll=self.roll)
        positive(ring=self.ring, carriage=self.carriage, tension=self.tension)
        if not self.nearest < self.farthest:
            raise ValueError(f"nearest is {self.nearest:g} m and farthest {self.farthest:g} m; nearest has to be less")

    def effector(self, site: MadeFor) -> EndEffector:
        """Return the constants of capture by snares."""
        sizes = (self.radial, self.nearest, self.farthest, self.pitch, self.yaw, self.roll)
        return Snares(
            site.hand,
            site.rows,
            site.effector,
            CaptureEnvelope(*map(float, sizes)),
            SnareTimes(*map(float, (self.ring, self.carriage, self.tension))),
            tuple(None if payload.grapple is None else row_of(payload.grapple) for payload in site.payloads),
        )


@dataclass(frozen=True, eq=False)
class Snares(EndEffector):
    """Constants of capture by snares about a grapple fixture's pin.

    Attributes:
        effector: (12,) pose of the end effector's axes E in the last joint's frame.
        envelope: capture envelope of the pin.
        times: travel times of snares and carriage, and time to rigidize.
        fixtures: for each payload, (12,) pose of its fixture in the payload's axes; None if the payload has no fixture.
    """

    effector: Array
    envelope: CaptureEnvelope
    times: SnareTimes
    fixtures: tuple[Array | None, ...]

    action: ClassVar[Literal["acquire", "capture"]] = "capture"

    def fixture(self, frames: Array, payload: int) -> InEffector | None:
        """Return the pose of a payload's fixture in E; None if the payload has no fixture."""
        fixture = self.fixtures[payload]
        if fixture is None:
            return None
        return fixture_in_effector(frames, self.hand, self.effector, self.rows[payload], fixture)

    def grip(self, frames: Array, payload: int) -> Array | None:
        """Return the pose (12,) of a payload's fixture in E; None if the payload has no fixture."""
        if (fixture := self.fixture(frames, payload)) is None:
            return None
        position, turned = fixture
        return np.array([*position, *(value for row in turned for value in row)])

    def nearest(self, frames: Array, place: Placing, within: float) -> Nearest | None:
        """Return the payload whose fixture is nearest to the end effector; None if none is nearer than `within` [m]."""
        del place
        best = None
        for payload in range(len(self.fixtures)):
            fixture = self.fixture(frames, payload)
            if fixture is not None and (away := length(fixture[0])) < within:
                best, within = (payload, fixture), away
        return None if best is None else Nearest(best[0], in_envelope(best[1], self.envelope.packed))

    def conditions(self, frames: Array, place: Placing, payload: int) -> tuple[Condition, ...]:
        """Return the conditions of capture; () for a payload without a fixture."""
        del place
        fixture = self.fixture(frames, payload)
        return () if fixture is None else in_envelope(fixture, self.envelope.packed)

    def acts(self, controls: Controls) -> Acts:
        """Return whether snares or carriage begin to move, or go on."""
        before, command = controls.snare, snare_command(controls)
        moves = bool(before.motion) or controls.rigid != "off"
        if command.trigger and refusal(before, command):
            return BEGINS if moves else RESTS
        if command.trigger and not (command.trigger == before.motion and before.ring > 0.0):
            return BEGINS
        return MOVES if moves else RESTS

    def step(
        self, controls: Controls, held: int | None, frames: Array, place: Placing, period: float, units: Units
    ) -> Moved | None:
        """Move the snares and the carriage by one step of CAPTURE, RELEASE or MAN CONTR."""
        before, payload = controls.snare, held
        if not controls.pressed and not before.motion and controls.rigid == "off":
            return None
        command, conditions = snare_command(controls), tuple[Condition, ...]()
        closes = before.ring < 1.0 and "capture" in (command.trigger, before.motion)
        if closes and held is None and (near := self.nearest(frames, place, inf)) is not None:
            payload, conditions = near
        snare, lines = advance(before, self.times, command, period, conditions, units)
        return Moved(payload if snare.captured == (held is None) else None, snare, lines)

    def drawn_grasp(self, payload: int, from_pose: Array, share: float) -> Array:
        """Return the pose (12,) of a held payload in the last joint's frame, as far as the carriage has drawn it."""
        fixture = self.fixtures[payload]
        assert fixture is not None, "a captured payload has a fixture"
        left, pin, grasp = np.empty(POSE), np.empty(POSE), np.empty(POSE)
        remaining(from_pose, share, left)
        compose(self.effector, left, pin)
        compose(pin, inverse(fixture), grasp)
        return grasp

    def touched(self, controls: Controls, held: int | None, frames: Array, place: Placing) -> tuple[int, float] | None:
        """Return the payload whose pin is in the capture envelope of closing snares, and how far they have closed."""
        snare = controls.snare
        if held is not None or snare.motion != "capture" or snare.ring >= 1.0:
            return None
        near = self.nearest(frames, place, inf)
        return (near.payload, snare.ring) if near is not None and all_hold(near.conditions) else None

    def motion(self, controls: Controls) -> Motion | None:
        """Return what snares and carriage do at present, and for how long; None if they are at rest."""
        if not controls.snare.motion and controls.rigid == "off":
            return None
        stage = next_stage(controls.snare, snare_command(controls))
        if stage is None:
            return None
        part, target = stage
        left = abs(target - float(getattr(controls.snare, part)))
        return Motion(_TEXTS[part, target == 1.0], left * float(getattr(self.times, part)))


def status(controls: Controls) -> Hand:
    """Return the record of a snare end effector."""
    snare = controls.snare
    return Hand(controls.switch, 1.0 - snare.ring, None, snare.carriage, _lit(snare), controls.mode, controls.rigid)


@lru_cache(maxsize=16)
def _lit(snare: Snare) -> tuple[str, ...]:
    """Return the names of the panel's flags that are lit."""
    return tuple(name for name, on in flags(snare)._asdict().items() if on)


def snare_command(controls: Controls) -> SnareCommand:
    """Return the positions of the panel's switches for the snares."""
    return SnareCommand(
        "AUTO" if controls.mode == "auto" else "MAN",
        _TRIGGERS[controls.switch] if controls.pressed else "",
        _CONTR[controls.rigid],
    )


@law
def fixture_in_effector(frames: Array, last_joint: int, effector: Array, row: int, fixture: Array) -> InEffector:
    """Return the pose of a payload's fixture in the end effector's axes E.

    Args:
        frames: (F, 12) poses of all frames in L.
        last_joint: row of the frame of the last joint.
        effector: (12,) pose of E in the frame of the last joint.
        row: row of the payload's frame.
        fixture: (12,) pose of the fixture in the payload.
    """
    outer, inner, pose = np.empty(POSE), np.empty(POSE), np.empty(POSE)
    compose(frames[last_joint], effector, outer)
    compose(frames[row], fixture, inner)
    relative(outer, inner, pose)
    return vec3(pose, 0), rows(pose, 3)
