"""An arm as its file describes it: geometry, limits, rates, masses, every constant with its source.

Two families are known, told apart by the field `family`: that of JSC-12628 (yaw, pitch, pitch, pitch, yaw, roll)
and that of the *Remote Manipulator Simulation* (heading, pitch, pitch, heading, pitch, roll). What only one of them
has is in a struct of its own.
"""

from __future__ import annotations

from typing import Annotated, Generic, Literal, TypeVar

import msgspec

from aftdeck.shapes import Axis
from aftdeck.units import Angle, AngularAcceleration, AngularRate, Length, Mass, Speed, Time

_T = TypeVar("_T")

Confidence = Literal["firm", "single", "derived", "assumed"]
Text = Annotated[str, msgspec.Meta(min_length=1)]


class _Part(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A table of an arm file; unknown fields are refused."""


class Constant(_Part, Generic[_T], frozen=True):
    """A value with where it comes from and how far to trust it."""

    value: _T
    source: Text
    confidence: Confidence


Offset = tuple[Length, Length]
"""Along the arm at zero angles, and down from the boom line [m]."""
Span = tuple[Length, Length]
"""From and to, along a line [m]."""
SixRanges = tuple[
    tuple[Angle, Angle],
    tuple[Angle, Angle],
    tuple[Angle, Angle],
    tuple[Angle, Angle],
    tuple[Angle, Angle],
    tuple[Angle, Angle],
]
SixRates = tuple[AngularRate, AngularRate, AngularRate, AngularRate, AngularRate, AngularRate]
SixAccelerations = tuple[
    AngularAcceleration,
    AngularAcceleration,
    AngularAcceleration,
    AngularAcceleration,
    AngularAcceleration,
    AngularAcceleration,
]
SixNames = tuple[Text, Text, Text, Text, Text, Text]


class YawGeometry(_Part, frozen=True):
    """Distances between joint centres at zero angles, pitch-yaw-roll wrist."""

    shoulder_yaw_to_pitch: Constant[Length]
    upper_arm: Constant[Offset]
    lower_arm: Constant[Offset]
    wrist_pitch_to_yaw: Constant[Length]
    wrist_yaw_to_tip: Constant[Length]
    end_effector_roll: Constant[Angle]


class HeadingGeometry(_Part, frozen=True):
    """Distances between joint centres, heading-pitch-roll wrist; the tip is the palm's outer face."""

    upper_arm: Constant[Length]
    lower_arm: Constant[Length]


class MountFile(_Part, frozen=True):
    """Where the arm stands on the orbiter, in structural Xo, Yo, Zo."""

    origin: Constant[tuple[Length, Length, Length]]
    lean: Constant[Angle]
    orbiter_origin: Constant[tuple[Length, Length, Length]]


class LimitsFile(_Part, frozen=True):
    """Three nested sets of joint limits, and the SINGULAR lamp's threshold."""

    hard: Constant[SixRanges]
    soft: Constant[SixRanges]
    reach: Constant[SixRanges]
    singular: Constant[float]


class RatesFile(_Part, frozen=True):
    """Joint rate limits: servo maxima (modes 2 to 7), coarse and vernier (modes 1 and 8); joint accelerations."""

    servo: Constant[SixRates]
    coarse: Constant[SixRates]
    vernier: Constant[SixRates]
    acceleration: Constant[SixAccelerations]


class PorRow(_Part, frozen=True):
    """Limits of the point of resolution for one payload mass."""

    mass: Mass
    translation: Speed
    vernier_translation: Speed
    rotation: AngularRate
    vernier_rotation: AngularRate
    reached_in: Time
    source: Text
    confidence: Confidence


class YawParts(_Part, frozen=True):
    """Masses of the parts of the Shuttle's kind of arm [kg]."""

    yaw_housing: Mass
    shoulder: Mass
    upper_boom: Mass
    elbow: Mass
    lower_boom: Mass
    wrist_pitch: Mass
    wrist_yaw: Mass
    wrist_roll: Mass
    end_effector: Mass


class HeadingParts(_Part, frozen=True):
    """Masses of the parts of the concept's kind of arm [kg]; its stand is none of them."""

    upper_arm: Mass
    lower_arm: Mass
    hand: Mass


class MassesFile(_Part, Generic[_T], frozen=True):
    """Mass of the arm as published, and of its parts."""

    total: Constant[Mass]
    parts: Constant[_T]


class StandFile(_Part, frozen=True):
    """The telescope that the arm stands on; its length is the height of the shoulder above its foot."""

    least: Constant[Length]
    greatest: Constant[Length]
    start: Constant[Length]
    rate: Constant[Speed]
    side: Constant[Length]
    """Of its square section."""
    tube_side: Constant[Length]
    """Of the tube that slides in it."""
    top_below_shoulder: Constant[Length]


class BoomsFile(_Part, frozen=True):
    """Bodies of upper arm, lower arm and stub, square in section, and the cubes that house the joints."""

    side: Constant[Length]
    """Of upper and lower arm."""
    set_back: Constant[Length]
    """From the pins at their ends to where they begin."""
    stub_side: Constant[Length]
    stub: Constant[Span]
    shoulder_housing: Constant[Length]
    elbow_housing: Constant[Length]
    wrist_housing: Constant[Length]


class EffectorFile(_Part, frozen=True):
    """Palm (HEX 1), fixed finger (HEX 2) and prong (HEX 3), in system 2: X2 out of the hand, Y2 to the fixed finger."""

    palm: Constant[Span]
    """Along X2; its outer face is what meets the payload's bar."""
    palm_half_width: Constant[Length]
    palm_half_height: Constant[Length]
    fingers: Constant[Span]
    """Along X2, of both."""
    finger_thickness: Constant[Length]
    finger_half_height: Constant[Length]
    fixed_finger: Constant[Length]
    """y2 of its inner face."""
    prong_open: Constant[Length]
    """y2 of the prong's inner face."""
    prong_closed: Constant[Length]
    prong_rate: Constant[Speed]


class _Cover(_Part, frozen=True, tag_field="kind", kw_only=True):
    """A convex body round something, so that no clearance from it is overstated."""

    position: tuple[Length, Length, Length] = (Length(0.0), Length(0.0), Length(0.0))
    """Of its centre in the frame of what it covers."""
    rotation: tuple[Angle, Angle, Angle] = (Angle(0.0), Angle(0.0), Angle(0.0))
    """Roll, pitch, yaw about fixed x, y, z, applied in that order."""


class BoxCover(_Cover, frozen=True, kw_only=True, tag="box"):
    """A box about its centre."""

    size: tuple[Length, Length, Length]


class PrismCover(_Cover, frozen=True, kw_only=True, tag="prism"):
    """A regular prism round a cylinder."""

    axis: Axis = "x"
    radius: Length
    """Of the cylinder; the prism's edges stand farther out."""
    length: Length
    sides: int


Cover = BoxCover | PrismCover


class BoxBody(BoxCover, frozen=True, kw_only=True, tag="box"):
    """A box that covers a part of the arm."""

    part: Text
    """What people call it; several bodies may share a part."""
    frame: Text
    """The moving frame that carries it."""
    source: Text
    confidence: Confidence


class PrismBody(PrismCover, frozen=True, kw_only=True, tag="prism"):
    """A prism that covers a part of the arm; as `BoxBody`."""

    part: Text
    frame: Text
    source: Text
    confidence: Confidence


class _AnyArm(_Part, frozen=True, tag_field="family", kw_only=True):
    """What every arm file has; `arms.check` says what types cannot."""

    name: Text
    title: Text
    units: Literal["ft-in", "SI"]
    joints: SixNames
    labels: SixNames
    mount: MountFile
    limits: LimitsFile
    rates: RatesFile
    por: Annotated[tuple[PorRow, ...], msgspec.Meta(min_length=1)]
    shapes: str | None = None


class YawArmFile(_AnyArm, frozen=True, kw_only=True, tag="yaw-pitch-pitch-pitch-yaw-roll"):
    """An arm of the Shuttle's kind."""

    geometry: YawGeometry
    masses: MassesFile[YawParts]
    bodies: tuple[BoxBody | PrismBody, ...] = ()
    """What of it collides."""


class HeadingArmFile(_AnyArm, frozen=True, kw_only=True, tag="heading-pitch-pitch-heading-pitch-roll"):
    """An arm of the concept's kind."""

    geometry: HeadingGeometry
    masses: MassesFile[HeadingParts]
    stand: StandFile
    booms: BoomsFile
    effector: EffectorFile


ArmFile = YawArmFile | HeadingArmFile
"""An arm file, decoded."""
