"""Numbers of a chart's axis: few, round, and with as many digits as tell them apart."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

_STEPS = (1.0, 2.0, 2.5, 5.0, 10.0)
"""Mantissas of the distances of two numbers."""
_MOST = 9
"""Greatest number of intervals of an axis."""
_CLOSE = 1e-10
"""Part of a distance by which rounding may put a number beyond the end of the axis."""
_SMALL, _GREAT = 1e-5, 1e6
"""Magnitudes of a range below and from which on its numbers are written as multiples of a power of ten."""


class Ticks(NamedTuple):
    """Numbers of an axis.

    Attributes:
        values: the numbers, ascending.
        texts: their texts.
        power: power of ten of which the texts are multiples: ``1e-6``; empty for 1.
    """

    values: Sequence[float]
    texts: Sequence[str]
    power: str


def ticks(low: float, high: float, most: float) -> Ticks:
    """Return the numbers of an axis from `low` to `high`, which is greater; `most` is the room for intervals.

    >>> ticks(0.0, 600.0, 12.8).texts
    ['0', '100', '200', '300', '400', '500', '600']
    >>> ticks(-0.011, 0.23, 4.7).texts
    ['0.0', '0.1', '0.2']
    """
    intervals = min(max(1, int(most)), _MOST)
    wanted = (high - low) / intervals
    scale = 10.0 ** math.floor(math.log10(wanted))
    steps = [mantissa * size for size in (0.1 * scale, scale) for mantissa in _STEPS]
    fits = next(k for k, step in enumerate(steps) if step >= wanted * (1.0 - _CLOSE))
    for step in reversed(steps[: fits + 1]):
        first, last = math.ceil(low / step - _CLOSE), math.floor(high / step + _CLOSE)
        if last > first:
            break
    values = [k * step for k in range(first, last + 1)]
    greatest = max(map(abs, values))
    power = math.floor(math.log10(greatest)) if not _SMALL <= greatest < _GREAT else 0
    shown = [value / 10.0**power for value in values]
    decimals = next((k for k in range(16) if _told_by(shown, k, step / 10.0**power)), 16)
    texts = [f"{value + 0.0:.{decimals}f}".replace("-", "−") for value in shown]
    return Ticks(values, texts, f"1e{power}" if power else "")


def _told_by(values: Sequence[float], decimals: int, step: float) -> bool:
    """Return whether rounding to these decimals changes none of the values by a thousandth of their distance."""
    return all(abs(value - round(value, decimals)) < 1e-3 * step for value in values)
