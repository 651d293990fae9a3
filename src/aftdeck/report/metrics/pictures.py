"""Cameras on the monitors, and how their pictures are turned against the sticks."""

from __future__ import annotations

import math
from collections.abc import Iterator

from aftdeck.report.metric import DISPARITY, PONTILLO, Found, Metric, Value
from aftdeck.scenario.model import Scenario
from aftdeck.scene.stick_axes import PictureTurns
from aftdeck.simulation.frame import Frame
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
        self._turns = PictureTurns(scenario)
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
        names = tuple(name for shown in self._monitors.values() for name in shown)
        angles = self._turns.angles(frame, names)
        if angles:
            self._steps += 1
            self._sum += min(angles)
            self._crossed += min(angles) > math.pi / 2

    def found(self) -> Iterator[Found]:
        """Yield the metrics, if a page reported its cameras; the angle only if a stick was deflected."""
        if self._monitors:
            yield CAMERAS, Value(float(self._changes))
        if self._steps:
            yield TURNED, Value(self._sum / self._steps)
            yield CROSSED, Value(self._crossed / self._steps)
