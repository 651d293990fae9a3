"""Data model of the worksite: the bodies around the arm, their solids, the berths of payloads, and the cameras.

Solids and berths are given in one of these coordinate frames: ``orbiter``, ``space``, or a payload's own frame. A
payload's own frame has the payload's name. ``orbiter`` is the scene's frame and is fixed to the orbiter. ``space``
coincides with ``orbiter`` at the start, but does not move with the orbiter.
"""

from __future__ import annotations

from typing import Literal

import msgspec
import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.cameras import Camera
from aftdeck.bodies.mass_properties import MassProperties
from aftdeck.bodies.solid import Solid
from aftdeck.frames import Mount, Pose, endori
from aftdeck.matrices import product
from aftdeck.shapes import Shape
from aftdeck.tuples import Vec3

Frame = Literal["orbiter", "space"]
OrbiterMotion = Literal["free", "held", "fixed"]
"""Motion of the orbiter on a plant with masses: it drifts, jets hold its attitude besides, or it does not move."""


class Body(msgspec.Struct, frozen=True):
    """A rigid body of the worksite."""

    name: str
    """Name by which cameras and the scene refer to the body, for example ``orbiter``."""
    shapes: tuple[Shape, ...]
    """Shapes that draw the body, in its own frame."""
    details: tuple[Shape, ...] = ()
    """Shapes that only decorate the body, in its own frame. The station's page draws them. Nothing else uses them:
    neither contacts, nor what cameras see, nor the pictures without a depth buffer."""
    fixed_to: Frame = "orbiter"
    """Coordinate frame to which the body is fixed."""
    position: Vec3 = (0.0, 0.0, 0.0)
    """Position of the body's own frame in the scene at the start [m]."""
    rotation: Vec3 = (0.0, 0.0, 0.0)
    """Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]."""

    @property
    def pose(self) -> Pose:
        """Pose of the body's own frame in the scene at the start."""
        return Pose(np.array(self.position), endori(*self.rotation))


class Mounted(msgspec.Struct, frozen=True, eq=False):
    """Housings of the worksite's cameras on one frame of an arm, in that frame's axes."""

    shapes: tuple[Shape, ...]
    solids: tuple[Solid, ...]


class Guides(msgspec.Struct, frozen=True):
    """V-shaped guides over each longeron latch."""

    height: float
    """Height of the guides' upper ends above the stowed trunnion [m]."""
    half_angle: float
    """Angle between the vertical and each side of the V [rad]."""
    throat: float
    """Half the width of the V at the height of the stowed trunnion, minus the trunnion's radius [m]."""
    play: float
    """Greatest offset of a trunnion along its own axis, in either direction [m]."""


class Seat(msgspec.Struct, frozen=True, eq=False):
    """A berth, where a payload can be fixed: a docking port, or a berth in the bay.

    A payload is *seated* when it has the pose in which the berth fixes it.
    """

    name: str
    title: str
    kind: Literal["port", "retention"]
    body: str
    frame: Frame
    pose: Pose
    """Pose in `frame`: for a port, the pose of the port's centre; for a bay berth, the pose of a seated payload."""
    latch: Literal["auto", "command"]
    time: float
    """Time that the latches take [s]."""
    distance: float
    """Greatest distance from the seated position at which a payload can be latched [m]."""
    angle: float
    """Greatest rotation from the seated attitude at which a payload can be latched [rad]."""
    envelope: Array
    """Docking envelope of a port: (5, 4) planes in the port's axes, with its centre as origin; (0, 4) for a bay berth.

    Each plane has a unit normal n [1] and a distance d [m]. The planes are those of the port's face and of the four
    adjacent faces, extended. A point p is in the envelope if n.p <= d for all planes.
    """
    guides: Guides | None
    """V-shaped guides of a bay berth; None if there are no guides. A berth with guides holds only payloads that have
    trunnions."""

    def lacks(self, probe: Pose | None, trunnions: Array) -> str:
        """Return the name of the fitting that this berth needs and a payload lacks; empty if the payload fits.

        Args:
            probe: `Cargo.probe` of the payload.
            trunnions: `Cargo.trunnions` of the payload.
        """
        if self.kind == "port":
            return "" if probe else "probe"
        return "trunnions" if self.guides and not len(trunnions) else ""

    def seated(self, probe: Pose | None) -> Pose:
        """Return the pose of a seated payload's own frame in the berth's frame.

        In a port, the centre of the probe's forward face is then at the port's centre.
        """
        if self.kind == "retention" or probe is None:
            return self.pose
        rotation = product(self.pose.rotation, probe.rotation.T)
        return Pose(self.pose.position - product(rotation, probe.position), rotation)


class Start(msgspec.Struct, frozen=True, eq=False):
    """Position and motion of a payload at the start."""

    seat: str
    """Name of the berth that holds the payload; empty if the payload is free."""
    pose: Pose
    """Pose in the scene at the start, also if the payload starts in a berth."""
    velocity: Array
    """(3,) velocity of the payload's centre relative to the orbiter, in the scene [m/s]."""
    rates: Array
    """(3,) angular rates about the payload's own axes [rad/s]."""


class LimitCycle(msgspec.Struct, frozen=True, eq=False):
    """Limit cycle of a free payload's attitude control."""

    deadband: Array
    """(3,) greatest angles to either side, about the payload's own axes [rad]."""
    rate: Array
    """(3,) rate of each angle [rad/s]; its sign gives the initial direction."""
    start: Array
    """(3,) angles at time 0, each within its deadband [rad]."""


class Cargo(msgspec.Struct, frozen=True, eq=False):
    """A payload. The origin of its own frame is at its body's centre.

    The x axis is along the body. In the bay berth it points aft, and the z axis points up.
    """

    name: str
    """Name of the payload and of its frame."""
    title: str
    mass: float
    """Mass [kg]."""
    inertia: Array
    """(3, 3) tensor of inertia about the centre of mass, along the payload's axes [kg m2]."""
    centre_of_mass: Array
    """(3,) vector from the payload's centre to its centre of mass, in its axes [m]."""
    shapes: tuple[Shape, ...]
    """Shapes that draw the payload."""
    solids: tuple[Solid, ...]
    """Solids in the payload's own frame. The payload's body is one part, which has the payload's name (for example
    ``payload``). Each fitting is a further part. Its name consists of the payload's name and the fitting's name
    (``payload probe``)."""
    probe: Pose | None
    """Pose of the centre of the probe's forward face, with the payload's axes; None if there is no probe."""
    receptacle: Array | None
    """(8, 3) vertices of the bar [m]; None if there is no bar. The vertices are numbered as in the report's RECPT,
    whose axes are x aft, y port and z down: face c is on top, faces b and e are the sides."""
    grapple: Pose | None
    """Pose of the end effector's own axes E, with the tip as their origin, when the grapple fixture is captured without
    misalignment; None if there is no grapple fixture."""
    trunnions: Array
    """(n, 3) points that the bay's latches hold [m]: the port and the starboard point of each pair of trunnions, then
    the point of the keel pin."""
    trunnion_names: tuple[str, ...]
    """Names of these points. For two pairs: ``forward port``, ``forward starboard``, ``aft port``, ``aft starboard``,
    ``keel``. For any other number of pairs, the pairs are numbered: ``1 port``, ``1 starboard``."""
    start: Start
    limit_cycle: LimitCycle | None
    details: tuple[Shape, ...]
    """Shapes that only decorate the payload's fixture, as `Body.details`. `aftdeck.details` adds those of its hull."""

    @property
    def properties(self) -> MassProperties:
        """Mass properties in the payload's own frame."""
        return MassProperties(self.mass, self.centre_of_mass, self.inertia)


class BarAcquisition(msgspec.Struct, frozen=True):
    """Conditions for the concept's end effector to acquire a bar; the report's names are in brackets."""

    prong_spacing: float
    """Greatest distance from the palm's centre line to the inner face of a prong that counts as closed (PRGSPC) [m]."""
    window: float
    """Greatest height of the palm above the bar's top (TOPB) [m]."""
    front: float
    """Least distance of the palm's centre from the bar's forward end, inwards along the bar (FRONT) [m]."""
    rear: float
    """Least distance of the palm's centre from the bar's aft end, inwards along the bar (REAR) [m]."""
    fingers_within: float
    """Greatest distance between palm and bar at which the fingers are tested [m]."""


class SnareCapture(msgspec.Struct, frozen=True):
    """Capture envelope of the Shuttle's end effector for a grapple fixture, and the durations of its motions."""

    radial: float
    """Greatest distance of the fixture from the end effector's axis [m]."""
    nearest: float
    """Least coordinate of the fixture along the end effector's axis [m]: 0 in the rigid position, positive outwards."""
    farthest: float
    """Greatest coordinate of the fixture along the end effector's axis [m]; zero and direction as for `nearest`."""
    pitch: float
    """Greatest rotation of the fixture about axis 2 of E, in either direction [rad]."""
    yaw: float
    """Greatest rotation of the fixture about axis 3 of E, in either direction [rad]."""
    roll: float
    """Greatest rotation of the fixture about axis 1 of E, in either direction [rad]."""
    ring: float
    """Time to close or open the snares [s]."""
    carriage: float
    """Time to retract or extend the carriage [s]."""
    tension: float
    """Time to rigidize or derigidize [s]."""


Relation = Literal["acquisition", "docking", "guides", "capture"]
"""Name of a relation: a relative position of two parts in which their contact is essential. The four relations are
those at the bar, the port, the V-guides and the grapple fixture."""
ALIGNED: frozenset[Relation] = frozenset({"docking", "guides"})
"""Relations to which alignment applies: their parts are aligned before they touch."""


class Essential(msgspec.Struct, frozen=True):
    """Two parts whose contact is essential while the parts are in a certain relation."""

    parts: tuple[str, str]
    """Names of the two parts: one part of a payload, and one part of the arm or of a body."""
    relation: Relation
    """Name of the relation. In any other relative position, a contact of the two parts is detrimental."""
    depth: float
    """Greatest penetration depth at which the contact is essential [m]. The test of the relation also uses this value:
    a part may be this far beyond the planes that bound its position."""


class Bay(msgspec.Struct, frozen=True):
    """The inside of the payload bay, in the frame ``orbiter``.

    A payload counts as extracted when none of its vertices is between the bay's walls and below the bay's top.
    """

    low: Vec3
    """Least coordinates [m]."""
    high: Vec3
    """Greatest coordinates [m]."""


class Translation(msgspec.Struct, frozen=True):
    """Translation of the orbiter relative to the frame ``space``."""

    speed: float
    """Commanded speed of each axis [m/s]."""
    reached_in: float
    """Time to reach the speed from rest [s]."""


class Jets(msgspec.Struct, frozen=True):
    """Jets that hold the orbiter's attitude."""

    torque: Vec3
    """Torque about roll, pitch and yaw axis [N m]."""
    least_pulse: float
    """Least time for which a jet is on [s]."""
    angle: float
    """Greatest angle about each axis at which no jet acts [rad]."""
    rate: float
    """Greatest rate about each axis at which no jet acts [rad/s]."""


class OrbiterMass(msgspec.Struct, frozen=True):
    """Mass properties of the orbiter."""

    mass: float
    """Mass [kg]."""
    inertia: Vec3
    """Moments of inertia about roll, pitch and yaw axis, through the centre of mass [kg m2]."""
    centre: Vec3 | None
    """Centre of mass: structural Xo, Yo, Zo [m]; None for the origin of the arm's orbiter frame."""
    jets: Jets | None = None
    """Jets that hold its attitude; None if it has none."""
    motion: OrbiterMotion = "free"
    """Motion on a plant with masses, unless the scenario gives another."""

    def in_l(self, mount: Mount) -> MassProperties:
        """Return the orbiter's mass properties in L, the base frame of the arm with this mount."""
        panel = mount.orbiter_origin
        if self.centre is not None:
            x, y, z = self.centre
            panel = np.array([-x, y, -z])
        to_l = mount.rotation.T
        turned = product(product(to_l, np.diag(self.inertia)), mount.rotation)
        return MassProperties(self.mass, product(to_l, panel - mount.origin), turned)


class Worksite(msgspec.Struct, frozen=True, eq=False):
    """A worksite. The first body's own frame is the scene frame."""

    name: str
    title: str
    bodies: tuple[Body, ...]
    cameras: tuple[Camera, ...]
    text: str
    """Text of the file, unparsed."""
    dimensions: dict[str, str | float]
    """Named dimensions of the file, with expressions replaced by their values. A scenario may give other values."""
    origin: Vec3
    """Structural Xo, Yo, Zo of the scene's origin [m]."""
    solids: tuple[Solid, ...]
    """Solids of the bodies, in the frames ``orbiter`` and ``space``."""
    mounted: dict[str, Mounted]
    """Housings of cameras on an arm, by the name of the arm's frame."""
    seats: tuple[Seat, ...]
    cargoes: tuple[Cargo, ...]
    """Available payloads; a scenario names the payloads that are present."""
    essential: tuple[Essential, ...]
    """Pairs of parts that the task brings into contact. In some pairs, one part belongs to the arm."""
    acquisition: BarAcquisition | SnareCapture | None
    bay: Bay | None
    translation: Translation | None
    orbiter: OrbiterMass | None
    """Mass of the orbiter; None if the worksite has no orbiter that moves."""
