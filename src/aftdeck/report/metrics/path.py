"""Path and speed of the arm."""

from __future__ import annotations

import math
from collections.abc import Iterator
from operator import truediv

from aftdeck.report.metric import FORMAN, Found, Metric, Value
from aftdeck.simulation.frame import Frame
from aftdeck.tuples import Joints, Vec3

PATH = Metric("tip_path", "Tip path", "distance", "Length of the tip's path.", FORMAN)
DIRECTNESS = Metric(
    "directness",
    "Directness",
    "share",
    "Straight distance as a share of the tip's path. The run is divided wherever a payload is captured, released or "
    "fixed to a berth; the straight distances of these parts are added.",
    FORMAN,
)
TURNED = Metric("tip_rotation", "Tip rotation", "angle", "Sum of all angles by which the tip turned.")
SPEED = Metric("greatest_speed", "Greatest POR speed", "speed", "Greatest measured speed of the point of resolution.")
RATE = Metric(
    "worst_joint_rate",
    "Worst joint rate",
    "part of limit",
    "Greatest commanded joint rate, as a fraction of the joint's limit at that time.",
)
TARGET = Metric("target_distance", "Distance to target", "length", "Distance from the tip to the target, at the end.")
TARGET_ANGLE = Metric(
    "target_angle", "Angle to target", "angle", "Angle between the tip's attitude and the target's, at the end."
)
METRICS = (TARGET, TARGET_ANGLE, PATH, DIRECTNESS, TURNED, SPEED, RATE)


class Path:
    """Path and speed of the arm."""

    def __init__(self, period_s: float) -> None:
        self._period_s = period_s
        self._path = self._straight = self._turned = self._fastest = self._worst = 0.0
        self._from: Vec3 | None = None
        self._last: Frame | None = None
        self._handling: list[tuple[bool, str]] = []

    def see(self, frame: Frame, before: Frame | None) -> None:
        """Add the next frame."""
        self._last = frame
        self._turned += math.hypot(*frame.twist[:3]) * self._period_s
        self._fastest = max(self._fastest, math.hypot(*frame.twist[3:]))
        self._worst = max(self._worst, worst_rate(frame.rates_commanded, frame.rate_limits)[0])
        handled, self._handling = self._handling, _handling(frame)
        if before is None or self._from is None:
            self._from = frame.position
            return
        self._path += math.dist(frame.position, before.position)
        if self._handling != handled:
            self._straight += math.dist(frame.position, self._from)
            self._from = frame.position

    def found(self) -> Iterator[Found]:
        """Yield all metrics; the remaining distance only if the last frame has a target."""
        last, start = self._last, self._from
        if last is None or start is None:
            return
        if last.goal is not None:
            yield TARGET, Value(last.goal.distance)
            yield TARGET_ANGLE, Value(last.goal.angle)
        yield PATH, Value(self._path)
        if self._path > 0.0:
            yield DIRECTNESS, Value((self._straight + math.dist(last.position, start)) / self._path)
        yield TURNED, Value(self._turned)
        yield SPEED, Value(self._fastest)
        yield RATE, Value(self._worst)


def _handling(frame: Frame) -> list[tuple[bool, str]]:
    """Return, for each payload, whether it is held, and its berth."""
    return [(cargo.held, cargo.seat) for cargo in frame.work.cargo]


def worst_rate(rates: Joints, limits: Joints) -> tuple[float, int]:
    """Return the largest ratio |rate| / limit, and the index of its joint; the index is -1 if no joint moves."""
    parts = list(map(truediv, map(abs, rates), limits))
    worst = max(parts)
    return worst, parts.index(worst) if worst > 0 else -1
