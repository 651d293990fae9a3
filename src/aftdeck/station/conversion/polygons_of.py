"""Pictures in the look of 1972, as the messages that a page receives."""

from __future__ import annotations

from typing import NamedTuple

import msgspec
import numpy as np

from aftdeck.errors import SimulationError
from aftdeck.matrices import product
from aftdeck.scenario.light import LightCondition
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.station.messages import from_page
from aftdeck.station.messages.to_page import Polygons
from aftdeck.visual.brightness import brightness, grey_levels, luminance
from aftdeck.visual.scene import Eye, VisualScene

HALF_WIDTH = 10_000
"""Half the width of a picture, in the units of `Polygons.points`."""


class Shot(NamedTuple):
    """What a picture shows: a camera, and the eye of an engineering view that a page directs, else None."""

    camera: str
    eye: Eye | None = None


def shot_of(picture: from_page.PolygonPicture) -> Shot:
    """Return what a picture shows."""
    return Shot(picture.camera, None if picture.eye is None else Eye(*msgspec.structs.astuple(picture.eye)))


class PolygonPictures:
    """Pictures of a scenario's cameras in the look of 1972."""

    def __init__(self, scenario: Scenario) -> None:
        self._scene = VisualScene(scenario)
        self._own = luminance(self._scene.clusters.colours)

    def of(self, frame: Frame, shot: Shot, aspect: float, light: LightCondition, step: int) -> Polygons:
        """Return the picture of a camera in a frame; if it cannot be drawn, its text says why.

        Args:
            frame: the frame.
            shot: the camera.
            aspect: width of the picture divided by its height.
            light: direction and strength of the light.
            step: number of the frame's step, for the message.
        """
        camera, eye = shot
        try:
            aim = self._scene.aim(frame, camera, aspect) if eye is None else self._scene.free_aim(camera, eye, aspect)
            drawn = self._scene.polygons(frame, aim)
        except SimulationError as error:
            when = f" at {frame.time_s:g} s"  # the monitor shows the time elsewhere
            return no_polygons(camera, f"No picture: {error}.".replace(when, ""), step)
        points = drawn.points * (HALF_WIDTH * np.array([aim.part[0], aim.part[1] / aspect]))
        greys = grey_levels(self._own[drawn.face], brightness(product(drawn.normal, aim.axes), light))
        return Polygons(
            step=step,
            camera=camera,
            points=np.rint(points).astype("<i2").tobytes(),
            corners=np.diff(drawn.begins).astype(np.uint8).tobytes(),
            greys=np.rint(255.0 * greys).astype(np.uint8).tobytes(),
            text="",
        )


def no_polygons(camera: str, text: str, step: int = -1, share: float | None = None) -> Polygons:
    """Return a picture without polygons; `text` says why there are none, and `share` what is done of a preparation."""
    return Polygons(step, camera, b"", b"", b"", text, share)
