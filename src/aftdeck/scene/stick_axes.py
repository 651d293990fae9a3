"""Axes along which the hand controllers act, and directions of the cameras' pictures."""

from __future__ import annotations

import math

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.cameras import setting, view
from aftdeck.frames import SCENE_FROM_PANEL_AXES, rotation_of, rotation_x
from aftdeck.matrices import product
from aftdeck.scenario.all_cameras import cameras_of
from aftdeck.scenario.model import Scenario
from aftdeck.scene.bodies import bodies_of
from aftdeck.scene.everything import ScenePoses
from aftdeck.simulation.frame import Frame
from aftdeck.steering.mode import MODES


class StickAxes:
    """Axes along which the sticks of a scenario act."""

    def __init__(self, scenario: Scenario) -> None:
        self._mount = scenario.arm.model.mount.rotation
        hand = np.eye(3) if scenario.strict else rotation_x(scenario.arm.model.end_effector_roll)
        self._hand: Array = hand

    def in_panel(self, frame: Frame) -> Array:
        """Return the axes (3, 3), in columns, in panel components: the THC's X, Y, Z."""
        along = MODES[frame.mode].axes
        if along == "end effector axes":
            return np.asarray(self._mount @ np.array(frame.orientation) @ self._hand)
        if along == "payload axes" and frame.payload is not None:
            return np.asarray(self._mount @ np.array(frame.payload[1]))
        return np.eye(3)


class PictureTurns:
    """Angles between the directions of the sticks and those of the cameras' pictures."""

    def __init__(self, scenario: Scenario) -> None:
        self._axes, self._poses = StickAxes(scenario), ScenePoses(scenario)
        self._cameras = {camera.name: camera for camera in cameras_of(scenario)}
        self._driven = [camera.name for camera in self._cameras.values() if camera.drive is not None]
        self._bodies = [body.name for body in bodies_of(scenario)]

    def angles(self, frame: Frame, names: tuple[str, ...]) -> list[float]:
        """Return the angle of each named camera's picture [rad].

        Cameras that do not exist, and views for engineers, which the page moves freely, are left out.

        The angle is zero if a push of the THC forward moves into the picture, to starboard to the right, and down
        downwards. It is the angle of the rotation from the picture's directions to those of the sticks.
        """
        sticks = product(SCENE_FROM_PANEL_AXES, self._axes.in_panel(frame))
        poses = np.array(self._poses.at(frame)).reshape(-1, 7)
        found = []
        for name in names:
            if (camera := self._cameras.get(name)) is None or camera.kind == "engineering":
                continue
            at = frame.views[self._driven.index(name)] if name in self._driven else setting(camera)
            seen = view(camera, at)
            w, x, y, z = poses[self._bodies.index(camera.body)][3:].tolist()
            body = np.array(rotation_of((w, x, y, z)))
            ahead, up = product(body, np.array(seen.boresight)), product(body, np.array(seen.up))
            right = np.cross(ahead, up)
            trace = float(ahead @ sticks[:, 0] + right @ sticks[:, 1] - up @ sticks[:, 2])
            found.append(math.acos(max(-1.0, min(1.0, (trace - 1.0) / 2.0))))
        return found
