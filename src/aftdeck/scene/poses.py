"""Where every drawn body is: an arm's moving frames, in scene coordinates, from its joint angles."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from aftdeck.arms.geometry import Axes
from aftdeck.arms.load import ArmModel
from aftdeck.frames import SCENE_FROM_PANEL_AXES, SCENE_ORIGIN, quaternion
from aftdeck.law import law, sincos

Array = NDArray[np.float64]
Seven = tuple[float, float, float, float, float, float, float]
"""A pose: x, y, z [m], then the quaternion w, x, y, z."""


class ArmPoses:
    """Poses of an arm's base and of its six moving frames, in the scene.

    At zero angles every frame is parallel to L. Each stands at its own joint's centre, the wrist roll's at that of
    the joint before it.
    """

    def __init__(self, model: ArmModel) -> None:
        self._steps, self._axes = model.linkage.steps, model.linkage.axes
        self._base = np.empty(7)
        self._base[:3] = point_in_scene(model.mount.origin)
        self._base[3:] = quaternion(SCENE_FROM_PANEL_AXES @ model.mount.rotation)
        self._poses = np.empty((7, 7))

    def at(self, angles: Array) -> list[float]:
        """Seven numbers a frame (x, y, z [m], w, x, y, z), base first, at joint angles (6,) [rad]."""
        chain(self._base, self._steps, self._axes, angles, self._poses)
        flat: list[float] = self._poses.ravel().tolist()
        return flat

    def links(self, angles: Sequence[float]) -> list[Seven]:
        """Each moving frame in the one before it, at joint angles [rad]: what `at` adds up."""
        links = []
        for (x, y, z), axis, angle in zip(self._steps.tolist(), self._axes, angles, strict=True):
            turn = [math.cos(0.5 * angle), 0.0, 0.0, 0.0]
            turn[axis] = math.sin(0.5 * angle)
            links.append((x, y, z, turn[0], turn[1], turn[2], turn[3]))
        return links


def point_in_scene(panel: Array) -> Array:
    """A point (3,) given in panel coordinates [m], in the scene."""
    return np.asarray(SCENE_FROM_PANEL_AXES @ panel - SCENE_ORIGIN)


@law
def chain(base: Array, steps: Array, axes: Axes, angles: Array, poses: Array) -> None:
    """Carry a base pose (7,) along six joints: steps (6, 3) [m], axes and angles (6,) [rad] -> poses (7, 7)."""
    x, y, z = base[0], base[1], base[2]
    a, b, c, d = base[3], base[4], base[5], base[6]
    for i in range(7):
        poses[i, 0], poses[i, 1], poses[i, 2] = x, y, z
        poses[i, 3], poses[i, 4], poses[i, 5], poses[i, 6] = a, b, c, d
        if i == 6:
            return
        u, v, w = steps[i, 0], steps[i, 1], steps[i, 2]
        tx, ty, tz = 2.0 * (c * w - d * v), 2.0 * (d * u - b * w), 2.0 * (b * v - c * u)
        x += u + a * tx + c * tz - d * ty
        y += v + a * ty + d * tx - b * tz
        z += w + a * tz + b * ty - c * tx
        s, k = sincos(0.5 * angles[i])
        axis = axes[i]
        if axis == 1:
            a, b, c, d = a * k - b * s, b * k + a * s, c * k + d * s, d * k - c * s
        elif axis == 2:
            a, b, c, d = a * k - c * s, b * k - d * s, c * k + a * s, d * k + b * s
        else:
            a, b, c, d = a * k - d * s, b * k + c * s, c * k - b * s, d * k + a * s
