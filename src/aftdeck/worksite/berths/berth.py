"""Berth: a place where a payload can be fixed, and the properties in which the kinds of berths differ.

One module defines one kind: its table in the file, its constants, its conditions, its permitted contacts and its words;
`kinds` lists the kinds. When a berth closes and opens follows from `Berth.closes` and `Berth.instant`: the step
(`simulation.payloads.fixing`) knows no kinds.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar, Literal, TypedDict

import msgspec
import numpy as np

from aftdeck.arms.geometry import frozen
from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, compose, relative, row_of
from aftdeck.bodies.solid import Solid
from aftdeck.frames import Pose, endori
from aftdeck.matrices import product
from aftdeck.shapes import Shape
from aftdeck.units import Angle, Length, Time
from aftdeck.worksite.body import Body, Frame
from aftdeck.worksite.conditions import Condition
from aftdeck.worksite.payload import Payload
from aftdeck.worksite.relation import Relation
from aftdeck.worksite.tables import Placed, Text, positive

Closes = Literal["by itself", "on command", "at release"]
Verb = Literal["dock", "insert", "berth"]


class Common(TypedDict):
    """Fields that every kind of berth takes from its table (`Berth`)."""

    name: str
    title: str
    body: str
    frame: Frame
    pose: Pose
    time: float
    distance: float
    angle: float


class BerthTable(Placed, frozen=True, kw_only=True, tag_field="kind"):
    """Fields of every berth's table."""

    name: Text
    title: Text
    body: Text
    time: Time = Time(0.0)
    """Time that the latches take to close or to release."""
    distance: Length
    """Greatest distance from its seated position at which a payload can be latched."""
    angle: Angle
    """Greatest rotation from its seated attitude at which a payload can be latched."""
    source: Text

    def __post_init__(self) -> None:
        """Reject tolerances that are not above zero, and a negative time (ValueError)."""
        positive(distance=self.distance, angle=self.angle)
        if self.time < 0.0:
            raise ValueError(f"time is {self.time:g} s; it cannot be below 0")

    def berth(self, body: Body, solids: Sequence[Solid]) -> Berth:
        """Return the berth that the table describes.

        Args:
            body: the body that carries the berth.
            solids: the body's solids, in the coordinate frame to which the body is fixed.

        Raises:
            ValueError: a port is not on a face of its body's solids.
        """
        raise NotImplementedError

    def common(self, body: Body) -> Common:
        """Return the fields that every kind of berth takes from its table; `body`: the body that carries the berth."""
        fixed, own = body.pose, endori(*self.rotation)
        position = product(fixed.rotation, np.array(self.position, dtype=np.float64)) + fixed.position
        return Common(
            name=self.name,
            title=self.title,
            body=self.body,
            frame=body.fixed_to,
            pose=Pose(frozen(position), frozen(product(fixed.rotation, own))),
            time=float(self.time),
            distance=float(self.distance),
            angle=float(self.angle),
        )

    def marks(self) -> tuple[Shape, ...]:
        """Return the shapes that mark the berth, in its body's axes."""
        return ()


class Berth(msgspec.Struct, frozen=True, eq=False, kw_only=True):
    """A berth. A payload is *seated* when it has the pose in which the berth fixes it."""

    out: ClassVar[int]
    """Axis of the berth along which a payload leaves it: 0 for x, 2 for z."""
    away: ClassVar[str]
    """Word for a place on the way out of the berth, such as "above"."""
    gives: ClassVar[float]
    """Time constant with which the berth returns a payload to its place, on a plant with masses [s] (assumed)."""
    docks: ClassVar[bool] = False
    """Whether the berth is a docking port."""

    name: str
    title: str
    body: str
    frame: Frame
    pose: Pose
    """Pose in `frame`: for a port, the pose of the port's centre; for a bay berth, the pose of a seated payload."""
    time: float
    """Time that the latches take [s]."""
    distance: float
    """Greatest distance from the seated position at which a payload can be latched [m]."""
    angle: float
    """Greatest rotation from the seated attitude at which a payload can be latched [rad]."""
    closes: Closes
    """Event at which the berth fixes a payload that meets the conditions. A berth that closes at the payload's release
    frees the payload at its capture; the others open on UNLATCH."""
    instant: bool
    """Whether the berth closes and opens within one step; otherwise its latches take `time`."""
    verb: Verb
    """Verb for moving a payload into the berth."""
    needs: Literal["", "probe", "trunnions"]
    """Fitting by which the berth holds a payload; empty if it holds any payload."""

    @property
    def mouth(self) -> float:
        """Distance from the seated position, along the way out, at which the berth's guides end [m]; 0 without any."""
        return 0.0

    def lacks(self, probe: Pose | None, trunnions: Array) -> str:
        """Return the name of the fitting that this berth needs and a payload lacks; empty if the payload fits.

        Args:
            probe: `Payload.probe` of the payload.
            trunnions: `Payload.trunnions` of the payload.
        """
        has = {"": True, "probe": probe is not None, "trunnions": len(trunnions) > 0}
        return "" if has[self.needs] else self.needs

    def seated(self, probe: Pose | None) -> Pose:
        """Return the pose of a seated payload's own frame in the berth's frame; `probe`: `Payload.probe`."""
        del probe
        return self.pose

    def fit(self, payload: Payload, row: int, axes: str) -> Fit:
        """Return the constants of a payload in this berth, which accepts the payload.

        Args:
            payload: the payload.
            row: index of the frame to which the berth is fixed, in the array of all frames.
            axes: "y" if docking limits only the angle between the y axes of payload and port; any other value if
                docking limits the angles of all three axes.
        """
        raise NotImplementedError


@dataclass(frozen=True, eq=False)
class Fit(ABC):
    """Constants of one payload in one berth. The kinds of berths add their conditions and permitted contacts.

    Attributes:
        berth: the berth.
        row: index of the frame to which the berth is fixed, in the array of all frames.
        place: (12,) pose of the fixed payload in the berth's frame.
    """

    berth: Berth
    row: int
    place: Array

    relation: ClassVar[Relation | None]
    """Relation in which the payload may touch the berth; None if it may not."""

    @abstractmethod
    def conditions(self, frames: Array, payload: int) -> tuple[Condition, ...]:
        """Return the conditions under which the berth fixes the payload.

        Args:
            frames: (F, 12) poses of all frames in L.
            payload: row of the payload's frame.
        """

    def has_left(self, frames: Array, payload: int) -> bool:
        """Return whether a payload that was released near the berth has left it; arguments as for `conditions`.

        If not, the payload has left once the conditions no longer hold.
        """
        del frames, payload
        return False

    @cached_property
    def way_out(self) -> Array:
        """Unit vector (3,) in the payload's axes, along which it leaves the berth."""
        return product(self.place[3:].reshape(3, 3).T, self._outwards)

    @property
    def _outwards(self) -> Array:
        """Unit vector (3,) in the berth's frame, along which the payload leaves the berth: upwards."""
        return np.array([0.0, 0.0, 1.0])

    def offset(self, frames: Array, payload: int) -> Array:
        """Return the payload's pose (12,) relative to its final pose in the berth; arguments as for `conditions`."""
        place, off = np.empty(POSE), np.empty(POSE)
        compose(frames[self.row], self.place, place)
        relative(place, frames[payload], off)
        return off


def place_of(berth: Berth, payload: Payload) -> Array:
    """Return the pose (12,) of a seated payload in the berth's frame."""
    return row_of(berth.seated(payload.probe))
