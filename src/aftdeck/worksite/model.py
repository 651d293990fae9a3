"""The worksite: the bodies round the arm, what they collide as, where cargo is kept, and the cameras.

Frames that solids and seats stand in are named ``orbiter`` (the scene's, fixed to the orbiter), ``space`` (the same at
the start, but what stands in it does not move with the orbiter), and for each cargo its own name.
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
    """As cameras and the scene name it: ``orbiter``."""
    shapes: tuple[Shape, ...]
    """What it looks like, in its own frame."""
    fixed_to: Frame = "orbiter"
    position: Vec3 = (0.0, 0.0, 0.0)
    """Of its own frame, in the scene at the start [m]."""
    rotation: Vec3 = (0.0, 0.0, 0.0)
    """Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]."""

    @property
    def pose(self) -> Pose:
        """Its own frame in the scene at the start."""
        return Pose(np.array(self.position), endori(*self.rotation))


class Guides(msgspec.Struct, frozen=True):
    """V-shaped guides over each longeron latch."""

    height: float
    """From the trunnion's place to their upper ends [m]."""
    half_angle: float
    """Of the V's opening, from the vertical [rad]."""
    throat: float
    """Half the width of the V at the trunnion's place, less the trunnion's radius [m]."""
    play: float
    """How far a trunnion may stand either way along its own axis [m]."""


class Seat(msgspec.Struct, frozen=True, eq=False):
    """Where a cargo can be fixed: a docking port, or a place in the bay."""

    name: str
    title: str
    kind: Literal["port", "retention"]
    body: str
    frame: Frame
    pose: Pose
    """In its frame: of the port's centre, or of a seated cargo."""
    latch: Literal["auto", "command"]
    time: float
    """How long its latches take [s]."""
    distance: float
    """How far from its place a cargo may be [m]."""
    angle: float
    """How far it may be turned [rad]."""
    envelope: Array
    """A port's, (5, 4) planes in the port's axes about its centre, each a unit normal n [1] and a distance d [m], of
    the face that it is on and of the four beside it, extended. A point p is in it where n.p <= d for all."""
    guides: Guides | None
    """Of a place in the bay; with them it takes only cargo that has trunnions."""

    def lacks(self, probe: Pose | None, trunnions: Array) -> str:
        """What a cargo with this probe and these trunnions lacks to be held here; empty: nothing."""
        if self.kind == "port":
            return "" if probe else "probe"
        return "trunnions" if self.guides and not len(trunnions) else ""

    def seated(self, probe: Pose | None) -> Pose:
        """Pose of a cargo's own frame, in the seat's frame, when it is seated here, by its probe where it is a port."""
        if self.kind == "retention" or probe is None:
            return self.pose
        rotation = self.pose.rotation @ probe.rotation.T
        return Pose(self.pose.position - rotation @ probe.position, rotation)


class Start(msgspec.Struct, frozen=True, eq=False):
    """Where a cargo is at the start."""

    seat: str
    """Name of the seat that holds it; empty: it is free."""
    pose: Pose
    """In the scene at the start, also of a seated one."""
    velocity: Array
    """(3,) of its centre, in the scene, against the orbiter [m/s]."""
    rates: Array
    """(3,) about its own axes [rad/s]."""


class LimitCycle(msgspec.Struct, frozen=True, eq=False):
    """How a free cargo's attitude control wanders about its attitude."""

    deadband: Array
    """(3,) to either side, about its own axes [rad]."""
    rate: Array
    """(3,) how fast each angle changes; its sign is the way it sets out [rad/s]."""
    start: Array
    """(3,) each angle at time 0, within its deadband [rad]."""


class Cargo(msgspec.Struct, frozen=True, eq=False):
    """Something that the arm can hold. Its own frame is at its body's centre: x along it, to aft in the bay, z up."""

    name: str
    """Also of its frame."""
    title: str
    mass: float
    """[kg]"""
    shapes: tuple[Shape, ...]
    """What it looks like."""
    solids: tuple[Solid, ...]
    """In its own frame; parts are called after the cargo and what they are: ``payload``, ``payload probe``."""
    probe: Pose | None
    """Centre of the probe's forward face; its axes are the cargo's."""
    receptacle: Array | None
    """(8, 3) the bar [m], numbered as the report's RECPT in axes x aft, y port, z down: c on top, b and e its sides."""
    grapple: Pose | None
    """The end effector's own axes E, about the tip, at a perfect grasp of the fixture."""
    trunnions: Array
    """(n, 3) the points that the bay's latches hold, port and starboard of each pair, then the keel's [m]."""
    trunnion_names: tuple[str, ...]
    """``forward port``, ``forward starboard`` … ``keel``; of more than two pairs ``2 port``."""
    start: Start
    limit_cycle: LimitCycle | None


class BarAcquisition(msgspec.Struct, frozen=True):
    """When the concept's hand has acquired a bar; the report's names in brackets."""

    prong_spacing: float
    """From the palm's centre line to the prong's inner face, at most which the prong is closed (PRGSPC) [m]."""
    window: float
    """Of the palm's height over the bar's top (TOPB) [m]."""
    front: float
    """How far inward of the bar's forward end the palm's centre has to be (FRONT) [m]."""
    rear: float
    """The same of the aft end (REAR) [m]."""
    fingers_within: float
    """Distance of palm and bar beyond which the fingers are not tested [m]."""


class SnareCapture(msgspec.Struct, frozen=True):
    """When the Shuttle's end effector can capture a fixture, and how long it takes."""

    radial: float
    """From the end effector's axis [m]."""
    nearest: float
    """Along the axis, outwards, from where the fixture stands when it is rigid [m]."""
    farthest: float
    """The same [m]."""
    pitch: float
    """About axis 2 of E, to either side [rad]."""
    yaw: float
    """About axis 3 [rad]."""
    roll: float
    """About axis 1 [rad]."""
    ring: float
    """To close or open the snares [s]."""
    carriage: float
    """To retract or extend [s]."""
    tension: float
    """To rigidize or derigidize [s]."""


Relation = Literal["acquisition", "docking", "guides", "capture"]
"""By which conditions two parts may touch: those of the bar, the port, the V-guides or the grapple fixture."""


class Essential(msgspec.Struct, frozen=True):
    """Two parts that the task brings into contact, where and how deep they may touch."""

    parts: tuple[str, str]
    """One is a cargo's, the other the arm's or a body's."""
    relation: Relation
    """Outside of it the contact is detrimental."""
    depth: float
    """How deep the two may be in each other, and how far past the relation's planes [m]."""


class Bay(msgspec.Struct, frozen=True):
    """The inside of the cargo bay, in the frame ``orbiter``; a cargo that is all above it has been extracted."""

    low: Vec3
    """[m]"""
    high: Vec3
    """[m]"""


class Translation(msgspec.Struct, frozen=True):
    """How the orbiter moves against what does not move with it."""

    speed: float
    """[m/s]"""
    reached_in: float
    """[s]"""


class Worksite(msgspec.Struct, frozen=True, eq=False):
    """A place of work. The first body's own frame is the scene frame."""

    name: str
    title: str
    bodies: tuple[Body, ...]
    cameras: tuple[Camera, ...]
    text: str
    """The file, as it was read."""
    dimensions: dict[str, str | float]
    """Its dimensions as derived, for which a scenario may give other values."""
    origin: Vec3
    """Structural Xo, Yo, Zo of the scene's origin [m]."""
    solids: tuple[Solid, ...]
    """Of the bodies, in the frames ``orbiter`` and ``space``."""
    seats: tuple[Seat, ...]
    cargoes: tuple[Cargo, ...]
    """On offer: a scenario names those that are there."""
    essential: tuple[Essential, ...]
    """Pairs of parts that the task brings into contact; some parts are the arm's."""
    acquisition: BarAcquisition | SnareCapture | None
    bay: Bay | None
    translation: Translation | None
