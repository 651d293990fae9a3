"""One number of a reading's values in a run."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import reduce
from operator import add, gt

from aftdeck.report.metric import Found, Metric, Value
from aftdeck.simulation.readings.reading import Known, Recorded
from aftdeck.worksite.watch.alarm import Level


class Reduction:
    """Metric of a run, from the values of consecutive steps.

    Args:
        metric: its definition.
        how: how the values are reduced.
        joint: name of the joint; empty for a reading without joints.
        period_s: control period [s].
    """

    def __init__(self, metric: Metric, how: Recorded, joint: str, period_s: float) -> None:
        self._metric, self._how, self._joint, self._period_s = metric, how, joint, period_s
        self._total = math.inf if how.by == "least" else 0.0
        self._count = 0
        self._before = 0.0
        self._at: Known | None = None  # step with the greatest or least value; of other reducers, the first step
        self._level: Level = "info"

    def see(self, values: Sequence[float | None], steps: Sequence[Known]) -> None:
        """Add the values in the next steps; None for no value."""
        known = [value for value in values if value is not None]
        if len(known) < len(values):
            steps = [step for step, value in zip(steps, values, strict=True) if value is not None]
        if known:
            self._add(known, steps)

    def _add(self, values: Sequence[float], steps: Sequence[Known]) -> None:
        """Add the values in the next steps that have values."""
        if self._at is None:
            self._at, self._before = steps[0], values[0]
        match self._how.by:
            case "greatest":
                sizes = list(map(abs, values))
                self._decide(sizes, max(sizes), steps)
            case "least":
                self._decide(values, min(values), steps)
            case "last":
                self._total = values[-1]
            case "begun":
                self._total += sum(map(gt, values, [self._before, *values]))
            case "integral":
                self._total = reduce(add, [value * self._period_s for value in values], self._total)
            case "mean" | "time" | "share":
                self._total = reduce(add, values, self._total)
        self._before = values[-1]
        self._count += len(values)
        if self._how.level is not None and self._level != "warning":
            levels = set(map(self._how.level, steps))
            self._level = "warning" if "warning" in levels else "caution" if "caution" in levels else self._level

    def _decide(self, values: Sequence[float], value: float, steps: Sequence[Known]) -> None:
        """Take a greater or smaller value as the total, and the first step with it."""
        if (value > self._total) if self._how.by == "greatest" else (value < self._total):
            self._total, self._at = value, steps[values.index(value)]

    def found(self) -> Found | None:
        """Return the metric and its value; None without a value."""
        if self._at is None:
            return None
        total, by = self._total, self._how.by
        number = total / self._count if by in ("mean", "share") else total * self._period_s if by == "time" else total
        detail = "" if self._how.detail is None else self._how.detail(self._at, self._joint)
        return self._metric, Value(float(number), detail=detail, level=self._level)
