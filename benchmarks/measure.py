"""Measured figures, and timing of short calls."""

from __future__ import annotations

import math
import timeit
from collections.abc import Callable

import msgspec


class Figure(msgspec.Struct, frozen=True):
    """Measured number.

    Attributes:
        name: what was measured.
        value: the number.
        unit: its unit.
        target: greatest value that is promised. None for another library, or for a figure without a promise.
        note: conditions of the measurement.
    """

    name: str
    value: float
    unit: str
    target: float | None = None
    note: str = ""

    @property
    def kept(self) -> bool:
        """True if the value meets its target, or if the figure has no target."""
        return self.target is None or self.value <= self.target


Benchmark = Callable[[], list[Figure]]


def microseconds(statement: str, names: dict[str, object], *, repeat: int = 150, span: float = 0.002) -> float:
    """Return the time of one execution of `statement` [us]: the best of `repeat` loops of about `span` [s] each."""
    timer = timeit.Timer(statement, globals=names)
    timer.timeit(1)  # compiles
    once = max(timer.timeit(3) / 3, 1e-8)
    number = max(1, round(span / once))
    return min(timer.repeat(repeat, number)) / number * 1e6


def percentile(values: list[float], percent: float) -> float:
    """Return the smallest value that at least `percent` % of the values do not exceed."""
    ordered = sorted(values)
    return ordered[max(0, math.ceil(percent / 100 * len(ordered)) - 1)]
