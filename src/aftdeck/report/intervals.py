"""Means and rates with their 95 % intervals."""

from __future__ import annotations

import math
import statistics
from collections.abc import Sequence
from typing import NamedTuple

Z = 1.959963984540054
"""Quantile of the standard normal distribution for an interval of 95 %."""
_T = (
    12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228,
    2.201, 2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086,
    2.080, 2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042,
)  # fmt: skip
"""Quantiles of Student's distribution for an interval of 95 %, for 1 to 30 degrees of freedom, from tables."""


class Interval(NamedTuple):
    """Estimate with its 95 % interval."""

    value: float
    low: float
    high: float


def wilson(successes: int, count: int) -> Interval:
    """Return the rate of successes, with Wilson's score interval of 95 % (E. B. Wilson, 1927).

    >>> wilson(0, 10)
    Interval(value=0.0, low=0.0, high=0.2775327998628892)
    """
    if count == 0:
        return Interval(math.nan, 0.0, 1.0)
    rate, share = successes / count, Z * Z / count
    middle = (rate + share / 2.0) / (1.0 + share)
    half = Z * math.sqrt(rate * (1.0 - rate) / count + share / (4.0 * count)) / (1.0 + share)
    low = 0.0 if successes == 0 else middle - half
    high = 1.0 if successes == count else middle + half
    return Interval(rate, low, high)


def mean_interval(values: Sequence[float]) -> Interval:
    """Return the mean with Student's interval of 95 %; the interval is a point if all values are equal or single."""
    mean = statistics.fmean(values)
    if len(values) == 1:
        return Interval(mean, mean, mean)
    quantile = _T[len(values) - 2] if len(values) - 2 < len(_T) else Z
    half = quantile * statistics.stdev(values) / math.sqrt(len(values))
    return Interval(mean, mean - half, mean + half)
