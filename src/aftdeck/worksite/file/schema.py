"""Schema of a worksite's file, which contains every dimension of the worksite.

Positions are in the axes of the body to which a table belongs. The first body's axes are those of the scene: x aft,
y starboard, z up. `source` gives the source of a table's numbers, or ``assumed``. The modules `solids`,
`payload` and `check` check the rules that types cannot express.
"""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from aftdeck.bodies.camera_file import CameraFile, DriveFile
from aftdeck.bodies.mass_properties import impossible, tensor
from aftdeck.bounds import Bounds
from aftdeck.shapes import Shape, without_lamps
from aftdeck.units import Angle, AngularRate, Length, Mass, MomentOfInertia, Speed, Time, Torque
from aftdeck.worksite.berths.kinds import BerthFile
from aftdeck.worksite.capture.kinds import CaptureFile
from aftdeck.worksite.file.cargo_file import CargoFile
from aftdeck.worksite.file.solid_file import SolidFile
from aftdeck.worksite.model import OrbiterMotion
from aftdeck.worksite.relation import FITTING_OF, Relation
from aftdeck.worksite.tables import Placed, Point, Range, Table, Text, ordered, positive


class BodyFile(Placed, frozen=True, kw_only=True):
    """A body that is fixed to the orbiter or in space."""

    name: Text
    fixed_to: Literal["orbiter", "space"] = "orbiter"
    source: Text
    shapes: tuple[Shape, ...] = ()
    """Shapes that draw the body, in addition to the solids that have a material."""
    details: tuple[Shape, ...] = ()
    """Shapes that only decorate the body. Only the station's page draws them. They cannot be lamps."""
    solids: tuple[SolidFile, ...] = ()

    def __post_init__(self) -> None:
        """Reject a lamp among the details (ValueError)."""
        without_lamps(self.details)


class EssentialFile(Table, frozen=True, kw_only=True):
    """Two parts that the task brings into contact. Their contact is essential while certain conditions hold."""

    parts: tuple[Text, Text]
    """A fitting, and a part of the arm or of a body. ``receptacle`` stands for the receptacles of all payloads."""
    relation: Relation
    """Conditions that have to hold. ``acquisition``: the bar is before the palm and between the fingers (conditions 1
    to 3). ``docking``: the probe is in the docking envelope, and is no farther from the port than docking allows.
    ``guides``: the trunnion is in its V-guide. ``capture``: the pin is in the capture envelope, or farther out than the
    envelope's outer end."""
    depth: Length
    """Greatest penetration depth at which the contact is essential. If a condition bounds a part's position by
    planes, the part may be up to this depth beyond the planes."""
    source: Text

    def __post_init__(self) -> None:
        """Reject a depth that is not above zero, and a `relation` that applies to neither part (ValueError)."""
        positive(depth=self.depth)
        fitting = FITTING_OF[self.relation]
        if not any(part == fitting or part.endswith(f" {fitting}") for part in self.parts):
            raise ValueError(
                f"relation {self.relation!r} applies to a {fitting}; parts are {self.parts[0]!r} and {self.parts[1]!r}"
            )


class _Inside(Table, frozen=True, kw_only=True):
    """A box along the axes, given by its range along each axis."""

    x: Range
    y: Range
    z: Range
    source: Text

    def __post_init__(self) -> None:
        """Reject ranges that do not ascend (ValueError)."""
        ordered(x=self.x, y=self.y, z=self.z)


class BayFile(_Inside, frozen=True, kw_only=True):
    """The inside of the payload bay.

    A payload counts as extracted when none of its vertices is between the bay's walls and below the bay's top.
    """


class TranslationFile(Table, frozen=True, kw_only=True):
    """Translation of the orbiter relative to bodies that do not move with it."""

    speed: Speed
    reached_in: Time
    source: Text

    def __post_init__(self) -> None:
        """Reject values that are not above zero (ValueError)."""
        positive(speed=self.speed, reached_in=self.reached_in)


ORBITER_MASS = Bounds(1.0, 1e6, "an empty orbiter has 85 t, the ISS 420 t")
"""Plausible mass of an orbiter [kg]."""
OrbiterInertia = Annotated[MomentOfInertia, Bounds(1e-3, 1e10, "the orbiter has 1e6 to 1e7 kg m2, the ISS about 1e8")]


JetTorque = Annotated[Torque, Bounds(1e-6, 1e9, "the orbiter's vernier jets give about 1e3 N m, its primary jets 1e5")]


class JetsFile(Table, frozen=True, kw_only=True):
    """Jets that hold the orbiter's attitude: each axis has its own, which are on or off."""

    torque: tuple[JetTorque, JetTorque, JetTorque]
    """Torque about roll, pitch and yaw axis."""
    least_pulse: Time
    """Least time for which a jet is on."""
    angle: Angle
    """Deadband: greatest angle about each axis at which no jet acts."""
    rate: AngularRate
    """Deadband: greatest rate about each axis at which no jet acts."""
    source: Text

    def __post_init__(self) -> None:
        """Reject values that are not above zero (ValueError)."""
        positive(least_pulse=self.least_pulse, angle=self.angle, rate=self.rate)


class OrbiterFile(Table, frozen=True, kw_only=True):
    """Mass of the orbiter, which carries the arm; a plant with masses needs it."""

    mass: Annotated[Mass, ORBITER_MASS]
    inertia: tuple[OrbiterInertia, OrbiterInertia, OrbiterInertia]
    """Moments of inertia about roll, pitch and yaw axis, through the centre of mass."""
    centre: Point | None = None
    """Centre of mass: structural Xo, Yo, Zo. Without it, it is the origin of the arm's orbiter frame."""
    jets: JetsFile | None = None
    motion: OrbiterMotion = "free"
    """Motion on a plant with masses, unless a scenario gives another (`dynamics.orbiter`)."""
    source: Text

    def __post_init__(self) -> None:
        """Reject moments of inertia that no body has, and a motion that needs jets (ValueError)."""
        if self.motion == "held" and self.jets is None:
            raise ValueError("motion 'held' needs the table jets, which hold the attitude")
        if why := impossible(tensor(self.inertia)):
            raise ValueError(why)


class HousingFile(_Inside, frozen=True, kw_only=True):
    """Housing of every camera that has a certain drive.

    The origin is the point where the pan and tilt axes meet; x is ahead at zero pan and tilt, y is to the left, and z
    is the camera's `up`. The solid that collides is the box given by x, y and z; if these axes are not parallel to
    those of the camera's body, it is the least box along the body's axes that encloses it. It has to enclose the whole
    housing in every position of the drive.
    """

    drive: Text
    turned: tuple[Shape, ...] = ()
    """Shapes of the camera's body. Their x axis is along the boresight at the start."""
    upright: tuple[Shape, ...] = ()
    """Shapes of the support, which are always upright."""


class WorksiteFile(Table, frozen=True, kw_only=True):
    """A worksite's file, decoded."""

    name: Text
    title: Text
    dimensions: dict[str, str | float] = msgspec.field(default_factory=dict)
    """Named quantities from which others are derived (`aftdeck.dimensions`)."""
    origin: Point
    """Structural Xo, Yo, Zo of the scene's origin."""
    body: tuple[BodyFile, ...]
    seat: tuple[BerthFile, ...] = ()
    cargo: tuple[CargoFile, ...] = ()
    camera: tuple[CameraFile, ...] = ()
    drive: tuple[DriveFile, ...] = ()
    housing: tuple[HousingFile, ...] = ()
    camera_clearance: Length = Length(0.0)
    """Least distance of a camera from every solid."""
    essential: tuple[EssentialFile, ...] = ()
    acquisition: CaptureFile | None = None
    bay: BayFile | None = None
    translation: TranslationFile | None = None
    orbiter: OrbiterFile | None = None
    """Mass of the orbiter; without it, the arm's base is fixed in space on every plant."""
