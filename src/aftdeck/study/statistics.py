"""Statistics of the results: groups of cases by the value of a factor, success rates, means, main effects."""

from __future__ import annotations

import itertools
import math
import statistics
from collections.abc import Sequence
from typing import NamedTuple

from aftdeck.report.intervals import Interval, wilson
from aftdeck.report.table import Row
from aftdeck.study.factor import Factor

BINS = 6
"""Greatest number of groups into which drawn values are divided."""
FEWEST_IN_BIN = 4
"""Fewest cases of such a group, if there are enough."""


class Group(NamedTuple):
    """Cases with one value of a factor, or with neighbouring drawn values.

    Attributes:
        label: the value, or the range of values.
        at: the value, or the mean of the values; None if the factor has no numbers.
        rows: the cases.
    """

    label: str
    at: float | None
    rows: tuple[Row, ...]


def groups(factor: Factor, rows: Sequence[Row]) -> list[Group]:
    """Return the cases by the value of a factor, in the order of its levels; groups without a case are left out."""
    if factor.span is not None:
        return _bins(factor.column, rows)
    cells = list(dict.fromkeys(level.cell for level in factor.levels))
    found = []
    for cell in cells:
        own = tuple(row for row in rows if row[factor.column] == cell)
        at = float(cell) if isinstance(cell, int | float) and not isinstance(cell, bool) else None
        if own:
            found.append(Group(f"{cell:g}" if isinstance(cell, float) else str(cell), at, own))
    return found


def _bins(column: str, rows: Sequence[Row]) -> list[Group]:
    """Return groups of about the same size, by the drawn values."""
    ordered = sorted(rows, key=lambda row: float(row[column] or 0.0))
    count = max(1, min(BINS, len(ordered) // FEWEST_IN_BIN))
    edges = [round(i * len(ordered) / count) for i in range(count + 1)]
    found = []
    for first, last in itertools.pairwise(edges):
        own = tuple(ordered[first:last])
        if own:
            values = [float(row[column] or 0.0) for row in own]
            found.append(Group(f"{values[0]:.4g} to {values[-1]:.4g}", statistics.fmean(values), own))
    return found


def numbers(rows: Sequence[Row], column: str) -> list[float]:
    """Return the values of a column; cases without a value are left out."""
    return [float(value) for row in rows if (value := row[column]) is not None]


def success_rate(rows: Sequence[Row]) -> Interval:
    """Return the share of successful cases, with Wilson's score interval."""
    return wilson(sum(bool(row["success"]) for row in rows), len(rows))


class Effect(NamedTuple):
    """Main effect of a factor on a response.

    Attributes:
        factor: name of the factor.
        least: group with the least mean, and this mean.
        greatest: group with the greatest mean, and this mean.
        share: share of the response's variance that the means of the groups explain (eta squared); None without any.
    """

    factor: str
    least: tuple[str, float]
    greatest: tuple[str, float]
    share: float | None


def effect(factor: Factor, rows: Sequence[Row], column: str) -> Effect | None:
    """Return the main effect of a factor on a column; None if no case has a value."""
    found = [(group.label, values) for group in groups(factor, rows) if (values := numbers(group.rows, column))]
    if not found:
        return None
    every = [value for _, values in found for value in values]
    mean = statistics.fmean(every)
    total = math.fsum((value - mean) ** 2 for value in every)
    between = math.fsum(len(values) * (statistics.fmean(values) - mean) ** 2 for _, values in found)
    means = [(label, statistics.fmean(values)) for label, values in found]
    share = between / total if total > 1e-18 * max(1.0, mean * mean) * len(every) else None
    return Effect(factor.name, min(means, key=lambda pair: pair[1]), max(means, key=lambda pair: pair[1]), share)
