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
        self._moved: tuple[str, bool] | None = None  # what decided, in the last frame, which point the sticks move

    def see(self, frame: Frame, before: Frame | None) -> None:
        """Add the next frame.

        A change of the mode or of the held payload may move the point of resolution, and ends a measurement.
        """
        self._automatic(frame)
        moved, self._moved = self._moved, (frame.mode, frame.payload is not None)
        if before is None or self._moved != moved or frame.sequence != "idle":
            self._released = None
            return
        released = sticks_released(frame)
        if released and not sticks_released(before):
            self._released = before.resolution
        if self._released is not None:
            self._stopping = max(self._stopping or 0.0, math.dist(frame.resolution, self._released))
            if not released or at_rest(frame):
                self._released = None

    def _automatic(self, frame: Frame) -> None:
        if frame.goal is None or frame.sequence != "in progress":
            self._overshoot, self._target = self._greatest, None
            return
        left = frame.goal.distance
        if frame.goal.position != self._target:
            self._overshoot = self._greatest
            self._target, self._nearest, self._past = frame.goal.position, left, 0.0
        if left < self._nearest:
            self._nearest, self._past = left, 0.0
        self._past = max(self._past, left - self._nearest)

    @property
    def _greatest(self) -> float | None:
        """Greatest overshoot, with that of the present motion; None if there was no motion."""
        return self._overshoot if self._target is None else max(self._overshoot or 0.0, self._past)

    def found(self) -> Iterator[Found]:
        """Yield what occurred: a manual motion that ended, an automatic motion."""
        if self._stopping is not None:
            yield STOPPING, Value(self._stopping)
        if self._greatest is not None:
            yield OVERSHOOT, Value(self._greatest)
