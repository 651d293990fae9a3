"""Data model of a payload of a worksite: its body, its fittings, its mass and its start."""

from __future__ import annotations

import msgspec

from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import MassProperties
from aftdeck.bodies.solid import Solid
from aftdeck.frames import Pose
from aftdeck.shapes import Shape

FITTINGS = ("probe", "receptacle", "grapple fixture", "trunnions")
"""Fittings that a payload may have besides its body. Each fitting is a part. The part's name consists of the payload's
name and the fitting's name."""


class Start(msgspec.Struct, frozen=True, eq=False):
    """Position and motion of a payload at the start."""

    berth: str
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


class Payload(msgspec.Struct, frozen=True, eq=False):
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


def part_of(payload: str, fitting: str) -> str:
    """Return the name of a part of a payload; the body has the name of the payload."""
    return f"{payload} {fitting}" if fitting else payload
