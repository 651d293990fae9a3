"""Range of a factor's values: a number from 0 to 1 selects a value."""

from __future__ import annotations

import math
import re
from statistics import NormalDist
from typing import NamedTuple

from aftdeck.errors import InputError
from aftdeck.study.schema import Distribution, FactorSpec

_NUMBER = re.compile(r"\s*(?P<number>[-+]?(\d+(\.\d*)?|\.\d+)([eE][-+]?\d+)?)\s*(?P<unit>[A-Za-z][A-Za-z/* ]*)?\s*")
_DIGITS = 10
"""Significant digits of a drawn value. The last digits of a logarithm differ from machine to machine; these do not."""
_INSIDE = 1e-12
"""Distance of a drawn probability from 0 and 1, at which a normal distribution has no finite value."""


class Measure(NamedTuple):
    """A number with its unit; the unit is "" for a number in SI units."""

    number: float
    unit: str


def measure(value: object) -> Measure | None:
    """Return a number, or a text with a number and a unit, as a measure; None for any other value."""
    if isinstance(value, bool):
        return None
    if isinstance(value, int | float):
        return Measure(float(value), "") if math.isfinite(value) else None
    found = _NUMBER.fullmatch(value) if isinstance(value, str) else None
    if found is None or found["unit"] is None:
        return None
    return Measure(float(found["number"]), found["unit"].replace(" ", ""))


class Span(NamedTuple):
    """Range or distribution of a factor's values.

    Attributes:
        distribution: distribution of the values; with the scale ``log``, of their logarithms.
        low: least value.
        high: greatest value.
        mean: mean of a normal, median of a lognormal, peak of a triangular distribution.
        deviation: standard deviation of a normal distribution, or of the logarithm.
        log: whether equal steps are equal ratios.
        unit: unit of the values; "" for SI units.
    """

    distribution: Distribution
    low: float
    high: float
    mean: float
    deviation: float
    log: bool
    unit: str

    def at(self, share: float) -> float:
        """Return the value below which this share of all values lies.

        Args:
            share: 0 to 1.
        """
        match self.distribution:
            case "uniform":
                value = self._between(share)
            case "triangular":
                value = self._triangular(share)
            case "normal":
                value = self.mean + self.deviation * self._standard(share)
            case "lognormal":
                value = self.mean * math.exp(self.deviation * self._standard(share))
        value = float(f"{value:.{_DIGITS}g}")
        return min(max(value, self.low), self.high)

    def _between(self, share: float) -> float:
        if self.log:
            return self.low * math.pow(self.high / self.low, share)
        return self.low + share * (self.high - self.low)

    def _triangular(self, share: float) -> float:
        width, left = self.high - self.low, self.mean - self.low
        if share * width <= left:
            return self.low + math.sqrt(share * width * left)
        return self.high - math.sqrt((1.0 - share) * width * (self.high - self.mean))

    def _standard(self, share: float) -> float:
        """Return the quantile of the standard normal distribution, without the tails beyond `low` and `high`."""
        standard = NormalDist()
        first, last = (self._share_below(standard, end) for end in (self.low, self.high))
        inside = first + share * (last - first)
        return standard.inv_cdf(min(max(inside, _INSIDE), 1.0 - _INSIDE))

    def _share_below(self, standard: NormalDist, end: float) -> float:
        if math.isinf(end):
            return 0.0 if end < 0.0 else 1.0
        if self.distribution == "lognormal":
            if end <= 0.0:
                return 0.0
            return standard.cdf(math.log(end / self.mean) / self.deviation)
        return standard.cdf((end - self.mean) / self.deviation)

    def value(self, number: float) -> object:
        """Return a number of this range as a scenario's file has it: with its unit."""
        return f"{number!r} {self.unit}" if self.unit else number


def span_of(spec: FactorSpec) -> Span:
    """Return the range of a factor.

    Raises:
        InputError: a number is missing, is not a number, has another unit, or contradicts another one. The message
            begins with the name of the field.
    """
    distribution = spec.distribution or "uniform"
    log = spec.scale == "log"
    peaked = distribution != "uniform"
    needed = {"low", "high"} if distribution in ("uniform", "triangular") else {"mean", "deviation"}
    if distribution == "triangular":
        needed.add("mean")
    given = {field: getattr(spec, field) for field in ("low", "high", "mean", "deviation")}
    found: dict[str, Measure] = {}
    for field, value in given.items():
        if value is None:
            if field in needed:
                raise InputError(
                    f"{field}: is missing; a {distribution} distribution needs {', '.join(sorted(needed))}"
                )
            continue
        if field not in needed and not (peaked and field in ("low", "high")):
            raise InputError(f"{field}: a {distribution} distribution has no {field}")
        read = measure(value)
        if read is None:
            raise InputError(f"{field}: expected a number, or a text with a number and its unit, got {value!r}")
        found[field] = read
    plain = {"deviation"} if distribution == "lognormal" else set()
    units = {read.unit for field, read in found.items() if field not in plain}
    if len(units) > 1:
        got = ", ".join(sorted(unit or "none" for unit in units))
        raise InputError(f"low: low, high, mean and deviation need the same unit, got {got}")
    span = Span(
        distribution,
        found["low"].number if "low" in found else -math.inf,
        found["high"].number if "high" in found else math.inf,
        found["mean"].number if "mean" in found else 0.0,
        found["deviation"].number if "deviation" in found else 0.0,
        log,
        units.pop() if units else "",
    )
    _check(span)
    return span


def _check(span: Span) -> None:
    """Check that the numbers of a range do not contradict each other."""
    if not span.low < span.high:
        raise InputError(f"high: has to be greater than low, {span.low:g}, got {span.high:g}")
    if span.log and span.distribution != "uniform":
        raise InputError(
            "scale: a distribution has no scale; the lognormal distribution is the normal one of logarithms"
        )
    if span.log and span.low <= 0.0:
        raise InputError(f"low: has to be above 0 on a logarithmic scale, got {span.low:g}")
    if span.distribution in ("normal", "lognormal") and span.deviation <= 0.0:
        raise InputError(f"deviation: has to be above 0, got {span.deviation:g}")
    if span.distribution == "lognormal" and span.mean <= 0.0:
        raise InputError(f"mean: the median of a lognormal distribution has to be above 0, got {span.mean:g}")
    if span.distribution == "triangular" and not span.low <= span.mean <= span.high:
        raise InputError(f"mean: has to be between low, {span.low:g}, and high, {span.high:g}, got {span.mean:g}")
