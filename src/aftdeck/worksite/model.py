"""Data model of the worksite: the bodies around the arm, their solids, the berths of payloads, and the cameras.

Solids and berths are given in one of these coordinate frames: ``orbiter``, ``space``, or a payload's own frame. A
payload's own frame has the payload's name. ``orbiter`` is the scene's frame and is fixed to the orbiter. ``space``
coincides with ``orbiter`` at the start, but does not move with the orbiter.
"""

from __future__ import annotations

from typing import Literal

import msgspec
import numpy as np

from aftdeck.bodies.cameras import Camera
from aftdeck.bodies.mass_properties import MassProperties
from aftdeck.bodies.solid import Solid
from aftdeck.frames import Mount
from aftdeck.matrices import product
from aftdeck.shapes import Shape
from aftdeck.tuples import Vec3
from aftdeck.worksite.berths.berth import Berth
from aftdeck.worksite.body import Body
from aftdeck.worksite.capture.effector import CaptureTable
from aftdeck.worksite.payload import Payload
from aftdeck.worksite.relation import Essential

OrbiterMotion = Literal["free", "held", "fixed"]
"""Motion of the orbiter on a plant with masses: it drifts, jets hold its attitude besides, or it does not move."""


class Mounted(msgspec.Struct, frozen=True, eq=False):
    """Housings of the worksite's cameras on one frame of an arm, in that frame's axes."""

    shapes: tuple[Shape, ...]
    solids: tuple[Solid, ...]


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
    berths: tuple[Berth, ...]
    payloads: tuple[Payload, ...]
    """Available payloads; a scenario names the payloads that are present."""
    essential: tuple[Essential, ...]
    """Pairs of parts that the task brings into contact. In some pairs, one part belongs to the arm."""
    acquisition: CaptureTable | None
    """Rules of capture by one kind of end effector; None if nothing can be captured."""
    bay: Bay | None
    translation: Translation | None
    orbiter: OrbiterMass | None
    """Mass of the orbiter; None if the worksite has no orbiter that moves."""
