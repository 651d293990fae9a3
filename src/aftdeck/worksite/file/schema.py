"""Schema of a worksite's file: every dimension of the worksite, each table with the source of its numbers.

Positions are in the axes of the body that a table belongs to. The first body's axes are those of the scene: x aft,
y starboard, z up. `source` gives the source of a table's numbers, or ``assumed``. Rules that types cannot express are
checked where the parts are made (`solids`, `seats`, `cargo`) and in `check`.
"""

from __future__ import annotations

from typing import Literal

import msgspec

from aftdeck.bodies.camera_file import CameraFile, DriveFile
from aftdeck.shapes import Material, Shape
from aftdeck.units import Angle, Length, Speed, Time
from aftdeck.worksite.file.cargo_file import CargoFile
from aftdeck.worksite.file.solid_file import SolidFile
from aftdeck.worksite.file.tables import Placed, Point, Range, Table, Text, ordered, positive
from aftdeck.worksite.model import Relation

FITTING_OF: dict[Relation, str] = {
    "acquisition": "receptacle",
    "docking": "probe",
    "guides": "trunnions",
    "capture": "grapple fixture",
}
"""Fitting of a payload to which each relation applies."""


class BodyFile(Placed, frozen=True, kw_only=True):
    """A body that is fixed to the orbiter or in space."""

    name: Text
    fixed_to: Literal["orbiter", "space"] = "orbiter"
    source: Text
    shapes: tuple[Shape, ...] = ()
    """Shapes that draw the body, in addition to the solids that have a material."""
    solids: tuple[SolidFile, ...] = ()


class _SeatFile(Placed, frozen=True, kw_only=True, tag_field="kind"):
    """A berth, where a payload can be fixed to a body."""

    name: Text
    title: Text
    body: Text
    latch: Literal["auto", "command"]
    """``auto`` to hold a payload as soon as possible, ``command`` to wait for a command."""
    time: Time = Time(0.0)
    """Time that the latches take."""
    distance: Length
    """Greatest distance of a payload from its seated position for latching."""
    angle: Angle
    """Greatest rotation of a payload from its seated attitude for latching."""
    source: Text

    def __post_init__(self) -> None:
        """Reject tolerances that are not above zero, and a negative time (ValueError)."""
        positive(distance=self.distance, angle=self.angle)
        if self.time < 0.0:
            raise ValueError(f"time is {self.time:g} s; it cannot be below 0")


class PortFile(_SeatFile, frozen=True, kw_only=True, tag="port"):
    """A docking port: its centre is on a face of a solid, its axes are those of a docked payload; x points outwards."""

    radius: Length
    """Radius of the disc that marks the port."""
    material: Material


class GuidesFile(Table, frozen=True, kw_only=True):
    """V-shaped guides over each longeron latch."""

    height: Length
    """Height of the guides' upper ends above the stowed trunnion."""
    half_angle: Angle
    """Half angle of the V's opening, from the vertical."""
    throat: Length
    """Half the width of the V at the stowed trunnion, less the trunnion's radius."""
    play: Length
    """Greatest offset of a trunnion along its own axis, in either direction."""

    def __post_init__(self) -> None:
        """Reject values that are not above zero (ValueError)."""
        positive(height=self.height, half_angle=self.half_angle, throat=self.throat, play=self.play)


class RetentionFile(_SeatFile, frozen=True, kw_only=True, tag="retention"):
    """A berth in the bay: position and rotation are those of a seated payload."""

    guides: GuidesFile | None = None
    """V-guides; if they are given, a payload needs trunnions."""


SeatFile = PortFile | RetentionFile


class BarFile(Table, frozen=True, kw_only=True, tag_field="kind", tag="bar"):
    """Conditions for the concept's end effector to acquire a bar; the report's names are in brackets."""

    prong_spacing: Length
    """Greatest distance of the prong's inner face from the palm's centre line for a closed prong (PRGSPC)."""
    window: Length
    """Greatest height of the palm above the bar's top (TOPB)."""
    front: Length
    """Least distance of the palm's centre inward from the bar's forward end (FRONT)."""
    rear: Length
    """Least distance of the palm's centre inward from the bar's aft end (REAR)."""
    fingers_within: Length
    """Distance of palm and bar beyond which the fingers are not tested."""
    source: Text

    def __post_init__(self) -> None:
        """Reject spacing, window and finger distance that are not above zero (ValueError)."""
        positive(prong_spacing=self.prong_spacing, window=self.window, fingers_within=self.fingers_within)


class SnareFile(Table, frozen=True, kw_only=True, tag_field="kind", tag="snare"):
    """Capture envelope of the Shuttle's end effector for a grapple fixture, and the durations of its motions."""

    radial: Length
    """Greatest distance from the end effector's axis."""
    nearest: Length
    """Least position of the fixture along the axis, outwards from its rigid position."""
    farthest: Length
    """Greatest position of the fixture along the axis, as `nearest`."""
    pitch: Angle
    """Greatest angle to either side; likewise `yaw` and `roll`."""
    yaw: Angle
    roll: Angle
    ring: Time
    """Time to close or open the snares."""
    carriage: Time
    """Time to retract or extend the carriage."""
    tension: Time
    """Time to rigidize or derigidize."""
    source: Text

    def __post_init__(self) -> None:
        """Reject values that are not above zero, and `nearest` that is not below `farthest` (ValueError)."""
        positive(radial=self.radial, pitch=self.pitch, yaw=self.yaw, roll=self.roll)
        positive(ring=self.ring, carriage=self.carriage, tension=self.tension)
        if not self.nearest < self.farthest:
            raise ValueError(f"nearest is {self.nearest:g} m and farthest {self.farthest:g} m; nearest has to be less")


class EssentialFile(Table, frozen=True, kw_only=True):
    """Two parts that the task brings into contact: the conditions under which they may touch, and how deep."""

    parts: tuple[Text, Text]
    """A fitting by its own name (``receptacle``: that of every payload), and a part of the arm or a body."""
    relation: Relation
    """``acquisition``: the bar before the palm and between the fingers (conditions 1 to 3). ``docking``: the probe in
    the docking envelope, no farther from the port than docking allows. ``guides``: the trunnion in its V-guide.
    ``capture``: the pin in the capture envelope."""
    depth: Length
    """Greatest penetration of the two parts, and greatest distance past the relation's planes."""
    source: Text

    def __post_init__(self) -> None:
        """Reject a depth that is not above zero, and a relation of another fitting (ValueError)."""
        positive(depth=self.depth)
        fitting = FITTING_OF[self.relation]
        if not any(part == fitting or part.endswith(f" {fitting}") for part in self.parts):
            raise ValueError(
                f"relation {self.relation!r} applies to a {fitting}; parts are {self.parts[0]!r} and {self.parts[1]!r}"
            )


class _Inside(Table, frozen=True, kw_only=True):
    """A box along the axes, given by its range on each axis."""

    x: Range
    y: Range
    z: Range
    source: Text

    def __post_init__(self) -> None:
        """Reject ranges that do not ascend (ValueError)."""
        ordered(x=self.x, y=self.y, z=self.z)


class BayFile(_Inside, frozen=True, kw_only=True):
    """The inside of the payload bay: a payload completely above it has been extracted."""


class TranslationFile(Table, frozen=True, kw_only=True):
    """Translation of the orbiter relative to bodies that do not move with it."""

    speed: Speed
    reached_in: Time
    source: Text

    def __post_init__(self) -> None:
        """Reject values that are not above zero (ValueError)."""
        positive(speed=self.speed, reached_in=self.reached_in)


class HousingFile(_Inside, frozen=True, kw_only=True):
    """Housing of every camera of a drive, about the point where the pan and tilt axes meet, z up.

    The box is the solid that collides; it has to enclose the whole housing in every position of the drive.
    """

    drive: Text
    turned: tuple[Shape, ...] = ()
    """Shapes that are turned as the camera is at the start, x ahead."""
    upright: tuple[Shape, ...] = ()
    """Shapes of the support, which stay upright."""


class WorksiteFile(Table, frozen=True, kw_only=True):
    """A worksite's file, decoded."""

    name: Text
    title: Text
    dimensions: dict[str, str | float] = msgspec.field(default_factory=dict)
    """Named quantities from which others are derived (`aftdeck.dimensions`)."""
    origin: Point
    """Structural Xo, Yo, Zo of the scene's origin."""
    body: tuple[BodyFile, ...]
    seat: tuple[SeatFile, ...] = ()
    cargo: tuple[CargoFile, ...] = ()
    camera: tuple[CameraFile, ...] = ()
    drive: tuple[DriveFile, ...] = ()
    housing: tuple[HousingFile, ...] = ()
    camera_clearance: Length = Length(0.0)
    """Least distance of a camera from every solid."""
    essential: tuple[EssentialFile, ...] = ()
    acquisition: BarFile | SnareFile | None = None
    bay: BayFile | None = None
    translation: TranslationFile | None = None
