"""Remaining motion, along and about the axes in which the hand controllers act."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import vec3
from aftdeck.frames import Pose, quaternion
from aftdeck.matrices import product
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.readings.reading import Along
from aftdeck.steering.mode import MODES
from aftdeck.task.remaining import Remaining
from aftdeck.tuples import Vec3


class AlongSticks(NamedTuple):
    """Remaining motion.

    Attributes:
        translation: displacement of the point of resolution along the THC's axes [m].
        rotation: rotation vector about the RHC's axes [rad].
    """

    translation: Vec3
    rotation: Vec3


def along_sticks(remaining: Remaining, frame: Frame, axes: tuple[Array, Array]) -> AlongSticks | None:
    """Return the remaining motion along the sticks; None if a joint has to move, or the mode has no sticks.

    Args:
        remaining: the remaining motion.
        frame: the frame.
        axes: axes of the THC and of the RHC, each (3, 3) in L, in columns.
    """
    if remaining.motion is None or MODES[frame.mode].kind != "manual":
        return None
    moved, turned = along_axes(remaining.motion, np.array(frame.resolution), axes)
    return AlongSticks(vec3(moved, 0), vec3(turned, 0))


def seen_along(frame: Frame, remaining: Remaining | None, axes: tuple[Array, Array]) -> Along:
    """Return what a policy sees of the motion, whatever the mode; arguments as for `along_sticks`."""
    moving, turning = axes
    to_go, rotation_to_go = np.zeros(3), np.zeros(3)
    if remaining is not None and remaining.motion is not None:
        to_go, rotation_to_go = along_axes(remaining.motion, np.array(frame.resolution), axes)
    twist = np.array(frame.twist)
    return Along(to_go, rotation_to_go, product(twist[3:], moving), product(twist[:3], turning))


def along_axes(motion: Pose, point: Array, axes: tuple[Array, Array]) -> tuple[Array, Array]:
    """Return a motion's components along the axes of the sticks: displacement of a point [m], rotation vector [rad].

    Args:
        motion: the motion, x to R x + p in L.
        point: (3,) point that the sticks move, in L [m].
        axes: axes of the THC and of the RHC, each (3, 3) in L, in columns.
    """
    moving, turning = axes
    moved = product(motion.rotation, point) + motion.position - point
    return product(moved, moving), product(_vector(motion.rotation), turning)


def _vector(rotation: Array) -> Array:
    """Return the rotation vector (3,) of a rotation matrix: its axis times its angle [rad], at most pi."""
    w, *vector = quaternion(rotation)
    sine = math.hypot(*vector)
    return np.array(vector) * (2.0 * math.atan2(sine, w) / sine if sine > 0.0 else 2.0)
