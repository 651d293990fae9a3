"""Pictures of cameras as arrays, drawn by visual priority without a GPU."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from aftdeck.bodies.cameras import KINDS
from aftdeck.errors import InputError, SimulationError
from aftdeck.export.flight import Flight
from aftdeck.report.page.gather import Moment
from aftdeck.report.page.pictures import best_cameras
from aftdeck.scenario.light import LightCondition
from aftdeck.scenario.model import Scenario
from aftdeck.scene.cameras import SceneCameras
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.run import Simulation
from aftdeck.visual.picture import failed_picture, picture_of
from aftdeck.visual.png import pixels
from aftdeck.visual.scene import VisualScene

Pixels = NDArray[np.uint8]
COUNT = 2
"""Default number of cameras: those of two monitors."""
SIZE = (320, 240)
"""Default width and height of a picture [pixels]."""
LEAST_SIZE, MOST_SIZE = 16, 2048
"""Limits of a picture's width and height [pixels]."""


def names_of(cameras: Sequence[str]) -> dict[str, str]:
    """Return the camera of each picture, by a name of small letters, digits and underscores.

    Raises:
        InputError: a camera is named twice.
    """
    found: dict[str, str] = {}
    for camera in cameras:
        name = re.sub(r"[^a-z0-9]+", "_", camera.lower()).strip("_") or "camera"
        if name in found:
            raise InputError(f"cameras: got {camera!r} and {found[name]!r}, expected different cameras")
        found[name] = camera
    return found


class Painter:
    """Painter of a scenario's cameras.

    Args:
        scenario: the scenario.
        cameras: camera of each picture, by the picture's name.
        size: width and height [pixels].

    Raises:
        InputError: the scenario does not have a camera, or the size is not allowed; the message states what is allowed.
    """

    def __init__(self, scenario: Scenario, cameras: dict[str, str], size: tuple[int, int]) -> None:
        if not all(LEAST_SIZE <= length <= MOST_SIZE for length in size):
            raise InputError(
                f"size: got {size[0]}x{size[1]}, expected width x height in pixels, each from {LEAST_SIZE} to "
                f"{MOST_SIZE}"
            )
        self._scene, self._cameras, self._size = VisualScene(scenario), cameras, size
        for camera in cameras.values():
            if camera not in self._scene.cameras:
                raise InputError(
                    f"cameras: {scenario.name!r} has no camera {camera!r}; it has {', '.join(self._scene.cameras)}"
                )

    def draw(self, frame: Frame, light: LightCondition) -> dict[str, Pixels]:
        """Return the pictures (height, width, 3) of a frame; a camera inside a body gives a black picture."""
        drawn = {}
        for name, camera in self._cameras.items():
            try:
                picture = picture_of(self._scene, frame, camera, self._size, "colour", light, brief=True)
            except SimulationError as error:
                picture = failed_picture(self._size, "colour", camera, error)
            drawn[name] = pixels(picture._replace(labels=(), failure=""))
        return drawn


def usual_cameras(flight: Flight) -> tuple[str, ...]:
    """Return the cameras that a flight's monitors showed first; without monitors, two television cameras.

    They are those that see the tip best at the start of the flight, if there are any.
    """
    placed = SceneCameras(flight.scenario)
    shown = tuple(dict.fromkeys(name for name in flight.shown if name in placed.cameras))
    if shown:
        return shown
    frame = Simulation(flight.scenario, flight.recording.opening.seed).look()
    best = best_cameras(VisualScene(flight.scenario), placed, Moment("start", frame, ()))
    ranked = dict.fromkeys([*best, *placed.cameras])  # those that do not see the tip come last
    return tuple(sorted(ranked, key=lambda name: placed.cameras[name].kind != KINDS[0])[:COUNT])
