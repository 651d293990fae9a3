"""Motion that is left, along and about the axes in which the hand controllers act."""

from __future__ import annotations

import math
from typing import NamedTuple, cast

import numpy as np

from aftdeck.arrays import Array
from aftdeck.frames import quaternion
from aftdeck.matrices import product
from aftdeck.simulation.frame import Frame
from aftdeck.steering.mode import MODES
from aftdeck.task.remaining import Remaining
from aftdeck.tuples import Vec3


class AlongSticks(NamedTuple):
    """Motion that is left.

    Attributes:
        translation: displacement of the point of resolution along the THC's axes [m].
        rotation: rotation vector about the RHC's axes [rad].
    """

    translation: Vec3
    rotation: Vec3


def along_sticks(remaining: Remaining, frame: Frame, axes: Array) -> AlongSticks | None:
    """Return the motion that is left along the sticks; None if a joint has to move, or the mode has no sticks.

    Args:
        remaining: the motion that is left.
        frame: the frame.
        axes: (3, 3) axes of the sticks in L, in columns.
    """
    motion = remaining.motion
    if motion is None or MODES[frame.mode].kind != "manual":
        return None
    point = np.array(frame.resolution)
    moved = product(motion.rotation, point) + motion.position - point
    return AlongSticks(_vec3(product(moved, axes)), _vec3(product(_vector(motion.rotation), axes)))


def _vector(rotation: Array) -> Array:
    """Return the rotation vector (3,) of a rotation matrix: its axis times its angle [rad], at most pi."""
    w, *vector = quaternion(rotation)
    sine = math.hypot(*vector)
    return np.array(vector) * (2.0 * math.atan2(sine, w) / sine if sine > 0.0 else 2.0)


def _vec3(values: Array) -> Vec3:
    return cast("Vec3", tuple(values.tolist()))
