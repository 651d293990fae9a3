"""Housings of cameras: their shapes and solids, placed at the position of each camera."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from aftdeck.arms.geometry import frozen
from aftdeck.arrays import Array
from aftdeck.bodies.cameras import Camera, mount
from aftdeck.bodies.solid import Solid
from aftdeck.frames import IDENTITY, Pose, oriend
from aftdeck.matrices import length, product
from aftdeck.shapes import Group, Shape
from aftdeck.tuples import Vec3, plain_vector
from aftdeck.worksite.file.schema import HousingFile, WorksiteFile
from aftdeck.worksite.file.solids import CORNERS, as_solids, moved


class Housed(NamedTuple):
    """The housings on a body, in the body's axes.

    Attributes:
        shapes: shapes that draw the housings.
        solids: vertices (1, 8, 3) of each housing [m], by the name of its part (``camera A``).
    """

    shapes: list[Shape]
    solids: dict[str, Array]

    def as_solids(self, frame: str, pose: Pose = IDENTITY) -> tuple[Solid, ...]:
        """Return the solids in a frame; `pose` is the pose of the body in it."""
        return tuple(
            solid for part, own in self.solids.items() for solid in as_solids(part, frame, frozen(moved(own, pose)))
        )


def housed(cameras: Sequence[Camera], file: WorksiteFile, body: str) -> Housed:
    """Return the housings of the cameras on a body, on a payload or on a frame of an arm.

    A camera has a housing if the file gives one for its drive.
    """
    housings = {housing.drive: housing for housing in file.housing}
    drives = {camera.name: camera.drive for camera in file.camera}
    found = Housed([], {})
    for camera in cameras:
        housing = housings.get(drives[camera.name] or "")
        if housing is not None and camera.body == body:
            _add(found, camera, housing)
    return found


def _add(found: Housed, camera: Camera, housing: HousingFile) -> None:
    """Add a camera's housing at the point where the pan and tilt axes meet.

    This point is `drive.lens` [m] behind the lens.
    """
    lens = camera.drive.lens if camera.drive is not None else 0.0
    level, left, up = (np.array(axis) for axis in mount(camera))
    ahead = np.array(camera.boresight) / length(camera.boresight)
    at = np.array(camera.position) - lens * ahead
    side = np.cross(up, ahead)
    side /= length(side.tolist())
    for x, y, shapes in ((ahead, side, housing.turned), (level, left, housing.upright)):
        if shapes:
            found.shapes.append(Group(position=plain_vector(at), rotation=_turn(x, y), shapes=shapes))
    low, high = (np.array([span[k] for span in (housing.x, housing.y, housing.z)], dtype=np.float64) for k in (0, 1))
    corners = product(low + CORNERS * (high - low), np.array([level, left, up]))
    low, high = corners.min(axis=0), corners.max(axis=0)
    found.solids[camera.housing] = (low + CORNERS * (high - low) + at)[None]


def _turn(x: Array, y: Array) -> Vec3:
    """Return the rotation of a group whose x and y axes have these directions: roll, pitch, yaw [rad]."""
    return oriend(np.column_stack([x, y, np.cross(x, y)]))
