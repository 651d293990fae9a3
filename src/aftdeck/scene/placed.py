"""Expansion of groups into single shapes; each drawn copy of a shape has its own pose."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from aftdeck.frames import IDENTITY, Pose, endori
from aftdeck.matrices import product
from aftdeck.shapes import Box, Cylinder, Group, Hexahedron, Light, Loft, Plate, Ring, Shape, Shell, Sphere
from aftdeck.tuples import Vec3

Leaf = Box | Cylinder | Shell | Ring | Sphere | Plate | Loft | Hexahedron | Light
"""A shape that is not a group."""

_MIRROR = Pose(np.zeros(3), np.diag([1.0, -1.0, 1.0]))


def placed(shapes: Iterable[Shape], frame: Pose = IDENTITY) -> Iterator[tuple[Leaf, Pose]]:
    """Yield all single shapes, including those in groups, each with its pose.

    The shapes are given in a frame that has the pose `frame`. If a shape is a mirrored copy, the matrix of its pose
    includes a reflection.
    """
    for shape in shapes:
        own = _pose(shape.position, shape.rotation)
        if not isinstance(shape, Group):
            yield shape, carried(frame, own)
            continue
        for side in (frame, carried(frame, _MIRROR)) if shape.mirror else (frame,):
            for i in range(shape.count):
                yield from placed(shape.shapes, carried(carried(side, own), _step(shape, i)))


def carried(outer: Pose, inner: Pose) -> Pose:
    """Return the composed pose: `inner` is relative to a frame, and `outer` is the pose of this frame."""
    position = product(outer.rotation, inner.position) + outer.position
    return Pose(position, product(outer.rotation, inner.rotation))


def _step(group: Group, i: int) -> Pose:
    (x, y, z), (roll, pitch, yaw) = group.step, group.turn
    return _pose((x * i, y * i, z * i), (roll * i, pitch * i, yaw * i))


def _pose(position: Vec3, rotation: Vec3) -> Pose:
    roll, pitch, yaw = rotation
    return Pose(np.array(position), endori(roll, pitch, yaw))
