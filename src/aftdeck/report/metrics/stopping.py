"""Stopping after manual motions, and overshoot of automatic ones."""

from __future__ import annotations

import math
from collections.abc import Iterator

from aftdeck.report.metric import Found, Metric, Value
from aftdeck.simulation.frame import Frame
from aftdeck.task.reached import at_rest, sticks_released
from aftdeck.tuples import Vec3

STOPPING = Metric(
    "stopping_distance",
    "Stopping distance",
    "gap",
    "Greatest distance of the point of resolution from its place at the release of all sticks, until it was at rest.",
    "JSC-12628, loaded arm; Shuttle limit: 0.6 m",
)
OVERSHOOT = Metric(
    "overshoot",
    "Overshoot",
    "gap",
    "Greatest distance by which the tip, in an automatic motion, went away from its target after it was nearest.",
    "JSC-12628, modes 1 to 3",
)
METRICS = (STOPPING, OVERSHOOT)


class Stopping:
    """Stopping distance and overshoot."""

    def __init__(self) -> None:
        self._released: Vec3 | None = None
        self._stopping: float | None = None
        self._overshoot: float | None = None
        self._target: Vec3 | None = None
        self._nearest, self._past = math.inf, 0.0

    def see(self, frame: Frame, before: Frame | None) -> None:
        """Add the next frame."""
        released = sticks_released(frame)
        if before is not None and released and not sticks_released(before):
            self._released = before.resolution
            self._stopping = self._stopping or 0.0
        if self._released is not None:
            self._stopping = max(self._stopping or 0.0, math.dist(frame.resolution, self._released))
            if not released or at_rest(frame) or frame.sequence == "in progress":
                self._released = None
        self._automatic(frame)

    def _automatic(self, frame: Frame) -> None:
        if frame.goal is None or frame.sequence != "in progress":
            self._end_motion()
            return
        left = frame.goal.distance
        if frame.goal.position != self._target:
            self._end_motion()
            self._target, self._nearest, self._past = frame.goal.position, left, 0.0
        if left < self._nearest:
            self._nearest, self._past = left, 0.0
        self._past = max(self._past, left - self._nearest)

    def _end_motion(self) -> None:
        if self._target is not None:
            self._overshoot = max(self._overshoot or 0.0, self._past)
        self._target = None

    def found(self) -> Iterator[Found]:
        """Yield what occurred: a manual motion that ended, an automatic motion."""
        self._end_motion()
        if self._stopping is not None:
            yield STOPPING, Value(self._stopping)
        if self._overshoot is not None:
            yield OVERSHOOT, Value(self._overshoot)
