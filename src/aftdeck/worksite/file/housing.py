"""Housings of cameras: their shapes and solids, placed at the position of each camera."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.cameras import Camera
from aftdeck.elementary import asin, atan2
from aftdeck.matrices import length
from aftdeck.shapes import Group, Shape
from aftdeck.worksite.file.schema import HousingFile, WorksiteFile
from aftdeck.worksite.file.solids import CORNERS


class Housed(NamedTuple):
    """The housings on a body, in the body's axes.

    Attributes:
        shapes: shapes that draw the housings.
        solids: vertices (1, 8, 3) of each housing [m], by the name of its part (``camera A``).
    """

    shapes: list[Shape]
    solids: dict[str, Array]


def housed(cameras: Sequence[Camera], file: WorksiteFile, body: str) -> Housed:
    """Return the housings of the cameras on a body. A camera has a housing if the file gives one for its drive."""
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
    ahead = np.array(camera.boresight) / length(camera.boresight)
    x, y, z = (np.array(camera.position) - lens * ahead).tolist()
    turn = (0.0, -asin(float(ahead[2])), atan2(float(ahead[1]), float(ahead[0])))
    found.shapes.append(Group(position=(x, y, z), rotation=turn, shapes=housing.turned))
    found.shapes.append(Group(position=(x, y, z), shapes=housing.upright))
    low, high = (np.array([span[k] for span in (housing.x, housing.y, housing.z)], dtype=np.float64) for k in (0, 1))
    found.solids[f"camera {camera.name}"] = (low + CORNERS * (high - low) + [x, y, z])[None]
