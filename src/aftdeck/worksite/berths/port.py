"""Docking port: it fixes a payload by its probe, without a command, as soon as the conditions of docking hold."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, Literal

import numpy as np

from aftdeck.arms.geometry import frozen
from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import NX, D, pack
from aftdeck.bodies.pose import POSE, compose, row_of
from aftdeck.bodies.solid import Solid
from aftdeck.frames import Pose
from aftdeck.matrices import product
from aftdeck.shapes import Cylinder, Material, Shape
from aftdeck.units import Length
from aftdeck.worksite.berths.berth import Berth, BerthTable, Closes, Fit, Verb, place_of
from aftdeck.worksite.berths.docking import DISTANCE, FOUND, DockingTolerances, approach, docking
from aftdeck.worksite.body import Body
from aftdeck.worksite.conditions import Condition
from aftdeck.worksite.payload import Payload, part_of
from aftdeck.worksite.tables import positive

DISC = 0.02
"""Thickness of the disc that marks a port [m]; half of it protrudes, and nothing collides with it."""
ON_FACE = 1e-6
"""Greatest distance of a port's centre from its face [m]."""


class PortFile(BerthTable, frozen=True, kw_only=True, tag="port"):
    """A docking port.

    Its centre is on a face of a solid. Its axes equal the axes of a docked payload; x points outwards.
    """

    latch: Literal["auto", "command"]
    """Without effect: a port always fixes a payload as soon as the conditions hold."""
    radius: Length
    """Radius of the disc that marks the port."""
    material: Material

    def __post_init__(self) -> None:
        """Reject tolerances and a radius that are not above zero, and a negative time (ValueError)."""
        super().__post_init__()
        positive(radius=self.radius)

    def berth(self, body: Body, solids: Sequence[Solid]) -> Port:
        """Return the port; arguments and errors as for `BerthTable.berth`."""
        common = self.common(body)
        return Port(**common, envelope=_envelope(common["pose"], solids))

    def marks(self) -> tuple[Shape, ...]:
        """Return the disc that marks the port, in its body's axes."""
        (x, y, z), (roll, pitch, yaw) = (map(float, values) for values in (self.position, self.rotation))
        at, turn = (x, y, z), (roll, pitch, yaw)
        return (Cylinder(material=self.material, position=at, rotation=turn, length=DISC, radius=float(self.radius)),)


class Port(Berth, frozen=True, eq=False, kw_only=True):
    """A docking port. In its frame, the centre of a docked payload's probe is at the port's centre."""

    out: ClassVar[int] = 0
    away: ClassVar[str] = "before"
    gives: ClassVar[float] = 0.2
    """With this time constant, a payload that arrives at 0.2 m/s moves 15 mm past its place."""
    docks: ClassVar[bool] = True

    closes: Closes = "by itself"
    instant: bool = True
    verb: Verb = "dock"
    needs: Literal["", "probe", "trunnions"] = "probe"
    envelope: Array
    """Docking envelope: (5, 4) planes in the port's axes, with its centre as origin.

    Each plane has a unit normal n [1] and a distance d [m]. The planes are those of the port's face and of the four
    adjacent faces, extended. A point p is in the envelope if n.p <= d for all planes.
    """

    def seated(self, probe: Pose | None) -> Pose:
        """Return the pose of a docked payload's own frame in the port's frame; `probe`: `Payload.probe`."""
        if probe is None:
            return self.pose
        rotation = product(self.pose.rotation, probe.rotation.T)
        return Pose(self.pose.position - product(rotation, probe.position), rotation)

    def fit(self, payload: Payload, row: int, axes: str) -> Fit:
        """Return the constants of a payload at this port; arguments as for `Berth.fit`."""
        probe = [solid.vertices for solid in payload.solids if solid.part == part_of(payload.name, "probe")]
        return PortFit(
            self,
            row,
            place_of(self, payload),
            row_of(self.pose),
            np.unique(np.concatenate(probe), axis=0) if probe else np.empty((0, 3)),
            np.zeros(3) if payload.probe is None else payload.probe.position,
            DockingTolerances(self.distance, self.angle, "y" if axes == "y" else "all"),
        )


@dataclass(frozen=True, eq=False)
class PortFit(Fit):
    """Constants of one payload at one port.

    Attributes:
        pose: (12,) pose of the port in its frame.
        probe: (n, 3) vertices of the payload's probe, in the payload's axes [m].
        tip: (3,) centre of the probe's forward face, in the payload's axes [m].
        tolerances: greatest distance and angle at which the port docks the payload.
    """

    berth: Port
    pose: Array
    probe: Array
    tip: Array
    tolerances: DockingTolerances

    relation: ClassVar[Literal["docking"]] = "docking"

    def conditions(self, frames: Array, payload: int) -> tuple[Condition, ...]:
        """Return the conditions of docking."""
        return docking(self._approach(frames, payload), self.tolerances)

    def has_left(self, frames: Array, payload: int) -> bool:
        """Return whether the probe is farther from the port than the docking distance."""
        return bool(self._approach(frames, payload)[DISTANCE] > self.tolerances.distance)

    @property
    def _outwards(self) -> Array:
        return -product(self.pose[3:].reshape(3, 3), self.berth.envelope[0, :3])

    def _approach(self, frames: Array, payload: int) -> Array:
        """Return the results (6,) of `docking.approach` for the payload's probe."""
        found, port = np.empty(FOUND), np.empty(POSE)
        compose(frames[self.row], self.pose, port)
        approach(self.probe, self.tip, frames[payload], port, self.berth.envelope, found)
        return found


def _envelope(port: Pose, solids: Sequence[Solid]) -> Array:
    """Return planes (5, 4) in the port's axes: the port's face with its normal reversed, then the four adjacent faces.

    Raises:
        ValueError: the port's centre is not on a face of the solids.
    """
    for solid in solids:
        body = pack(solid.vertices)
        normals, distances = body[NX:D].reshape(3, 6).T, body[D:]
        heights = product(normals, port.position) - distances
        face = int(heights.argmax())
        if abs(heights[face]) <= ON_FACE:
            order = [face, *(f for f in range(6) if f not in (face, 5 - face))]
            planes = np.column_stack([product(normals, port.rotation), -heights])[order]
            planes[0] *= -1.0
            return frozen(planes)
    raise ValueError("a port's centre has to be on a face of a solid of its body; this one is not")
