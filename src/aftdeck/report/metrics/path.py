"""Path of the arm."""

from __future__ import annotations

import math
from collections.abc import Iterator

from aftdeck.report.metric import Found, Metric, Value
from aftdeck.report.recorded import recorded
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.readings.source import FORMAN
from aftdeck.tuples import Vec3

PATH = Metric("tip_path", "Tip path", "distance", "Length of the tip's path.", FORMAN)
DIRECTNESS = Metric(
    "directness",
    "Directness",
    "share",
    "Straight distance as a share of the tip's path. The run is divided wherever a payload is captured, released or "
    "fixed to a berth; the straight distances of these parts are added.",
    FORMAN,
)
METRICS = (recorded("target_distance_m"), recorded("target_angle_rad"), PATH, DIRECTNESS, recorded("tip_rotation_rad"))


class Path:
    """Path of the arm."""

    def __init__(self) -> None:
        self._path = self._straight = 0.0
        self._from: Vec3 | None = None
        self._last: Vec3 | None = None
        self._handling: list[tuple[bool, str]] = []

    def see(self, frame: Frame, before: Frame | None) -> None:
        """Add the next frame."""
        self._last = frame.position
        handled, self._handling = self._handling, _handling(frame)
        if before is None or self._from is None:
            self._from = frame.position
            return
        self._path += math.dist(frame.position, before.position)
        if self._handling != handled:
            self._straight += math.dist(frame.position, self._from)
            self._from = frame.position

    def found(self) -> Iterator[Found]:
        """Yield all metrics."""
        if self._last is None or self._from is None:
            return
        yield PATH, Value(self._path)
        if self._path > 0.0:
            yield DIRECTNESS, Value((self._straight + math.dist(self._last, self._from)) / self._path)


def _handling(frame: Frame) -> list[tuple[bool, str]]:
    """Return, for each payload, whether it is held, and its berth."""
    return [(payload.held, payload.seat) for payload in frame.work.cargo]
