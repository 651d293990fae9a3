"""Pictures of an environment: a camera of its scenario, drawn by visual priority without a GPU."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Literal, NamedTuple, get_args

import numpy as np

from aftdeck.arrays import Array
from aftdeck.compiled_first import compiled_first
from aftdeck.errors import InputError, SimulationError
from aftdeck.export.pictures import LEAST_SIZE, MOST_SIZE, Pixels
from aftdeck.gym.choices import one_of, whole
from aftdeck.matrices import product
from aftdeck.report.page.gather import Moment
from aftdeck.report.page.pictures import best_cameras
from aftdeck.scenario.light import condition_named
from aftdeck.scenario.model import Scenario
from aftdeck.scene.cameras import SceneCameras
from aftdeck.simulation.frame import Frame
from aftdeck.visual import warm
from aftdeck.visual.picture import Look, Picture, failed_picture, picture_of
from aftdeck.visual.png import pixels
from aftdeck.visual.scene import VisualScene

LOOKS: tuple[Look, ...] = get_args(Look)
Mode = Literal["rgb_array", "human"]
MODES: tuple[Mode, ...] = get_args(Mode)
"""Modes of Gymnasium in which an environment shows its episodes: pictures as arrays, and pages of the station."""
WIDTH, HEIGHT = 640, 480
"""Default width and height of a picture [pixels]."""
_LEAST_AHEAD = 0.1
"""Least distance ahead of a camera at which a bar is drawn [m]."""


class Bar(NamedTuple):
    """Bar that marks a place: it is drawn in front of everything, with one width in the whole picture.

    Attributes:
        ends: (2, 3) its ends in L [m].
        colour: sRGB colour, 0 to 255.
        width: its width, as a fraction of the picture's height.
    """

    ends: Array
    colour: tuple[int, int, int]
    width: float


class Pictures:
    """Pictures of one camera.

    Args:
        scenario: scenario with the camera.
        camera: name of the camera; None for the first of `usual` that the scenario has, or else the camera that sees
            the tip best in the first picture.
        usual: names of usual cameras.
        look: ``colour``, or ``1972`` for greys and raster lines.
        width: width [pixels].
        height: height [pixels].

    Raises:
        InputError: the scenario has no such camera, or an argument is not allowed; the message states what is allowed.
    """

    def __init__(
        self, scenario: Scenario, camera: str | None, usual: Sequence[str], look: Look, width: int, height: int
    ) -> None:
        self._look, self._size = one_of("look", look, LOOKS), (_length("width", width), _length("height", height))
        self._light = condition_named(scenario.lighting.condition)
        self._placed = SceneCameras(scenario)
        names = list(self._placed.cameras)
        if camera is not None:
            usual = (one_of(f"camera: of {scenario.name!r}", camera, names),)
        self._camera = next((name for name in usual if name in names), None)
        compiled_first(warm.warm_up, package="aftdeck.visual", files=warm.FILES)
        self._scene = VisualScene(scenario)

    def draw(self, frame: Frame, bars: Sequence[Bar] = ()) -> Pixels:
        """Return the picture (height, width, 3) of a frame; a camera inside a body gives a black picture."""
        if self._camera is None:
            best = best_cameras(self._scene, self._placed, Moment("start", frame, ()))
            self._camera = next(iter(best), next(iter(self._placed.cameras)))
        try:
            picture = picture_of(self._scene, frame, self._camera, self._size, self._look, self._light, brief=True)
        except SimulationError as error:
            picture = failed_picture(self._size, self._look, self._camera, error)
        picture = picture._replace(labels=(), failure="")
        return pixels(self._marked(picture, frame, bars) if bars else picture)

    def _marked(self, picture: Picture, frame: Frame, bars: Sequence[Bar]) -> Picture:
        """Return a picture with bars, each a polygon of four corners, after all others."""
        width, height = self._size
        assert self._camera is not None, "`draw` has chosen a camera"
        aim = self._scene.aim(frame, self._camera, width / height)
        half = np.array([0.5 * width, 0.5 * height])
        corners, colours = [], []
        for bar in bars:
            ends = np.array([self._placed.poses.point(end.tolist()) for end in bar.ends])
            seen = product(ends - aim.position, aim.axes.T)
            if seen[:, 2].min() < _LEAST_AHEAD:
                continue
            flat = seen[:, :2] / (seen[:, 2:] * [aim.wide, aim.high]) * half * aim.part + half
            along = flat[1] - flat[0]
            across = np.array([-along[1], along[0]]) * 0.5 * bar.width * height / max(math.hypot(*along), 1.0)
            corners.append([flat[0] + across, flat[1] + across, flat[1] - across, flat[0] - across])
            colours.append((255, 255, 255) if self._look == "1972" else bar.colour)
        if not corners:
            return picture
        return picture._replace(
            points=np.concatenate([picture.points, np.reshape(corners, (-1, 2))]),
            begins=np.concatenate([picture.begins, picture.begins[-1] + 4 * np.arange(1, len(corners) + 1)]),
            colours=np.concatenate([picture.colours, np.array(colours, np.int64)]),
        )


def _length(name: str, given: object) -> int:
    """Return a width or a height.

    Raises:
        InputError: it is not a whole number in the allowed range.
    """
    length = whole(name, given, LEAST_SIZE)
    if length > MOST_SIZE:
        raise InputError(f"{name}: got {length}, expected {LEAST_SIZE} to {MOST_SIZE} pixels")
    return length
