"""Cameras of a scenario in the scene: position and directions of their pictures, computed from a `Frame`."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.cameras import Camera, View, setting, view
from aftdeck.errors import InputError
from aftdeck.frames import rotation_of
from aftdeck.matrices import product
from aftdeck.scenario.all_cameras import cameras_of
from aftdeck.scenario.load import in_force
from aftdeck.scenario.model import Scenario
from aftdeck.scene.bodies import bodies_of
from aftdeck.scene.everything import ScenePoses
from aftdeck.simulation.frame import Frame
from aftdeck.tuples import Rows


class Seen(NamedTuple):
    """A camera at one moment.

    Attributes:
        position: (3,) position of the lens, in the scene [m].
        axes: (3, 3) rows are the directions right, down and ahead of the picture, in the scene.
        view: the view in the frame of the camera's body.
    """

    position: Array
    axes: Array
    view: View


class SceneCameras:
    """Cameras of a scenario in the scene.

    Attributes:
        cameras: the scenario's cameras, by name.
        poses: converter of a frame to the poses of all drawn bodies.
    """

    def __init__(self, scenario: Scenario) -> None:
        self._scenario = scenario
        self.cameras = {camera.name: camera for camera in cameras_of(scenario)}
        self.poses = ScenePoses(scenario)
        self._bodies = [body.name for body in bodies_of(scenario)]
        self._driven = [camera.name for camera in self.cameras.values() if camera.drive is not None]

    def bodies_at(self, frame: Frame) -> dict[str, Array]:
        """Return the pose (7,) of each drawn body in the scene."""
        poses = np.array(self.poses.at(frame)).reshape(-1, 7)
        return dict(zip(self._bodies, poses, strict=False))

    def camera(self, name: str) -> Camera:
        """Return a camera.

        Raises:
            InputError: there is no such camera.
        """
        if name not in self.cameras:
            raise InputError(f"no camera is called {name!r}; cameras are {', '.join(self.cameras)}")
        return self.cameras[name]

    def seen(self, frame: Frame, bodies: dict[str, Array], name: str) -> Seen:
        """Return the position and the directions of a camera.

        Args:
            frame: the frame.
            bodies: result of `bodies_at` for this frame.
            name: name of the camera.

        Raises:
            InputError: there is no such camera.
        """
        camera = self.camera(name)
        if frame.changes:
            camera = _cameras_in_force(self._scenario, frame.changes)[name]
        at = view(camera, frame.views[self._driven.index(name)] if name in self._driven else setting(camera))
        body = bodies[camera.body]
        rotation = np.array(turn(body))
        ahead, up = product(rotation, np.array(at.boresight)), product(rotation, np.array(at.up))
        position = product(rotation, np.array(at.position)) + body[:3]
        return Seen(position, np.array([np.cross(ahead, up), -up, ahead]), at)


@lru_cache(maxsize=16)
def _cameras_in_force(scenario: Scenario, changes: tuple[str, ...]) -> dict[str, Camera]:
    """Return the cameras of a scenario with changes in flight, by name."""
    return {camera.name: camera for camera in cameras_of(in_force(scenario, changes))}


def turn(seven: Array) -> Rows:
    """Return the rotation matrix of a pose (7,) whose attitude is a quaternion."""
    w, x, y, z = seven[3:].tolist()
    return rotation_of((w, x, y, z))
