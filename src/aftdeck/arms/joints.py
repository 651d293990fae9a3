"""Joints of an arm file, a table ``[[joint]]`` for each, from the foot to the tip; and sources of their quantities."""

from __future__ import annotations

from typing import Annotated, Literal, NamedTuple

import msgspec

from aftdeck.arms.constant import Cited, Confidence, Constant, Part, Text
from aftdeck.arms.link_file import Distance, LinkFile, Place
from aftdeck.bounds import DIRECTION, Bounds
from aftdeck.units import Acceleration, Angle, AngularAcceleration, AngularRate, Force, LinearDamping, Speed

JointRate = Annotated[
    AngularRate,
    Bounds(1e-6, 10.0, "the Shuttle's joints turn at 0.001 to 0.09 rad/s, the fastest small arms at about 1 rad/s"),
]
"""Limit of a joint's rate."""
JointAcceleration = Annotated[
    AngularAcceleration, Bounds(1e-6, 100.0, "a joint reaches its greatest rate in 0.1 s to minutes")
]
"""Limit of a joint's acceleration."""
SlideSpeed = Annotated[Speed, Bounds(1e-6, 10.0, "the concept arm's telescope moves at 0.3 m/s")]
"""Speed of a joint that slides."""
SlideAcceleration = Annotated[Acceleration, Bounds(1e-6, 100.0, "a slide reaches its speed in 0.1 s to minutes")]
"""Limit of the acceleration of a joint that slides."""
DriveForce = Annotated[Force, Bounds(1e-3, 1e6, "a telescope that moves 7 t by 1 ft/s within 1 s needs 2,000 N")]
DriveGain = Annotated[LinearDamping, Bounds(1e-3, 1e9, "a telescope's servo has about 1e4 N s/m")]
Component = Annotated[float, DIRECTION]
StickAxis = Literal["RHC roll", "RHC pitch", "RHC yaw", "THC X", "THC Y", "THC Z"]
"""Axis of the hand controllers."""
Weight = Annotated[float, Bounds(0.0, 1e6, "a joint with a million times the weight moves alone")]
Switch = Literal["telescope", "prong"]
"""Switch of the panel that drives a joint: that of the telescope, or that of the end effector."""


class _JointFile(Part, frozen=True, kw_only=True, tag_field="kind"):
    """Fields of every joint. All vectors are in L, with all joints at their coordinates 0."""

    name: Text
    label: Text
    """Short name for the panel."""
    step: Place
    """Vector from the joint before, or from L's origin, to this joint's centre."""
    axis: tuple[Component, Component, Component]
    """Direction of the joint's axis; only the direction counts."""
    link: LinkFile | None = None
    source: Text | None = None
    """Source of the quantities of this joint that the file's table `sources` does not have."""
    confidence: Confidence | None = None


class _Moving(_JointFile, frozen=True, kw_only=True):
    """Fields of a joint that steering can drive."""

    weight: Weight = 1.0
    """Weight of the joint where several can make the same motion: twice the weight, twice the share; 0 for no share."""
    stick: StickAxis | None = None
    """Axis of the hand controllers that moves this joint of the master arm, for operators without a device for it."""


class Turn(_Moving, frozen=True, kw_only=True, tag="turn"):
    """Joint that turns about its axis; steering drives it."""

    hard: tuple[Angle, Angle]
    """Mechanical stops."""
    soft: tuple[Angle, Angle]
    """Soft stops, inside the hard stops."""
    reach: tuple[Angle, Angle]
    """Limits at which the REACH LIM lamp lights, inside the soft stops."""
    servo: JointRate
    """Limits of the rate: in modes 2 to 7; for the settings coarse and vernier in modes 1 and 8, DIRECT and MASTER."""
    coarse: JointRate
    vernier: JointRate
    acceleration: JointAcceleration
    """Greatest acceleration, in modes 1 to 7."""


class Travel(NamedTuple):
    """Range of a joint that a switch drives [m], and its speed at full drive [m/s]."""

    least: float
    greatest: float
    start: float
    rate: float


class Slide(_Moving, frozen=True, kw_only=True, tag="slide"):
    """Joint that slides along its axis. Steering drives it, as a joint that turns; or a switch of the panel does.

    A joint that a switch drives has no joint angle. Before the first joint that steering drives, it is the telescope
    that carries the arm. Behind the last one, it is a branch.
    """

    driver: Switch | None = None
    """Switch that drives the joint; without it, steering does."""
    hard: tuple[Distance, Distance] | None = None
    """Limits of a joint that steering drives, as those of a joint that turns; also the following six."""
    soft: tuple[Distance, Distance] | None = None
    reach: tuple[Distance, Distance] | None = None
    servo: SlideSpeed | None = None
    coarse: SlideSpeed | None = None
    vernier: SlideSpeed | None = None
    acceleration: SlideAcceleration | None = None
    on: Text | None = None
    """Name of the joint that carries a joint with a switch; without a name, the joint before it in the file."""
    least: Constant[Distance] | None = None
    greatest: Constant[Distance] | None = None
    start: Constant[Distance] | None = None
    """Coordinate with which a run begins, unless the scenario gives another."""
    rate: Constant[SlideSpeed] | None = None
    """Speed at full drive."""
    facing: Constant[Distance] | None = None
    """Of a prong: coordinate of the fixed face towards which it closes."""
    gain: Constant[DriveGain] | None = None
    """Force of the drive for each m/s of speed error; a plant with masses needs it, and the greatest force."""
    force: Constant[DriveForce] | None = None

    def __post_init__(self) -> None:
        """Reject a joint without the fields of its driver, or with those of the other (ValueError)."""
        by = "steering" if self.driver is None else f"the {self.driver} switch"
        needed, others = (STEERED, SWITCHED) if self.driver is None else (SWITCHED, STEERED)
        if missing := [name for name in needed if getattr(self, name) is None]:
            raise ValueError(f"{self.name} slides, driven by {by}: {', '.join(missing)} missing")
        others = (*others, *(("on", "facing", "gain", "force") if self.driver is None else ("stick",)))
        given = [name for name in others if getattr(self, name) is not None]
        if self.driver is not None and self.weight != 1.0:
            given.append("weight")
        if given:
            raise ValueError(f"{self.name} slides, driven by {by}, and takes no {', '.join(given)}")

    def travel(self) -> Travel:
        """Return the range and the speed of a joint that a switch drives."""
        return Travel(*(float(getattr(self, name).value) for name in SWITCHED))


STEERED = ("hard", "soft", "reach", "servo", "coarse", "vernier", "acceleration")
"""Fields that a joint has if steering drives it."""
SWITCHED = ("least", "greatest", "start", "rate")
"""Fields that a joint has if a switch drives it."""
JointFile = Turn | Slide
Joints = Annotated[tuple[JointFile, ...], msgspec.Meta(min_length=1)]


class SourcesFile(Part, frozen=True):
    """Sources of quantities that many joints have, in their own tables or in those of their links."""

    step: Cited | None = None
    axis: Cited | None = None
    hard: Cited | None = None
    soft: Cited | None = None
    reach: Cited | None = None
    servo: Cited | None = None
    coarse: Cited | None = None
    vernier: Cited | None = None
    acceleration: Cited | None = None
    mass: Cited | None = None
    centre: Cited | None = None
    inertia: Cited | None = None
    moments: Cited | None = None
    span: Cited | None = None
    low: Cited | None = None
    high: Cited | None = None
    radius: Cited | None = None
    bending: Cited | None = None
    torsion: Cited | None = None
