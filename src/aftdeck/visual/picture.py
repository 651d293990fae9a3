"""Picture of a camera: polygons with flat colours, and texts, ready to be written as SVG or PNG."""

from __future__ import annotations

import math
from typing import Literal, NamedTuple

import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.errors import SimulationError
from aftdeck.matrices import product
from aftdeck.scenario.light import LightCondition
from aftdeck.simulation.frame import Frame
from aftdeck.visual.brightness import GAMMA, brightness, grey_levels, luminance
from aftdeck.visual.scene import VisualScene

Look = Literal["colour", "1972"]
"""Look of a picture: in colour, or as on the monitors of the Remote Manipulator Simulation: greys, raster lines."""


class Label(NamedTuple):
    """Text at an edge of a picture.

    Attributes:
        text: the text.
        row: row, from 0 at the upper edge; negative from -1 at the lower edge.
        right: whether the text is at the right edge; otherwise it is at the left edge.
    """

    text: str
    row: int
    right: bool = False


class Picture(NamedTuple):
    """Picture of a camera.

    Attributes:
        width: width [pixels].
        height: height [pixels].
        points: (P, 2) corners of all polygons [pixels], from the upper left corner of the picture.
        begins: (Q + 1,) first corner of each polygon.
        colours: (Q, 3) sRGB colour of each polygon, 0 to 255.
        owner: (Q,) cluster of each polygon.
        look: the look.
        labels: texts at the edges.
        failure: reason for which there are no polygons; empty if there is none.
    """

    width: int
    height: int
    points: Array
    begins: Indices
    colours: Indices
    owner: Indices
    look: Look
    labels: tuple[Label, ...]
    failure: str = ""


def picture_of(
    scene: VisualScene,
    frame: Frame,
    camera: str,
    size: tuple[int, int],
    look: Look,
    light: LightCondition,
    *,
    brief: bool = False,
) -> Picture:
    """Return the picture of a camera in a frame.

    Args:
        scene: the scenario's visual scene.
        frame: the frame.
        camera: name of the camera.
        size: width and height [pixels].
        look: the look.
        light: direction and strength of the light.
        brief: whether the only text is the camera's name, because the page has the others.

    Raises:
        InputError: there is no such camera.
        SimulationError: the camera is inside a body, or the bodies cannot be put in order.
    """
    width, height = size
    aim = scene.aim(frame, camera, width / height)
    drawn = scene.polygons(frame, aim)
    half = np.array([0.5 * width, 0.5 * height])
    points = drawn.points * half * aim.part + half
    colours = _lit(scene, drawn.face, product(drawn.normal, aim.axes), look, light)
    across = math.degrees(2.0 * math.atan(aim.wide / aim.part[0]))
    labels = [Label(f"{camera}  {scene.cameras[camera].title}  {across:.0f} deg", -1)]
    if not brief:
        time, mode, clearance = readouts(frame)
        labels += [Label(mode, 0), Label(time, 0, right=True), Label(clearance, 1, right=True)]
    return Picture(width, height, points, drawn.begins, colours, drawn.owner, look, tuple(labels))


def failed_picture(size: tuple[int, int], look: Look, camera: str, error: SimulationError) -> Picture:
    """Return a picture without polygons that shows why there is none."""
    none = np.zeros(0, np.int64)
    return Picture(
        *size, np.empty((0, 2)), np.zeros(1, np.int64), none.reshape(0, 3), none, look, (Label(camera, -1),), str(error)
    )


def readouts(frame: Frame) -> tuple[str, str, str]:
    """Return the time, the mode and the minimum clearance of a frame, as texts."""
    near = frame.work.nearest
    clearance = "" if near is None else f"{near.a} - {near.b} {100.0 * near.clearance:.1f} cm"
    return f"{frame.time_s:.2f} s", frame.mode, clearance


def _lit(scene: VisualScene, face: Indices, normal: Array, look: Look, light: LightCondition) -> Indices:
    """Return the colours (Q, 3) of faces with normals (Q, 3) in the scene: each has one colour, without shadows."""
    bright, base = brightness(normal, light), scene.clusters.colours[face]
    if look == "1972":
        level = grey_levels(luminance(base), bright)
        base = np.ones((len(face), 3))
    else:
        level = np.minimum(bright, 1.0) ** (1.0 / GAMMA)
    return np.asarray(np.rint(255.0 * np.minimum(base * level[:, None], 1.0)), np.int64)
