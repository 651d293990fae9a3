"""Contents of an arm file: joints, limits, masses, bodies, each constant with its source.

Constants that are the same quantity of many joints stand in the joints' tables, and their sources in the table
`sources`. A constant that exists once is a table with its own source.
"""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from aftdeck.arms.body_file import BodyFile
from aftdeck.arms.constant import Confidence, Constant, Part, Text
from aftdeck.arms.drives import FlexibilityFile, ServoFile
from aftdeck.arms.joints import JointFile, Joints, Slide, SourcesFile, Turn
from aftdeck.arms.link_file import LinkFile, Place
from aftdeck.bounds import Bounds
from aftdeck.units import Angle, AngularRate, Length, Mass, Speed, Time

TipSpeed = Annotated[Speed, Bounds(1e-6, 10.0, "the tip of the Shuttle's arm moves at 0.6 m/s without a payload")]
"""Limit of the speed of the point of resolution."""
TipRate = Annotated[AngularRate, Bounds(1e-6, 10.0, "the Shuttle's end effector turns at 0.083 rad/s at most")]
"""Limit of the angular rate of the point of resolution."""
RiseTime = Annotated[Time, Bounds(0.001, 3600.0, "the Shuttle's arm reaches its speed within seconds")]
"""Time from rest to a limit of speed."""
Threshold = Annotated[
    float, Bounds(0.001, 0.999, "a normalised distance is 0 at a singularity and 1 where it is farthest away")
]


class MountFile(Part, frozen=True):
    """Position of the arm's base on the orbiter, and the base's lean.

    The lean is the angle of the first joint's axis from the vertical, to port. Positions are structural Xo, Yo, Zo.
    """

    origin: Constant[tuple[Length, Length, Length]]
    lean: Constant[Angle]
    orbiter_origin: Constant[tuple[Length, Length, Length]]


class PorRow(Part, frozen=True):
    """Limits of the point of resolution for one payload mass."""

    mass: Mass
    translation: TipSpeed
    vernier_translation: TipSpeed
    rotation: TipRate
    vernier_rotation: TipRate
    reached_in: RiseTime
    """Time in which the point of resolution accelerates from rest to its coarse limits."""
    source: Text
    confidence: Confidence


class ArmFile(Part, frozen=True, kw_only=True):
    """Decoded arm file; `arms.check` makes the checks that field types cannot express.

    With all joints at their coordinates 0, the tip's axes are those of L.
    """

    name: Text
    title: Text
    units: Literal["ft-in", "SI"]
    dimensions: dict[str, str | float] = msgspec.field(default_factory=dict)
    """Named quantities from which others are derived (`aftdeck.dimensions`)."""
    mount: MountFile
    sources: SourcesFile = SourcesFile()
    joint: Joints
    tip: Constant[Place]
    """Vector from the centre of the last joint that steering drives to the tip."""
    end_effector_roll: Constant[Angle] | None = None
    """Angle about axis 1 from the tip's axes to the end effector's own axes; 0 without it."""
    singular: Constant[Threshold]
    """Distance from a singularity below which the SINGULAR lamp lights."""
    turning: Annotated[float, Bounds(1e-3, 1e3, "a motion that counts 1000 times as much as another is exact")] = 0.03
    """Weight of a rotation [rad], in comparison with a translation divided by `chain.SCALE`, in what a chain follows
    that cannot make every motion."""
    por: Annotated[tuple[PorRow, ...], msgspec.Meta(min_length=1)]
    foot: LinkFile | None = None
    """Body between the vehicle and the first joint, fixed to the vehicle; on a flexible arm, it turns with the base."""
    mass: Constant[Mass] | None = None
    """Published mass of the arm, without what a telescope's own joint carries: the sum of its links and bodies."""
    servo: ServoFile | None = None
    """Servos and brakes; a plant with masses needs them."""
    flexibility: FlexibilityFile | None = None
    """Springs; a flexible plant needs them."""
    bodies: tuple[BodyFile, ...] = ()
    """Collision bodies of the arm; they are also drawn for every frame for which no file of shapes has any."""
    shapes: str | None = None

    @property
    def steered(self) -> tuple[JointFile, ...]:
        """Joints that steering drives, from the foot to the tip."""
        return tuple(joint for joint in self.joint if isinstance(joint, Turn) or joint.driver is None)

    @property
    def switched(self) -> tuple[Slide, ...]:
        """Joints that switches drive."""
        return tuple(joint for joint in self.joint if isinstance(joint, Slide) and joint.driver is not None)

    @property
    def slides(self) -> tuple[bool, ...]:
        """For each joint that steering drives, whether it slides along its axis; otherwise it turns about it."""
        return tuple(isinstance(joint, Slide) for joint in self.steered)

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of the joints that steering drives."""
        return tuple(joint.name for joint in self.steered)

    @property
    def labels(self) -> tuple[str, ...]:
        """Short names of the joints that steering drives."""
        return tuple(joint.label for joint in self.steered)
