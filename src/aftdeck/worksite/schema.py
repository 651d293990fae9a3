"""A worksite's file as it is written: every dimension of the place, each table with the source of its numbers.

Places are in the axes of the body that a table belongs to; the first body's are the scene's: x aft, y starboard, z up.
`source` says where a table's numbers come from, or ``assumed``. What types cannot say is checked where the parts are
made (`solids`, `seats`, `cargo`) and in `check`.
"""

from __future__ import annotations

from typing import Literal

import msgspec

from aftdeck.bodies.camera_file import CameraFile, DriveFile
from aftdeck.shapes import Material, Shape
from aftdeck.units import Angle, Length, Speed, Time
from aftdeck.worksite.cargo_file import CargoFile
from aftdeck.worksite.model import Relation
from aftdeck.worksite.solid_file import SolidFile
from aftdeck.worksite.tables import Placed, Point, Range, Table, Text, ordered, positive

FITTING_OF: dict[Relation, str] = {
    "acquisition": "receptacle",
    "docking": "probe",
    "guides": "trunnions",
    "capture": "grapple fixture",
}
"""Which of a cargo's fittings a relation is about."""


class BodyFile(Placed, frozen=True, kw_only=True):
    """A body that stands still on the orbiter, or in space."""

    name: Text
    fixed_to: Literal["orbiter", "space"] = "orbiter"
    source: Text
    shapes: tuple[Shape, ...] = ()
    """What it looks like, besides the solids that have a material."""
    solids: tuple[SolidFile, ...] = ()


class _SeatFile(Placed, frozen=True, kw_only=True, tag_field="kind"):
    """Where a cargo can be fixed to a body."""

    name: Text
    title: Text
    body: Text
    latch: Literal["auto", "command"]
    """Whether it holds a cargo as soon as it may, or when it is told to."""
    time: Time = Time(0.0)
    """How long its latches take."""
    distance: Length
    """How far from its place a cargo may be."""
    angle: Angle
    """How far it may be turned."""
    source: Text

    def __post_init__(self) -> None:
        """Refuse tolerances that are not above zero (ValueError)."""
        positive(distance=self.distance, angle=self.angle)
        if self.time < 0.0:
            raise ValueError(f"time is {self.time:g} s; it cannot be below 0")


class PortFile(_SeatFile, frozen=True, kw_only=True, tag="port"):
    """A docking port: its centre lies on a face of a solid, its axes are those of a docked cargo; x looks outwards."""

    radius: Length
    """Of the disc that shows where it is."""
    material: Material


class GuidesFile(Table, frozen=True, kw_only=True):
    """V-shaped guides over each longeron latch."""

    height: Length
    """From the trunnion's place to their upper ends."""
    half_angle: Angle
    """Of the V's opening, from the vertical."""
    throat: Length
    """Half the width of the V at the trunnion's place, less the trunnion's radius."""
    play: Length
    """How far a trunnion may stand either way along its own axis."""

    def __post_init__(self) -> None:
        """Refuse what is not above zero (ValueError)."""
        positive(height=self.height, half_angle=self.half_angle, throat=self.throat, play=self.play)


class RetentionFile(_SeatFile, frozen=True, kw_only=True, tag="retention"):
    """A place in the bay: position and rotation are those of a seated cargo."""

    guides: GuidesFile | None = None
    """With them a cargo needs trunnions."""


SeatFile = PortFile | RetentionFile


class BarFile(Table, frozen=True, kw_only=True, tag_field="kind", tag="bar"):
    """When the concept's hand has acquired a bar; the report's names in brackets."""

    prong_spacing: Length
    """From the palm's centre line to the prong's inner face, at most which the prong is closed (PRGSPC)."""
    window: Length
    """Of the palm's height over the bar's top (TOPB)."""
    front: Length
    """How far from the bar's forward end the palm's centre has to be, inwards (FRONT)."""
    rear: Length
    """The same of the aft end (REAR)."""
    fingers_within: Length
    """Distance of palm and bar beyond which the fingers are not tested."""
    source: Text

    def __post_init__(self) -> None:
        """Refuse distances that are not above zero (ValueError)."""
        positive(prong_spacing=self.prong_spacing, window=self.window, fingers_within=self.fingers_within)


class SnareFile(Table, frozen=True, kw_only=True, tag_field="kind", tag="snare"):
    """When the Shuttle's end effector can capture a grapple fixture, and how long it takes."""

    radial: Length
    """From the end effector's axis."""
    nearest: Length
    """Along the axis, outwards, from where the fixture stands when it is rigid."""
    farthest: Length
    """The same."""
    pitch: Angle
    """To either side."""
    yaw: Angle
    roll: Angle
    ring: Time
    """To close or open the snares."""
    carriage: Time
    """To retract or extend."""
    tension: Time
    """To rigidize or derigidize."""
    source: Text

    def __post_init__(self) -> None:
        """Refuse what is not above zero (ValueError)."""
        positive(radial=self.radial, pitch=self.pitch, yaw=self.yaw, roll=self.roll)
        positive(ring=self.ring, carriage=self.carriage, tension=self.tension)
        if not self.nearest < self.farthest:
            raise ValueError(f"nearest is {self.nearest:g} m and farthest {self.farthest:g} m; nearest has to be less")


class EssentialFile(Table, frozen=True, kw_only=True):
    """Two parts that the task brings into contact: by which conditions they may touch, and how deep."""

    parts: tuple[Text, Text]
    """A cargo's fitting by its own name (``receptacle``), of every cargo, and a part of the arm or of a body."""
    relation: Relation
    """``acquisition``: the bar before the palm and between the fingers (conditions 1 to 3). ``docking``: the probe in
    the docking envelope, no farther from the port than docking allows. ``guides``: the trunnion in its V-guide.
    ``capture``: the pin in the capture envelope."""
    depth: Length
    """How deep the two may be in each other, and how far past the planes of the relation."""
    source: Text

    def __post_init__(self) -> None:
        """Refuse a depth that is not above zero, and a relation of another fitting (ValueError)."""
        positive(depth=self.depth)
        fitting = FITTING_OF[self.relation]
        if not any(part == fitting or part.endswith(f" {fitting}") for part in self.parts):
            raise ValueError(
                f"relation {self.relation!r} is that of a {fitting}; parts are {self.parts[0]!r} and {self.parts[1]!r}"
            )


class _Inside(Table, frozen=True, kw_only=True):
    """A box along the axes, by where it begins and ends."""

    x: Range
    y: Range
    z: Range
    source: Text

    def __post_init__(self) -> None:
        """Refuse ranges without an inside (ValueError)."""
        ordered(x=self.x, y=self.y, z=self.z)


class BayFile(_Inside, frozen=True, kw_only=True):
    """The inside of the cargo bay: a cargo that is all above it has been extracted."""


class TranslationFile(Table, frozen=True, kw_only=True):
    """How the orbiter moves against what does not move with it."""

    speed: Speed
    reached_in: Time
    source: Text

    def __post_init__(self) -> None:
        """Refuse what is not above zero (ValueError)."""
        positive(speed=self.speed, reached_in=self.reached_in)


class HousingFile(_Inside, frozen=True, kw_only=True):
    """What every camera of a drive is made of, about the point where the axes of pan and tilt meet, z up.

    The box is what collides: round all of it, however it turns.
    """

    drive: Text
    turned: tuple[Shape, ...] = ()
    """How it looks that is turned as the camera is at the start, x ahead."""
    upright: tuple[Shape, ...] = ()
    """How what carries it looks."""


class WorksiteFile(Table, frozen=True, kw_only=True):
    """A worksite's file, decoded."""

    name: Text
    title: Text
    dimensions: dict[str, str | float] = msgspec.field(default_factory=dict)
    """Named quantities, of which others are derived (`aftdeck.dimensions`)."""
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
