"""Strips of a playback or a live run. For a playback the curves are thinned for drawing, and keep every peak."""

from __future__ import annotations

import math
from array import array
from collections.abc import Callable, Iterator, Sequence
from operator import itemgetter
from typing import NamedTuple

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from aftdeck.report.curves import Curve, Strip
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.log import joint_label
from aftdeck.simulation.readings.motion import worst_rate
from aftdeck.simulation.readings.reading import Known, Reading, Role, Value
from aftdeck.simulation.readings.table import readings_of

BUCKETS = 1000
"""Number of equal parts of a run. A curve keeps the least and the greatest value of each part.

The drawn curve then has about two values for each pixel of the strip's width.
"""

_AT_ONCE = 64
"""Number of steps whose values are computed at once."""


class Source(NamedTuple):
    """Strip without values, and where the values of its curves come from.

    Attributes:
        blank: the strip.
        curves: function that returns the value of each curve, and the number of the part; None if it has no parts.
    """

    blank: Strip
    curves: tuple[tuple[Value, int | None], ...]


def sources(scenario: Scenario) -> tuple[Source, ...]:
    """Return every strip that a recording of this scenario can show."""
    return tuple(source for reading in readings_of(scenario) for source in _sources(reading, scenario))


def _sources(reading: Reading, scenario: Scenario) -> Iterator[Source]:
    """Yield the strip of a reading, or one for each joint; nothing for a reading without a strip."""
    if (strip := reading.strip) is None:
        return
    caution, warning = (None, None) if strip.alarms is None else strip.alarms(scenario)
    both: tuple[tuple[Role, Value | None], ...] = (("commanded", reading.commanded), (strip.role, reading.of))
    curves = [(role, of) for role, of in both if of is not None]
    blanks, bounds = tuple(Curve(role, (), ()) for role, _ in curves), (strip.limit, caution, warning)
    parts = reading.labels(scenario)
    for k, (part, quantity) in enumerate(zip(parts or ("",), reading.quantities(scenario), strict=True)):
        name = reading.heading.format(part=part)
        blank = Strip(name, quantity, blanks, 0.0, 0.0, *bounds, strip.shown, strip.rests)
        yield Source(blank, tuple((of, k if parts else None) for _, of in curves))


class _Functions:
    """Functions of the values of all curves.

    Attributes:
        functions: the functions, each once.
        places: for each curve, strip by strip, the index of its function, and the number of its part; None if the
            function has no parts.
    """

    def __init__(self, scenario: Scenario) -> None:
        curves = [curve for source in sources(scenario) for curve in source.curves]
        self.functions = list(dict.fromkeys(of for of, _ in curves))
        self.places = [(self.functions.index(of), part) for of, part in curves]


def curve_values(scenario: Scenario) -> Callable[[Frame, float | None], tuple[float | None, ...]]:
    """Return a function that returns the values of all curves, strip by strip, for a frame and its latency [ms]."""
    own = _Functions(scenario)

    def values(frame: Frame, latency_ms: float | None) -> tuple[float | None, ...]:
        known = Known(frame, scenario, latency_ms=latency_ms)
        found = [of(known) for of in own.functions]
        return tuple([found[k] if part is None else found[k][part] for k, part in own.places])

    return values


class Strips:
    """All curves of a run, collected frame by frame; their values are computed many at a time."""

    def __init__(self, scenario: Scenario, period_s: float) -> None:
        self._scenario, self._period_s = scenario, period_s
        self._blank, self._functions = blank(scenario), _Functions(scenario)
        self._curves = [array("d") for _ in self._functions.places]
        self._steps: list[Known] = []

    def add(self, frame: Frame, latency_ms: float | None) -> None:
        """Add the next frame, and the latency in its step [ms]; None if it was not measured."""
        self._steps.append(Known(frame, self._scenario, latency_ms=latency_ms))
        if len(self._steps) == _AT_ONCE:
            self._compute()

    def _compute(self) -> None:
        """Compute the values in the collected steps."""
        steps, self._steps = self._steps, []
        if not steps:
            return
        found = [list(map(of, steps)) for of in self._functions.functions]
        for curve, (k, part) in zip(self._curves, self._functions.places, strict=True):
            values = found[k] if part is None else list(map(itemgetter(part), found[k]))
            curve.extend([math.nan if value is None else value for value in values] if None in values else values)

    def strips(self) -> tuple[Strip, ...]:
        """Return all strips, thinned; a curve without any value has no points."""
        self._compute()
        columns = iter([np.asarray(curve) for curve in self._curves])
        return tuple(self._strip(strip, [next(columns) for _ in strip.curves]) for strip in self._blank)

    def _strip(self, strip: Strip, columns: Sequence[NDArray[np.float64]]) -> Strip:
        """Return a strip with these values. Its range is from the least to the greatest value."""
        curves, ends = [], [0.0] if strip.rests else []
        for curve, values in zip(strip.curves, columns, strict=True):
            if np.isnan(values).all():
                curves.append(curve)
                continue
            ends += [float(np.nanmin(values)), float(np.nanmax(values))]
            kept = thin(values)
            times = [round((i + 1) * self._period_s, 9) for i in kept.tolist()]
            shown = [None if math.isnan(value) else value for value in values[kept].tolist()]
            curves.append(Curve(curve.role, tuple(times), tuple(shown)))
        return replace(strip, curves=tuple(curves), low=min(ends, default=0.0), high=max(ends, default=0.0))


def blank(scenario: Scenario) -> tuple[Strip, ...]:
    """Return all strips, with curves that have no points."""
    return tuple(source.blank for source in sources(scenario))


def thin(values: NDArray[np.float64]) -> NDArray[np.intp]:
    """Return the indices of the values to draw.

    Selected values: the first and the last; the two values next to each edge of a gap (NaN); the least and the greatest
    value of each part (`BUCKETS`). A selected value is omitted if it equals the selected values before and after it.

    Args:
        values: one value for each step, not empty; NaN where there is no value.

    Returns:
        Indices, ascending.
    """
    last = len(values) - 1
    width = -(-len(values) // BUCKETS)
    parts = np.full((-(-len(values) // width), width), math.nan)
    parts.flat[: len(values)] = values
    missing = np.isnan(parts)
    starts = np.arange(len(parts)) * width
    least = starts + np.where(missing, math.inf, parts).argmin(axis=1)
    greatest = starts + np.where(missing, -math.inf, parts).argmax(axis=1)
    breaks = np.flatnonzero(np.diff(np.isnan(values)))  # a gap begins or ends after each of these indices
    kept = np.unique(np.concatenate([[0, last], least, greatest, breaks, breaks + 1]))
    kept = kept[kept <= last]
    shown = np.nan_to_num(values[kept], nan=math.inf)
    level = np.zeros(len(kept), dtype=bool)
    level[1:-1] = (shown[1:-1] == shown[:-2]) & (shown[1:-1] == shown[2:])
    return kept[~level]


def worst_joint(frame: Frame, scenario: Scenario) -> str:
    """Return the display name of the joint nearest to its rate limit; empty if no joint moves."""
    _, joint = worst_rate(frame.rates, frame.rate_limits)
    return joint_label(scenario.arm.joints[joint]) if joint >= 0 else ""
