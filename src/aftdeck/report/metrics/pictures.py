"""Cameras on the monitors, and how their pictures are turned against the sticks."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cached_property

import numpy as np

from aftdeck.arrays import Array
from aftdeck.frames import SCENE_FROM_PANEL_AXES
from aftdeck.report.metric import Found, Metric, Value
from aftdeck.scenario.model import Scenario
from aftdeck.scene.cameras import SceneCameras
from aftdeck.scene.stick_axes import StickAxes
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.readings.source import DISPARITY, PONTILLO
from aftdeck.steering.mode import MODES

CAMERAS = Metric(
    "camera_changes",
    "Camera changes",
    "count",
    "Number of times that a monitor changed its camera or was split.",
    PONTILLO,
)
TURNED = Metric(
    "stick_to_picture_angle",
    "Stick to picture, angle",
    "angle",
    "Angle between the directions of the sticks and those of the picture, on the monitor with the smaller angle; mean "
    "over the time with a deflected THC or RHC.",
    DISPARITY,
)
CROSSED = Metric(
    "crossed_share",
    "Pictures crossed",
    "share",
    "While the THC or the RHC is deflected: share of the time in which the pictures of all monitors are turned by more "
    "than 90 deg against the sticks.",
    DISPARITY,
)
METRICS = (CAMERAS, TURNED, CROSSED)


class Pictures:
    """Cameras on the monitors, and their pictures."""

    def __init__(self, scenario: Scenario) -> None:
        self._scenario, self._sticks = scenario, StickAxes(scenario)
        self._changes = self._steps = self._crossed = 0
        self._sum = 0.0
        self._monitors: dict[int, tuple[str, ...]] = {}

    def shown(self, monitors: tuple[tuple[str, ...], ...]) -> None:
        """Set the cameras that the monitors show from the next frame on, and count the changes."""
        for monitor, names in enumerate(monitors):
            if not names:  # the page has left, or does not report its cameras
                continue
            self._changes += names != self._monitors.get(monitor, names)
            self._monitors[monitor] = names

    def see(self, frame: Frame, before: Frame | None) -> None:
        """Add the next frame."""
        if not self._monitors or not (any(frame.translation) or any(frame.rotation)):
            return
        if MODES[frame.mode].axes in ("joint", "none"):  # the sticks have no direction
            return
        if angles := self._angles(frame):
            self._steps += 1
            self._sum += min(angles)
            self._crossed += min(angles) > math.pi / 2

    @cached_property
    def _cameras(self) -> SceneCameras:
        """Cameras in the scene; a run without monitors does not need them."""
        return SceneCameras(self._scenario)

    def _angles(self, frame: Frame) -> list[float]:
        """Return the angle of each picture [rad], without views for engineers, which the page moves freely."""
        sticks = SCENE_FROM_PANEL_AXES @ np.array(self._sticks.in_panel(frame))
        bodies, cameras = self._cameras.bodies_at(frame), self._cameras.cameras
        names = [name for shown in self._monitors.values() for name in shown if name in cameras]
        return [
            picture_angle(self._cameras.seen(frame, bodies, name).axes, sticks)
            for name in names
            if cameras[name].kind != "engineering"
        ]

    def found(self) -> Iterator[Found]:
        """Yield the metrics, if a page reported its cameras; the angle only if a stick was deflected."""
        if self._monitors:
            yield CAMERAS, Value(float(self._changes))
        if self._steps:
            yield TURNED, Value(self._sum / self._steps)
            yield CROSSED, Value(self._crossed / self._steps)


def picture_angle(picture: Array, sticks: Array) -> float:
    """Return the angle of the rotation from the directions of a picture to those of the sticks [rad].

    It is zero if THC +X moves into the picture, +Y to the right and +Z down.

    Args:
        picture: (3, 3) rows are the directions right, down and ahead of the picture.
        sticks: (3, 3) columns are the directions X, Y and Z of the THC, in the same frame.
    """
    right, down, ahead = picture
    trace = float(ahead @ sticks[:, 0] + right @ sticks[:, 1] + down @ sticks[:, 2])
    return math.acos(max(-1.0, min(1.0, (trace - 1.0) / 2.0)))
