"""What cameras are made of: drawn and solid where the camera stands, which its own table alone says."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.cameras import Camera
from aftdeck.shapes import Group, Shape
from aftdeck.worksite.schema import HousingFile, WorksiteFile
from aftdeck.worksite.solids import CORNERS


class Housed(NamedTuple):
    """The housings on a body, in its axes.

    Attributes:
        shapes: how they look.
        solids: by part (``camera A``), (1, 8, 3) vertices [m].
    """

    shapes: list[Shape]
    solids: dict[str, Array]


def housed(cameras: Sequence[Camera], file: WorksiteFile, body: str) -> Housed:
    """The housings of the cameras that stand on a body and whose drive has one."""
    housings = {housing.drive: housing for housing in file.housing}
    drives = {camera.name: camera.drive for camera in file.camera}
    found = Housed([], {})
    for camera in cameras:
        housing = housings.get(drives[camera.name] or "")
        if housing is not None and camera.body == body:
            _add(found, camera, housing)
    return found


def _add(found: Housed, camera: Camera, housing: HousingFile) -> None:
    """A camera's housing about the point where the axes of its pan and tilt meet, the lens' way behind the lens."""
    lens = camera.drive.lens if camera.drive is not None else 0.0
    ahead = np.array(camera.boresight) / math.hypot(*camera.boresight)
    x, y, z = (np.array(camera.position) - lens * ahead).tolist()
    turn = (0.0, -math.asin(float(ahead[2])), math.atan2(float(ahead[1]), float(ahead[0])))
    found.shapes.append(Group(position=(x, y, z), rotation=turn, shapes=housing.turned))
    found.shapes.append(Group(position=(x, y, z), shapes=housing.upright))
    low, high = (np.array([span[k] for span in (housing.x, housing.y, housing.z)], dtype=np.float64) for k in (0, 1))
    found.solids[f"camera {camera.name}"] = (low + CORNERS * (high - low) + [x, y, z])[None]
