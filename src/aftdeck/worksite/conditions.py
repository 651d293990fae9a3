"""Conditions that have to hold before a payload is captured, docked or latched, and their margins.

Each condition compares a measured value with bounds; a value equal to a bound is allowed. The text of a condition is
for the operator, in the operator's units.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterable
from typing import Annotated, Literal, NamedTuple

import msgspec

from aftdeck.field_meta import field_meta
from aftdeck.units import FOOT, INCH

Unit = Literal["m", "rad", "m/s", "rad/s", "s", ""]
Units = Literal["ft-in", "SI"]
"""The operator's units, as an arm's file names them."""

_INCHES_BELOW, _MILLIMETRES_BELOW = 2.0 * FOOT, 1.0
"""Lengths under these [m] are shown in the smaller unit."""
_FIGURES, _MOST_FIGURES = 3, 9
_LIKE = 0.02
"""Share of the limit [1]: a value beyond it by less than this share plus `_TINY` could have the same text.

Such a value is shown with as many figures as distinguish it from the limit.
"""
_TINY = 1e-4
_MOST_DECIMALS = 3
"""Decimals shown of a number smaller than `_SMALLEST`, when the usual number of figures is asked for."""
_SMALLEST, _GREATEST = 1e-3, 999.5
"""Range of numbers that are written to significant figures: their text is short and Python adds no exponent."""


class Condition(msgspec.Struct, frozen=True, gc=False):
    """One condition with its measured value, its limit and its margin."""

    name: Annotated[str, field_meta("name of the condition: `palm height`")]
    holds: Annotated[bool, field_meta("whether it holds")]
    value: Annotated[float, field_meta("measured value, in `unit`", decimals=5)]
    limit: Annotated[
        float,
        field_meta(
            "bound that it is compared with, in `unit`: the nearer of two, or the one that is exceeded", decimals=5
        ),
    ]
    unit: Annotated[Unit, field_meta("unit of value, limit and margin; empty for a count")]
    margin: Annotated[float, field_meta("margin, in `unit`; negative if the condition fails", decimals=5)]
    text: Annotated[str, field_meta("text for the operator: `palm 2.5 in above the bar, 0 to 0.75 in allowed`")]
    words: Annotated[str, field_meta("text with `{}` in place of each number; empty in a recording without it")] = ""
    numbers: Annotated[tuple[float, ...], field_meta("numbers of the text, in `unit`", decimals=5)] = ()


def within(
    name: str,
    value: float,
    least: float,
    greatest: float,
    unit: Unit,
    units: Units,
    templates: tuple[str, str],
) -> Condition:
    """Return the condition least <= value <= greatest; one of the bounds may be infinite, but not both.

    Args:
        name: name of the condition.
        value: measured value; with NaN the condition fails.
        least: lower bound.
        greatest: upper bound.
        unit: unit of the value and the bounds.
        units: the operator's units.
        templates: two text templates for the value, with braces for its size: the first for a value of 0 or more, the
            second for a negative value.
    """
    below, above = value - least, greatest - value
    margin, limit = (below, least) if below < above else (above, greatest)
    holds = margin >= 0.0
    size = quantity_text(abs(value), unit, units)
    if not holds and abs(margin) < _LIKE * abs(limit) + _TINY:
        size = _distinct_text(abs(value), abs(limit), unit, units)
    measured, allowed = templates[value < 0.0], _allowed(least, greatest, unit, units, holds)
    text, words = measured.format(size) + allowed.text, measured + allowed.words
    numbers = (abs(value), *allowed.numbers) if "{}" in measured else allowed.numbers
    return Condition(name, holds, value, limit, unit, margin, text, words, numbers)


def all_hold(conditions: Iterable[Condition]) -> bool:
    """Return whether all conditions hold."""
    return all(condition.holds for condition in conditions)


def failing(conditions: Iterable[Condition]) -> tuple[Condition, ...]:
    """Return the conditions that fail."""
    return tuple(condition for condition in conditions if not condition.holds)


def failure_text(conditions: Iterable[Condition]) -> str:
    """Return the texts of all failed conditions, joined by "; "; empty if all hold."""
    return "; ".join(condition.text for condition in failing(conditions))


def rejection_text(what: str, conditions: Iterable[Condition]) -> str:
    """Return the text that rejects a command because of failed conditions; empty if all hold.

    For example ``CAPTURE refused: palm 2.5 in above the bar, 0 to 0.75 in allowed; ...``.
    """
    why = failure_text(conditions)
    return f"{what} refused: {why}" if why else ""


def tightest(conditions: Iterable[Condition], unit: Unit) -> Condition | None:
    """Return the condition with the least margin among those measured in a unit; None if there are none."""
    return min((c for c in conditions if c.unit == unit), key=lambda c: c.margin, default=None)


def quantity_text(value: float, unit: Unit, units: Units, figures: int = _FIGURES) -> str:
    """Return the text of a value [unit] in the operator's units.

    Examples:
        >>> [quantity_text(0.0635, "m", units) for units in ("ft-in", "SI")], quantity_text(0.02, "rad", "SI")
        (['2.5 in', '63.5 mm'], '1.15°')
    """
    per, suffix = _scale(abs(value), unit, units)
    return _digits(value * per, figures) + suffix


def _distinct_text(value: float, limit: float, unit: Unit, units: Units) -> str:
    """Return the text of a value with as many figures as distinguish it from a limit.

    Otherwise a text such as "0.75 in above, 0 to 0.75 in allowed" could result.
    """
    for figures in range(_FIGURES, _MOST_FIGURES):
        if (text := quantity_text(value, unit, units, figures)) != quantity_text(limit, unit, units, figures):
            return text
    return quantity_text(value, unit, units, _MOST_FIGURES)


def _scale(size: float, unit: Unit, units: Units) -> tuple[float, str]:
    """Return the factor from a unit to the operator's unit, for a value of that size, and the suffix of that unit."""
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
    """Return the text of a number to so many significant figures, without an exponent and without trailing zeros."""
    if _SMALLEST <= abs(value) < _GREATEST:
        text = f"{value:.{figures}g}"
    else:
        text = f"{value:.{_MOST_DECIMALS + figures - _FIGURES if abs(value) < 1.0 else 0}f}"
        if "." in text:
            text = text.rstrip("0").rstrip(".")
    if text[0] == "-":
        text = "0" if text == "-0" else "−" + text[1:]
    return text


class _Allowed(NamedTuple):
    """Second half of a condition's text: the allowed range.

    Attributes:
        text: the text.
        words: the text with `{}` in place of each number.
        numbers: those numbers.
    """

    text: str
    words: str
    numbers: tuple[float, ...]


@functools.lru_cache(maxsize=256)
def _allowed(least: float, greatest: float, unit: Unit, units: Units, holds: bool) -> _Allowed:
    """Return the allowed range; without text if only a negative value is not allowed and the condition holds."""
    if least == 0.0 and greatest == math.inf:
        text = "" if holds else ", none allowed"
        return _Allowed(text, text, ())
    if least in (-math.inf, -greatest):
        words, bound = ", at most {} allowed", greatest
    elif greatest == math.inf:
        words, bound = ", at least {} allowed", least
    else:
        words = ", {} to {} allowed"
        per, suffix = _scale(max(abs(least), abs(greatest)), unit, units)
        text = words.format(_digits(least * per, _FIGURES), _digits(greatest * per, _FIGURES) + suffix)
        return _Allowed(text, words, (least, greatest))
    return _Allowed(words.format(quantity_text(bound, unit, units)), words, (bound,))
