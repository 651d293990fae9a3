"""Data model of the worksite: the bodies around the arm, their solids, the berths of payloads, and the cameras.

The coordinate frames of solids and berths are ``orbiter`` (that of the scene, fixed to the orbiter), ``space`` and one
named after each payload. ``space`` coincides with ``orbiter`` at the start, but does not move with the orbiter.
"""

from __future__ import annotations

from typing import Literal

import msgspec
import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.cameras import Camera, Vec3
from aftdeck.bodies.solid import Solid
from aftdeck.frames import Pose, endori
from aftdeck.shapes import Shape

Frame = Literal["orbiter", "space"]


class Body(msgspec.Struct, frozen=True):
    """A rigid body of the worksite."""

    name: str
    """Name used by cameras and the scene, for example ``orbiter``."""
    shapes: tuple[Shape, ...]
    """Shapes that draw the body, in its own frame."""
    fixed_to: Frame = "orbiter"
    position: Vec3 = (0.0, 0.0, 0.0)
    """Position of the body's own frame in the scene at the start [m]."""
    rotation: Vec3 = (0.0, 0.0, 0.0)
    """Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]."""

    @property
    def pose(self) -> Pose:
        """Pose of the body's own frame in the scene at the start."""
        return Pose(np.array(self.position), endori(*self.rotation))


class Guides(msgspec.Struct, frozen=True):
    """V-shaped guides over each longeron latch."""

    height: float
    """Height of the guides' upper ends above the stowed trunnion [m]."""
    half_angle: float
    """Half angle of the V's opening, from the vertical [rad]."""
    throat: float
    """Half the width of the V at the stowed trunnion, less the trunnion's radius [m]."""
    play: float
    """Greatest offset of a trunnion along its own axis, in either direction [m]."""


class Seat(msgspec.Struct, frozen=True, eq=False):
    """A berth, where a payload can be fixed: a docking port, or a berth in the bay."""

    name: str
    title: str
    kind: Literal["port", "retention"]
    body: str
    frame: Frame
    pose: Pose
    """Pose of the port's centre, or of a seated payload, in `frame`."""
    latch: Literal["auto", "command"]
    time: float
    """Time that the latches take [s]."""
    distance: float
    """Greatest distance of a payload from its seated position for latching [m]."""
    angle: float
    """Greatest rotation of a payload from its seated attitude for latching [rad]."""
    envelope: Array
    """Docking envelope of a port: (5, 4) planes in the port's axes about its centre. Each has a unit normal n [1] and a
    distance d [m]. The planes are those of the port's face and of the four adjacent faces, extended. A point p is in
    the envelope if n.p <= d for all planes."""
    guides: Guides | None
    """Guides of a bay berth; a berth with guides holds only payloads that have trunnions."""

    def lacks(self, probe: Pose | None, trunnions: Array) -> str:
        """Return the fitting that a payload with this probe and these trunnions lacks for this berth; empty if none."""
        if self.kind == "port":
            return "" if probe else "probe"
        return "trunnions" if self.guides and not len(trunnions) else ""

    def seated(self, probe: Pose | None) -> Pose:
        """Return the pose of a seated payload's frame in the berth's frame; in a port, the probe is at the port."""
        if self.kind == "retention" or probe is None:
            return self.pose
        rotation = self.pose.rotation @ probe.rotation.T
        return Pose(self.pose.position - rotation @ probe.position, rotation)


class Start(msgspec.Struct, frozen=True, eq=False):
    """Position and motion of a payload at the start."""

    seat: str
    """Name of the berth that holds the payload; empty if the payload is free."""
    pose: Pose
    """Pose in the scene at the start, given for a seated payload as well."""
    velocity: Array
    """(3,) velocity of the payload's centre relative to the orbiter, in the scene [m/s]."""
    rates: Array
    """(3,) angular rates about the payload's own axes [rad/s]."""


class LimitCycle(msgspec.Struct, frozen=True, eq=False):
    """Limit cycle of a free payload's attitude control."""

    deadband: Array
    """(3,) greatest angles to either side, about the payload's own axes [rad]."""
    rate: Array
    """(3,) rate of each angle; the sign is the initial direction [rad/s]."""
    start: Array
    """(3,) angles at time 0, each within its deadband [rad]."""


class Cargo(msgspec.Struct, frozen=True, eq=False):
    """A payload. The origin of its own frame is at its body's centre: x along the body, to aft in the bay, z up."""

    name: str
    """Name of the payload and of its frame."""
    title: str
    mass: float
    """Mass [kg]."""
    shapes: tuple[Shape, ...]
    """Shapes that draw the payload."""
    solids: tuple[Solid, ...]
    """Solids in the payload's own frame; parts are named after payload and fitting: ``payload``, ``payload probe``."""
    probe: Pose | None
    """Pose of the centre of the probe's forward face; its axes are the payload's."""
    receptacle: Array | None
    """(8, 3) the bar [m], numbered as the report's RECPT in axes x aft, y port, z down: c on top, b and e its sides."""
    grapple: Pose | None
    """Pose of the end effector's own axes E, about the tip, at a perfect grasp of the fixture."""
    trunnions: Array
    """(n, 3) the points that the bay's latches hold, port and starboard of each pair, then the keel pin's [m]."""
    trunnion_names: tuple[str, ...]
    """``forward port``, ``forward starboard`` … ``keel``; unless there are two pairs, numbers such as ``2 port``."""
    start: Start
    limit_cycle: LimitCycle | None


class BarAcquisition(msgspec.Struct, frozen=True):
    """Conditions for the concept's end effector to acquire a bar; the report's names are in brackets."""

    prong_spacing: float
    """Greatest distance of the prong's inner face from the palm's centre line for a closed prong (PRGSPC) [m]."""
    window: float
    """Greatest height of the palm above the bar's top (TOPB) [m]."""
    front: float
    """Least distance of the palm's centre inward from the bar's forward end (FRONT) [m]."""
    rear: float
    """Least distance of the palm's centre inward from the bar's aft end (REAR) [m]."""
    fingers_within: float
    """Distance of palm and bar beyond which the fingers are not tested [m]."""


class SnareCapture(msgspec.Struct, frozen=True):
    """Capture envelope of the Shuttle's end effector, and the durations of its motions."""

    radial: float
    """Greatest distance from the end effector's axis [m]."""
    nearest: float
    """Least position of the fixture along the axis, outwards from its rigid position [m]."""
    farthest: float
    """Greatest position of the fixture along the axis, as `nearest` [m]."""
    pitch: float
    """Limit about axis 2 of E, to either side [rad]."""
    yaw: float
    """Limit about axis 3 of E, to either side [rad]."""
    roll: float
    """Limit about axis 1 of E, to either side [rad]."""
    ring: float
    """Time to close or open the snares [s]."""
    carriage: float
    """Time to retract or extend the carriage [s]."""
    tension: float
    """Time to rigidize or derigidize [s]."""


Relation = Literal["acquisition", "docking", "guides", "capture"]
"""Conditions under which two parts may touch: those of the bar, the port, the V-guides or the grapple fixture."""


class Essential(msgspec.Struct, frozen=True):
    """Two parts that the task brings into contact, with the relation and depth within which they may touch."""

    parts: tuple[str, str]
    """Names of a payload's part and of a part of the arm or of a body."""
    relation: Relation
    """Relation of the two parts; if it does not hold, the contact is detrimental."""
    depth: float
    """Greatest penetration of the two parts, and greatest distance past the relation's planes [m]."""


class Bay(msgspec.Struct, frozen=True):
    """The inside of the payload bay, in the frame ``orbiter``; a payload completely above it has been extracted."""

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


class Worksite(msgspec.Struct, frozen=True, eq=False):
    """A worksite. The first body's own frame is the scene frame."""

    name: str
    title: str
    bodies: tuple[Body, ...]
    cameras: tuple[Camera, ...]
    text: str
    """Text of the file, unparsed."""
    dimensions: dict[str, str | float]
    """Derived dimensions; a scenario may replace their values."""
    origin: Vec3
    """Structural Xo, Yo, Zo of the scene's origin [m]."""
    solids: tuple[Solid, ...]
    """Solids of the bodies, in the frames ``orbiter`` and ``space``."""
    seats: tuple[Seat, ...]
    cargoes: tuple[Cargo, ...]
    """Available payloads; a scenario names those that are present."""
    essential: tuple[Essential, ...]
    """Pairs of parts that the task brings into contact; some are parts of the arm."""
    acquisition: BarAcquisition | SnareCapture | None
    bay: Bay | None
    translation: Translation | None
