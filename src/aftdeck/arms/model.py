"""Contents of an arm file: geometry, limits, rates and masses, each constant with its source.

The field `family` selects a family of arms. That of the Shuttle's arm is described in JSC-12628 (yaw, pitch, pitch,
pitch, yaw, roll), that of the concept arm of 1972 in the *Remote Manipulator Simulation* (heading, pitch, pitch,
heading, pitch, roll). An arm of the family ``chain`` has any other chain of joints. Tables that differ between the
families, or that only one family has, have their own structs.
"""

from __future__ import annotations

from typing import Annotated, Generic, Literal, TypeVar

import msgspec

from aftdeck.arms.constant import Confidence, Constant, Part, Text
from aftdeck.arms.drives import FlexibilityFile, LinksFile, ServoFile, SlidesFile
from aftdeck.arms.joints import LONGEST, REAL_LENGTHS, Distance, JointAcceleration, JointRate, Joints, Place
from aftdeck.bodies.cover import FEWEST_SIDES
from aftdeck.bounds import Bounds
from aftdeck.shapes import Axis
from aftdeck.units import Angle, AngularRate, Length, Mass, Speed, Time

_T = TypeVar("_T")

Size = Annotated[
    Length, Bounds(0.0005, LONGEST, f"{REAL_LENGTHS}, and the parts of the smallest arms measure millimetres")
]
"""Length of a link, or size of a part of an arm."""
Offset = tuple[Size, Distance]
"""Offset of a joint from the joint before it, at zero angles: along the arm, then down [m]."""
Reach = Annotated[Length, Bounds(0.0, LONGEST, REAL_LENGTHS)]
"""Distance between two joints, or from a joint to the tip; 0 if they coincide."""
Span = tuple[Distance, Distance]
"""Coordinates of the two ends of a body along a line: begin, then end [m]."""
SixRanges = tuple[
    tuple[Angle, Angle],
    tuple[Angle, Angle],
    tuple[Angle, Angle],
    tuple[Angle, Angle],
    tuple[Angle, Angle],
    tuple[Angle, Angle],
]
SixRates = tuple[JointRate, JointRate, JointRate, JointRate, JointRate, JointRate]
SixAccelerations = tuple[
    JointAcceleration,
    JointAcceleration,
    JointAcceleration,
    JointAcceleration,
    JointAcceleration,
    JointAcceleration,
]
TipSpeed = Annotated[Speed, Bounds(1e-6, 10.0, "the tip of the Shuttle's arm moves at 0.6 m/s without a payload")]
"""Limit of the speed of the point of resolution."""
TipRate = Annotated[AngularRate, Bounds(1e-6, 10.0, "the Shuttle's end effector turns at 0.083 rad/s at most")]
"""Limit of the angular rate of the point of resolution."""
RiseTime = Annotated[Time, Bounds(0.001, 3600.0, "the Shuttle's arm reaches its speed within seconds")]
"""Time from rest to a limit of speed."""
Sides = Annotated[int, Bounds(FEWEST_SIDES, 360, "360 sides cover a cylinder to 0.004 % of its radius")]
"""Number of sides of a prism."""
Threshold = Annotated[
    float, Bounds(0.001, 0.999, "a normalised distance is 0 at a singularity and 1 where it is farthest away")
]
SixNames = tuple[Text, Text, Text, Text, Text, Text]


class YawGeometry(Part, frozen=True):
    """Distances between joint centres at zero angles, for a pitch-yaw-roll wrist."""

    shoulder_yaw_to_pitch: Constant[Reach]
    upper_arm: Constant[Offset]
    lower_arm: Constant[Offset]
    wrist_pitch_to_yaw: Constant[Reach]
    wrist_yaw_to_tip: Constant[Reach]
    end_effector_roll: Constant[Angle]


class HeadingGeometry(Part, frozen=True):
    """Distances between joint centres, for a heading-pitch-roll wrist; the tip is on the palm's outer face."""

    upper_arm: Constant[Size]
    lower_arm: Constant[Size]


class MountFile(Part, frozen=True):
    """Position of the arm's base on the orbiter, and the base's lean.

    The lean is the angle of the first joint's axis from the vertical, to port. Positions are structural Xo, Yo, Zo.
    """

    origin: Constant[tuple[Length, Length, Length]]
    lean: Constant[Angle]
    orbiter_origin: Constant[tuple[Length, Length, Length]]


class LimitsFile(Part, frozen=True):
    """Three sets of joint limits, each inside the preceding set, and the threshold of the SINGULAR lamp."""

    hard: Constant[SixRanges]
    soft: Constant[SixRanges]
    reach: Constant[SixRanges]
    singular: Constant[Threshold]


class RatesFile(Part, frozen=True):
    """Joint rate limits and the greatest joint accelerations.

    There are three sets of rate limits: the servo maxima (modes 2 to 7), and the coarse and vernier limits (modes 1 and
    8, DIRECT and MASTER).
    """

    servo: Constant[SixRates]
    coarse: Constant[SixRates]
    vernier: Constant[SixRates]
    acceleration: Constant[SixAccelerations]


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


class YawParts(Part, frozen=True):
    """Masses of an arm's links [kg], for the family of the Shuttle's arm; each with the housing at its beginning."""

    foot: Mass
    """From the vehicle to the first joint, and fixed to the vehicle."""
    shoulder: Mass
    upper_boom: Mass
    lower_boom: Mass
    wrist_pitch: Mass
    """From wrist pitch to wrist yaw."""
    wrist_yaw: Mass
    """From wrist yaw to wrist roll."""
    end_effector: Mass


class HeadingParts(Part, frozen=True):
    """Masses of an arm's parts [kg] without the telescope, for the family of the concept arm of 1972."""

    upper_arm: Mass
    lower_arm: Mass
    hand: Mass


class MassesFile(Part, Generic[_T], frozen=True):
    """Published mass of the arm, and masses of its parts."""

    total: Constant[Mass]
    parts: Constant[_T]


class StandFile(Part, frozen=True):
    """Telescope under the arm. Its length is the height of the shoulder above the telescope's foot."""

    least: Constant[Size]
    greatest: Constant[Size]
    start: Constant[Size]
    rate: Constant[TipSpeed]
    side: Constant[Size]
    """Side of the sleeve's square section."""
    tube_side: Constant[Size]
    """Side of the square tube that slides in the sleeve."""
    top_below_shoulder: Constant[Size]


class BoomsFile(Part, frozen=True):
    """Dimensions of upper arm, lower arm and stub (with square sections), and of the cubes that house the joints."""

    side: Constant[Size]
    """Side of upper and lower arm."""
    set_back: Constant[Size]
    """Distance of each end of a boom's body from the pin at that end."""
    stub_side: Constant[Size]
    stub: Constant[Span]
    shoulder_housing: Constant[Size]
    elbow_housing: Constant[Size]
    wrist_housing: Constant[Size]


class EffectorFile(Part, frozen=True):
    """Palm (HEX 1), fixed finger (HEX 2) and prong (HEX 3), in system 2: X2 outwards, Y2 to the fixed finger."""

    palm: Constant[Span]
    """Extent of the palm along X2; its outer face contacts the payload's bar."""
    palm_half_width: Constant[Size]
    palm_half_height: Constant[Size]
    fingers: Constant[Span]
    """Extent of fixed finger and prong along X2."""
    finger_thickness: Constant[Size]
    finger_half_height: Constant[Size]
    fixed_finger: Constant[Distance]
    """y2 of the fixed finger's inner face."""
    prong_open: Constant[Distance]
    """y2 of the open prong's inner face."""
    prong_closed: Constant[Distance]
    """y2 of the closed prong's inner face."""
    prong_rate: Constant[TipSpeed]


class _Cover(Part, frozen=True, tag_field="kind", kw_only=True):
    """Convex body that encloses another body. The clearance of the enclosed body is therefore never overstated."""

    position: tuple[Length, Length, Length] = (Length(0.0), Length(0.0), Length(0.0))
    """Position of the cover's centre in the frame of the enclosed body."""
    rotation: tuple[Angle, Angle, Angle] = (Angle(0.0), Angle(0.0), Angle(0.0))
    """Roll, pitch, yaw about fixed x, y, z, applied in that order."""


class BoxCover(_Cover, frozen=True, kw_only=True, tag="box"):
    """A box about its centre."""

    size: tuple[Length, Length, Length]


class PrismCover(_Cover, frozen=True, kw_only=True, tag="prism"):
    """A regular prism that encloses a cylinder."""

    axis: Axis = "x"
    radius: Length
    """Radius of the cylinder; the prism's edges are farther from the axis."""
    length: Length
    sides: Sides


Cover = BoxCover | PrismCover


class BoxBody(BoxCover, frozen=True, kw_only=True, tag="box"):
    """A box that covers a part of the arm."""

    part: Text
    """Name of the part, which the operator reads; several bodies may belong to one part."""
    frame: Text
    """Name of the moving frame that carries the body."""
    source: Text
    confidence: Confidence


class PrismBody(PrismCover, frozen=True, kw_only=True, tag="prism"):
    """A prism that covers a part of the arm; `part` and `frame` as in `BoxBody`."""

    part: Text
    frame: Text
    source: Text
    confidence: Confidence


class _AnyArm(Part, frozen=True, tag_field="family", kw_only=True):
    """Fields of every arm file; `arms.check` makes the checks that field types cannot express."""

    name: Text
    title: Text
    units: Literal["ft-in", "SI"]
    joints: SixNames
    labels: SixNames
    mount: MountFile
    limits: LimitsFile
    rates: RatesFile
    por: Annotated[tuple[PorRow, ...], msgspec.Meta(min_length=1)]
    servo: ServoFile | None = None
    """Servos and brakes; a plant with masses needs them."""
    shapes: str | None = None


class YawArmFile(_AnyArm, frozen=True, kw_only=True, tag="yaw-pitch-pitch-pitch-yaw-roll"):
    """Arm of the family of the Shuttle's arm."""

    geometry: YawGeometry
    masses: MassesFile[YawParts]
    bodies: tuple[BoxBody | PrismBody, ...] = ()
    """Collision bodies of the arm."""
    links: LinksFile | None = None
    """Moments of inertia and sizes of the links; a plant with masses needs them."""
    flexibility: FlexibilityFile | None = None
    """Springs; a flexible plant needs them."""


class HeadingArmFile(_AnyArm, frozen=True, kw_only=True, tag="heading-pitch-pitch-heading-pitch-roll"):
    """Arm of the family of the concept arm of 1972."""

    geometry: HeadingGeometry
    masses: MassesFile[HeadingParts]
    stand: StandFile
    booms: BoomsFile
    effector: EffectorFile
    slides: SlidesFile | None = None
    """Drives of telescope and prong; a plant with masses needs them."""


class ChainArmFile(Part, frozen=True, kw_only=True, tag_field="family", tag="chain"):
    """Arm with any chain of joints. With all joints at their coordinates 0, the tip's axes are those of L."""

    name: Text
    title: Text
    units: Literal["ft-in", "SI"]
    mount: MountFile
    joint: Joints
    tip: Constant[Place]
    """Vector from the last joint's centre to the tip."""
    end_effector_roll: Constant[Angle] | None = None
    """Angle about axis 1 from the tip's axes to the end effector's own axes; 0 without it."""
    singular: Constant[Threshold]
    """Distance from a singularity below which the SINGULAR lamp lights."""
    turning: Annotated[float, Bounds(1e-3, 1e3, "a motion that counts 1000 times as much as another is exact")] = 0.03
    """Weight of a rotation [rad], in comparison with a translation divided by `chain.SCALE`, in what a chain follows
    that cannot make every motion."""
    por: Annotated[tuple[PorRow, ...], msgspec.Meta(min_length=1)]
    servo: ServoFile | None = None
    bodies: tuple[BoxBody | PrismBody, ...] = ()
    """Collision bodies of the arm; they are also drawn if the file names no file of shapes."""
    shapes: str | None = None

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of the joints."""
        return tuple(joint.name for joint in self.joint)

    @property
    def labels(self) -> tuple[str, ...]:
        """Short names of the joints."""
        return tuple(joint.label for joint in self.joint)


ArmFile = YawArmFile | HeadingArmFile | ChainArmFile
"""Decoded arm file."""
