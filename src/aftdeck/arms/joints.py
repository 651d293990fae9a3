"""Joints of an arm file that describes its arm as a chain: a table ``[[joint]]`` for each, from the foot to the tip."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from aftdeck.arms.constant import Confidence, Part, Text
from aftdeck.arms.drives import LinkInertia
from aftdeck.bounds import DIRECTION, Bounds
from aftdeck.tuples import MOST_JOINTS
from aftdeck.units import Acceleration, Angle, AngularAcceleration, AngularRate, Length, Mass, Speed

LONGEST = 200.0
"""Greatest plausible length of an arm [m]."""
REAL_LENGTHS = "the Shuttle's arm is 15 m long, Canadarm2 18 m"
Distance = Annotated[Length, Bounds(-LONGEST, LONGEST, REAL_LENGTHS)]
"""Coordinate on an arm."""
Place = tuple[Distance, Distance, Distance]
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
"""Limit of the speed of a joint that slides."""
SlideAcceleration = Annotated[Acceleration, Bounds(1e-6, 100.0, "a slide reaches its speed in 0.1 s to minutes")]
"""Limit of the acceleration of a joint that slides."""
Component = Annotated[float, DIRECTION]
StickAxis = Literal["RHC roll", "RHC pitch", "RHC yaw", "THC X", "THC Y", "THC Z"]
"""Axis of the hand controllers."""
Weight = Annotated[float, Bounds(0.0, 1e6, "a joint with a million times the weight moves alone")]
LinkMass = Annotated[Mass, Bounds(1e-6, 1e5, "the Shuttle's whole arm has 410 kg")]


class LinkFile(Part, frozen=True):
    """Link behind a joint, as a rigid body; a plant with masses needs it."""

    mass: LinkMass
    centre: Place
    """Centre of mass in the joint's frame."""
    inertia: tuple[LinkInertia, LinkInertia, LinkInertia]
    """Moments of inertia about the centre of mass, along the axes of the joint's frame."""


class _JointFile(Part, frozen=True, kw_only=True, tag_field="kind"):
    """Fields of every joint. All vectors are in L, with all joints at their coordinates 0."""

    name: Text
    label: Text
    """Short name for the panel."""
    step: Place
    """Vector from the joint before, or from L's origin, to this joint's centre."""
    axis: tuple[Component, Component, Component]
    """Direction of the joint's axis; only the direction counts."""
    weight: Weight = 1.0
    """Weight of the joint where several can make the same motion: twice the weight, twice the share; 0 for no share."""
    stick: StickAxis | None = None
    """Axis of the hand controllers that moves this joint of the master arm, for operators without a device for it."""
    link: LinkFile | None = None
    source: Text
    confidence: Confidence


class Turn(_JointFile, frozen=True, kw_only=True, tag="turn"):
    """Joint that turns about its axis."""

    hard: tuple[Angle, Angle]
    soft: tuple[Angle, Angle]
    reach: tuple[Angle, Angle]
    servo: JointRate
    """Limits of the rate, as those of ``rates`` in the file of the Shuttle's arm."""
    coarse: JointRate
    vernier: JointRate
    acceleration: JointAcceleration


class Slide(_JointFile, frozen=True, kw_only=True, tag="slide"):
    """Joint that slides along its axis; fields as in `Turn`."""

    hard: tuple[Distance, Distance]
    soft: tuple[Distance, Distance]
    reach: tuple[Distance, Distance]
    servo: SlideSpeed
    coarse: SlideSpeed
    vernier: SlideSpeed
    acceleration: SlideAcceleration


JointFile = Turn | Slide
Joints = Annotated[tuple[JointFile, ...], msgspec.Meta(min_length=1, max_length=MOST_JOINTS)]
