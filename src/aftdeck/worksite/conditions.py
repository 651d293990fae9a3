"""Conditions for capture, docking and latching of a payload, with their margins.

Each condition compares a measured value with bounds; a value equal to a bound is allowed. A condition contains only
values; `condition_text` returns its text in the operator's units.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterable, Sequence
from itertools import zip_longest
from typing import Annotated, Literal, NamedTuple

import msgspec

from aftdeck.field_meta import field_meta
from aftdeck.units import FOOT, INCH

Unit = Literal["m", "rad", "m/s", "rad/s", "s", ""]
Units = Literal["ft-in", "SI"]
"""The operator's units, as an arm's file names them."""

_INCHES_BELOW, _MILLIMETRES_BELOW = 2.0 * FOOT, 1.0
"""Lengths below which the smaller unit is used [m]."""
_FIGURES, _MOST_FIGURES = 3, 9
_LIKE = 0.02
"""Share of the limit [1]. If a failing value differs from its limit by less than this share plus `_TINY`, both can have
the same text.

The text of the value then has as many significant figures as are needed to distinguish it from the limit.
"""
_TINY = 1e-4
_MOST_DECIMALS = 3
"""Number of decimals in the text of a number below `_SMALLEST`, for the usual `_FIGURES` significant figures."""
_ALLOWED = " allowed"
"""Last word of the text of an allowed range."""
_SMALLEST, _GREATEST = 1e-3, 999.5
"""Range of magnitudes for which Python's format ``g`` gives a short text without an exponent."""


class Condition(msgspec.Struct, frozen=True, gc=False):
    """One condition with its measured value, its limit and its margin."""

    name: Annotated[str, field_meta("name of the condition, such as `palm height`")]
    holds: Annotated[bool, field_meta("whether the condition holds")]
    value: Annotated[float, field_meta("measured value, in `unit`", decimals=5)]
    limit: Annotated[
        float,
        field_meta(
            "bound with which the value is compared, in `unit`: the nearer bound of two, or the exceeded bound",
            decimals=5,
        ),
    ]
    unit: Annotated[Unit, field_meta("unit of value, limit and margin; empty for a count")]
    margin: Annotated[float, field_meta("margin, in `unit`; negative if the condition fails", decimals=5)]
    words: Annotated[
        str,
        field_meta(
            "text for the operator with `{}` in place of each number: `palm {} above the bar, {} to {} allowed`"
        ),
    ]
    numbers: Annotated[tuple[float, ...], field_meta("numbers of the text, in `unit`", decimals=5)] = ()


def within(name: str, value: float, least: float, greatest: float, unit: Unit, templates: tuple[str, str]) -> Condition:
    """Return the condition least <= value <= greatest; one of the bounds may be infinite, but not both.

    Args:
        name: name of the condition.
        value: measured value; with NaN the condition fails.
        least: lower bound.
        greatest: upper bound.
        unit: unit of the value and the bounds.
        templates: two text templates, the first for a value of 0 or more, the second for a negative value. Each
            contains `{}` in place of the value's magnitude, or no `{}` if the text has no number.
    """
    below, above = value - least, greatest - value
    margin, limit = (below, least) if below < above else (above, greatest)
    holds = margin >= 0.0
    words, bounds, sized = _worded(templates[value < 0.0], least, greatest, holds)
    return Condition(name, holds, value, limit, unit, margin, words, (abs(value), *bounds) if sized else bounds)


def all_hold(conditions: Iterable[Condition]) -> bool:
    """Return whether all conditions hold."""
    return all(condition.holds for condition in conditions)


def all_ready(conditions: tuple[Condition, ...]) -> bool:
    """Return whether there are conditions and all hold."""
    return bool(conditions) and all_hold(conditions)


def failing(conditions: Iterable[Condition]) -> tuple[Condition, ...]:
    """Return the conditions that fail."""
    return tuple(condition for condition in conditions if not condition.holds)


def condition_text(condition: Condition, units: Units) -> str:
    """Return the text of a condition in the operator's units.

    For example ``palm 2.5 in above the bar, 0 to 0.75 in allowed``.
    """
    words = condition.words
    end = words.rfind(", ") if words.endswith(_ALLOWED) else len(words)
    sized = words[:end].count("{}")
    sizes = [_size_text(condition, size, units) for size in condition.numbers[:sized]]
    return _filled(words, sizes + _bound_texts(condition.numbers[sized:], condition.unit, units))


def failure_text(conditions: Iterable[Condition], units: Units) -> str:
    """Return the texts of all failed conditions, joined by "; "; empty if all hold."""
    return "; ".join(condition_text(condition, units) for condition in failing(conditions))


def rejection_text(what: str, conditions: Iterable[Condition], units: Units) -> str:
    """Return the text that rejects a command because of failed conditions; empty if all hold.

    For example ``CAPTURE refused: palm 2.5 in above the bar, 0 to 0.75 in allowed; ...``.
    """
    why = failure_text(conditions, units)
    return f"{what} refused: {why}" if why else ""


def tightest(conditions: Iterable[Condition], unit: Unit) -> Condition | None:
    """Return the condition with the least margin among the conditions with this unit; None if there is none."""
    return min((c for c in conditions if c.unit == unit), key=lambda c: c.margin, default=None)


def quantity_text(value: float, unit: Unit, units: Units, figures: int = _FIGURES) -> str:
    """Return the text of a value [unit] in the operator's units.

    Examples:
        >>> [quantity_text(0.0635, "m", units) for units in ("ft-in", "SI")], quantity_text(0.02, "rad", "SI")
        (['2.5 in', '63.5 mm'], '1.15°')
    """
    per, suffix = _scale(abs(value), unit, units)
    return _digits(value * per, figures) + suffix


def _size_text(condition: Condition, value: float, units: Units) -> str:
    """Return the text of the magnitude of a condition's measured value.

    It has more figures than usual if the text of a failing value would otherwise equal that of the limit.
    """
    limit = abs(condition.limit)
    if not condition.holds and abs(condition.margin) < _LIKE * limit + _TINY:
        return _distinct_text(value, limit, condition.unit, units)
    return quantity_text(value, condition.unit, units)


def _bound_texts(bounds: tuple[float, ...], unit: Unit, units: Units) -> list[str]:
    """Return the texts of the bounds of a range. All bounds have the same unit; only the last text contains it."""
    per, suffix = _scale(max(map(abs, bounds), default=0.0), unit, units)
    texts = [_digits(bound * per, _FIGURES) for bound in bounds]
    return [*texts[:-1], *(text + suffix for text in texts[-1:])]


def _filled(words: str, texts: Sequence[str]) -> str:
    """Return `words` with each `{}` replaced by one of `texts`, in order."""
    parts = words.split("{}")
    return "".join(part + text for part, text in zip_longest(parts, texts, fillvalue=""))


def _distinct_text(value: float, limit: float, unit: Unit, units: Units) -> str:
    """Return the text of a value, with as many significant figures as are needed to distinguish it from a limit.

    With fewer figures, a text such as "0.75 in above, 0 to 0.75 in allowed" could result.
    """
    for figures in range(_FIGURES, _MOST_FIGURES):
        if (text := quantity_text(value, unit, units, figures)) != quantity_text(limit, unit, units, figures):
            return text
    return quantity_text(value, unit, units, _MOST_FIGURES)


def _scale(size: float, unit: Unit, units: Units) -> tuple[float, str]:
    """Return the factor from a unit to the operator's unit, and the suffix of the operator's unit.

    The operator's unit of a length depends on `size`, the magnitude to write [unit].
    """
    feet = units == "ft-in"
    match unit:
        case "m" if feet:
            return (1.0 / INCH, " in") if size < _INCHES_BELOW else (1.0 / FOOT, " ft")
        case "m":
            return (1e3, " mm") if size < _MILLIMETRES_BELOW else (1.0, " m")
        case "rad":
            return math.degrees(1.0), "°"
        case "rad/s":
            return math.degrees(1.0), "°/s"
        case "m/s":
            return (1.0 / FOOT, " ft/s") if feet else (1.0, " m/s")
        case "s":
            return 1.0, " s"
        case "":
            return 1.0, ""


def _digits(value: float, figures: int) -> str:
    """Return the text of a number to `figures` significant figures, without an exponent and without trailing zeros."""
    if _SMALLEST <= abs(value) < _GREATEST:
        text = f"{value:.{figures}g}"
    else:
        text = f"{value:.{_MOST_DECIMALS + figures - _FIGURES if abs(value) < 1.0 else 0}f}"
        if "." in text:
            text = text.rstrip("0").rstrip(".")
    if text[0] == "-":
        text = "0" if text == "-0" else "−" + text[1:]
    return text


class _Worded(NamedTuple):
    """Text of a condition, with numbers to insert.

    Attributes:
        words: the text with `{}` in place of each number.
        bounds: numbers of the allowed range, in the second half of the text.
        sized: whether the first number of the text is the magnitude of the measured value.
    """

    words: str
    bounds: tuple[float, ...]
    sized: bool


@functools.lru_cache(maxsize=1024)
def _worded(measured: str, least: float, greatest: float, holds: bool) -> _Worded:
    """Return a condition's words. If all values of 0 or more are allowed, a condition that holds states no range."""
    sized = "{}" in measured
    if least == 0.0 and greatest == math.inf:
        return _Worded(measured if holds else f"{measured}, none{_ALLOWED}", (), sized)
    if least in (-math.inf, -greatest):
        return _Worded(f"{measured}, at most {{}}{_ALLOWED}", (greatest,), sized)
    if greatest == math.inf:
        return _Worded(f"{measured}, at least {{}}{_ALLOWED}", (least,), sized)
    return _Worded(f"{measured}, {{}} to {{}}{_ALLOWED}", (least, greatest), sized)
