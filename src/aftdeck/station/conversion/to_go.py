"""Conversion of the motion that is left to the axes of the sticks, and to the scene."""

from __future__ import annotations

from typing import cast

import numpy as np

from aftdeck.arrays import Array
from aftdeck.scene.everything import ScenePoses
from aftdeck.simulation.frame import Frame
from aftdeck.station.messages.frame import ToGo
from aftdeck.steering.mode import MODES
from aftdeck.task.remaining import Remaining, along_axes
from aftdeck.tuples import Vec3


def to_go(remaining: Remaining, frame: Frame, scene: ScenePoses, axes: Array, closing: float | None = None) -> ToGo:
    """Return the message about the motion that is left in a frame.

    Args:
        remaining: the motion that is left.
        frame: the frame.
        scene: poses in the scene.
        axes: (3, 3) axes of the sticks in L, in columns.
        closing: speed at which the distance becomes smaller [m/s]; None if it is not known.
    """
    translation = rotation = None
    shift: tuple[float, ...] = ()
    if (motion := remaining.motion) is not None:
        shift = scene.motion(motion)
        if MODES[frame.mode].kind == "manual":
            along = along_axes(motion, np.array(frame.resolution), axes)
            translation, rotation = _vec3(along[0]), _vec3(along[1])
    return ToGo(
        remaining.to, translation, rotation, remaining.distance, remaining.angle, remaining.near, closing, shift
    )


def _vec3(values: Array) -> Vec3:
    return cast("Vec3", tuple(values.tolist()))
