"""One number of a reading's values in a run."""

from __future__ import annotations

import math
from collections.abc import Callable

from aftdeck.report.metric import Found, Metric, Value
from aftdeck.simulation.readings.reading import Known, Recorded, Reducer
from aftdeck.worksite.watch.alarm import Level

_NEXT: dict[Reducer, Callable[[float, float, float, float], float]] = {
    "greatest": lambda total, value, before, period_s: max(total, abs(value)),
    "least": lambda total, value, before, period_s: min(total, value),
    "mean": lambda total, value, before, period_s: total + value,
    "last": lambda total, value, before, period_s: value,
    "integral": lambda total, value, before, period_s: total + value * period_s,
    "time": lambda total, value, before, period_s: total + value,
    "share": lambda total, value, before, period_s: total + value,
    "begun": lambda total, value, before, period_s: total + (value > before),
}
"""Function of each reducer: the new total from the old one, the value, the value before, and the control period [s]."""
_SETTLED = ("greatest", "least", "last", "begun")
"""Reducers whose total does not change if a value is repeated; that of the others does not change by a zero."""


class Reduction:
    """Metric of a run, value by value.

    Args:
        metric: its definition.
        how: how the values are reduced.
        joint: name of the joint; empty for a reading without joints.
        period_s: control period [s].
    """

    def __init__(self, metric: Metric, how: Recorded, joint: str, period_s: float) -> None:
        self._metric, self._how, self._joint, self._period_s = metric, how, joint, period_s
        self._next = _NEXT[how.by]
        self._total = math.inf if how.by == "least" else 0.0
        self._count = 0
        self._before: float | None = None
        self._settled = how.by in _SETTLED and how.level is None
        self._adds = how.by not in _SETTLED and how.level is None
        self._at: Known | None = None  # step that decided the total
        self._level: Level = "info"

    def see(self, value: float | None, known: Known) -> None:
        """Add the value in the next step; None for no value."""
        if value is None or (self._settled and value == self._before):
            return
        if not value and self._adds and self._at is not None:
            self._count += 1
            return
        total = self._next(self._total, value, value if self._before is None else self._before, self._period_s)
        if total != self._total or self._at is None:
            self._total, self._at = total, known
        self._before = value
        self._count += 1
        if self._how.level is not None and self._level != "warning" and (level := self._how.level(known)) != "info":
            self._level = level

    def found(self) -> Found | None:
        """Return the metric and its value; None without a value."""
        if self._at is None:
            return None
        total, by = self._total, self._how.by
        number = total / self._count if by in ("mean", "share") else total * self._period_s if by == "time" else total
        detail = "" if self._how.detail is None else self._how.detail(self._at, self._joint)
        return self._metric, Value(float(number), detail=detail, level=self._level)
