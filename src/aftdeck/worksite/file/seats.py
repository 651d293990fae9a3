"""Construction of a berth from its file. A docking port's envelope is computed from the face on which the port is."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from aftdeck.arms.geometry import frozen
from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import NX, D, pack
from aftdeck.bodies.solid import Solid
from aftdeck.frames import Pose, endori
from aftdeck.matrices import product
from aftdeck.shapes import Cylinder, Shape
from aftdeck.worksite.file.schema import PortFile, SeatFile
from aftdeck.worksite.model import Body, Guides, Seat

DISC = 0.02
"""Thickness of the disc that marks a port [m]; half of it protrudes, and nothing collides with it."""
ON_FACE = 1e-6
"""Greatest distance of a port's centre from its face [m]."""


def seat_of(file: SeatFile, body: Body, solids: Sequence[Solid]) -> Seat:
    """Return the berth that a table of the file describes.

    Args:
        file: the berth's table.
        body: the body that carries the berth.
        solids: the body's solids, in the coordinate frame to which the body is fixed.

    Raises:
        ValueError: a port is not on a face of its body's solids.
    """
    fixed, own = body.pose, endori(*file.rotation)
    position = product(fixed.rotation, np.array(file.position, dtype=np.float64)) + fixed.position
    pose = Pose(frozen(position), frozen(product(fixed.rotation, own)))
    guides = None if isinstance(file, PortFile) else file.guides
    return Seat(
        name=file.name,
        title=file.title,
        kind="port" if isinstance(file, PortFile) else "retention",
        body=file.body,
        frame=body.fixed_to,
        pose=pose,
        latch=file.latch,
        time=float(file.time),
        distance=float(file.distance),
        angle=float(file.angle),
        envelope=_envelope(pose, solids) if isinstance(file, PortFile) else frozen(np.empty((0, 4))),
        guides=None
        if guides is None
        else Guides(*map(float, (guides.height, guides.half_angle, guides.throat, guides.play))),
    )


def disc(file: PortFile) -> Shape:
    """Return the disc that marks a port, in its body's axes."""
    (x, y, z), (roll, pitch, yaw) = (map(float, values) for values in (file.position, file.rotation))
    return Cylinder(
        material=file.material, position=(x, y, z), rotation=(roll, pitch, yaw), length=DISC, radius=float(file.radius)
    )


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
