"""Conditions: what has to hold before something is captured, docked or latched, and by how much it does.

Each is measured against bounds that count as inside. Its text is for the operator, in the operator's units.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterable
from typing import Annotated, Literal

import msgspec

from aftdeck.told import told
from aftdeck.units import FOOT, INCH

Unit = Literal["m", "rad", "m/s", "rad/s", "s", ""]
Units = Literal["ft-in", "SI"]
"""The operator's units, as an arm's file names them."""

_INCHES_BELOW, _MILLIMETRES_BELOW = 2.0 * FOOT, 1.0
"""Lengths under these [m] are shown in the smaller unit."""
_FIGURES, _MOST_FIGURES = 3, 9
_LIKE = 0.02
"""Values nearer to their limit than this share of it, or than `_TINY`, may look like it."""
_TINY = 1e-4
_MOST_DECIMALS = 3
"""Of what is smaller than `_SMALLEST`, shown with no more than the usual figures."""
_SMALLEST, _GREATEST = 1e-3, 999.5
"""Numbers between these are short when written to some figures; neither has Python an exponent for them."""


class Condition(msgspec.Struct, frozen=True, gc=False):
    """One condition as it stands."""

    name: Annotated[str, told("which: `palm height`")]
    holds: Annotated[bool, told("whether it holds")]
    value: Annotated[float, told("what is measured, in `unit`", decimals=5)]
    limit: Annotated[
        float, told("what it is held against, in `unit`: the nearer of two bounds, or the one passed", decimals=5)
    ]
    unit: Annotated[Unit, told("m, rad, m/s, or empty")]
    margin: Annotated[float, told("by how much it holds, or fails where negative, in `unit`", decimals=5)]
    text: Annotated[str, told("for people: `palm 2.5 in above the bar, 0 to 0.75 in allowed`")]


def within(
    name: str,
    value: float,
    least: float,
    greatest: float,
    unit: Unit,
    units: Units,
    says: tuple[str, str],
) -> Condition:
    """The condition least <= value <= greatest; either bound may be infinite, not both.

    Args:
        name: what it is called.
        value: measured; NaN holds nowhere.
        least: what is allowed, from here
        greatest: to here.
        unit: of these three.
        units: the operator's.
        says: how the value is told, a pair of braces for its size: where it is positive or 0, and where negative.
    """
    below, above = value - least, greatest - value
    margin, limit = (below, least) if below < above else (above, greatest)
    holds = margin >= 0.0
    size = shown(abs(value), unit, units)
    if not holds and abs(margin) < _LIKE * abs(limit) + _TINY:
        size = _told_apart(abs(value), abs(limit), unit, units)
    text = says[value < 0.0].format(size)
    if allowed := _allowed(least, greatest, unit, units, holds):
        text = f"{text}, {allowed} allowed"
    return Condition(name, holds, value, limit, unit, margin, text)


def all_hold(conditions: Iterable[Condition]) -> bool:
    """Whether every one of them holds."""
    return all(condition.holds for condition in conditions)


def failing(conditions: Iterable[Condition]) -> tuple[Condition, ...]:
    """Those that do not hold."""
    return tuple(condition for condition in conditions if not condition.holds)


def reasons(conditions: Iterable[Condition]) -> str:
    """What each of those says that do not hold; empty where all hold."""
    return "; ".join(condition.text for condition in failing(conditions))


def refusal(what: str, conditions: Iterable[Condition]) -> str:
    """``CAPTURE refused: palm 2.5 in above the bar, 0 to 0.75 in allowed; ...``; empty where all hold."""
    why = reasons(conditions)
    return f"{what} refused: {why}" if why else ""


def tightest(conditions: Iterable[Condition], unit: Unit) -> Condition | None:
    """The condition with the least margin of those measured in a unit; None where there are none."""
    return min((c for c in conditions if c.unit == unit), key=lambda c: c.margin, default=None)


def shown(value: float, unit: Unit, units: Units, figures: int = _FIGURES) -> str:
    """A value [unit] in the operator's units.

    Examples:
        >>> shown(0.0635, "m", "ft-in"), shown(0.0635, "m", "SI"), shown(3.81, "m", "ft-in"), shown(0.02, "rad", "SI")
        ('2.5 in', '63.5 mm', '12.5 ft', '1.15°')
    """
    per, suffix = _scale(abs(value), unit, units)
    return _digits(value * per, figures) + suffix


def _told_apart(value: float, limit: float, unit: Unit, units: Units) -> str:
    """A value to as many figures as tell it from a limit: "0.75 in above, 0 to 0.75 in allowed" would say nothing."""
    for figures in range(_FIGURES, _MOST_FIGURES):
        if (text := shown(value, unit, units, figures)) != shown(limit, unit, units, figures):
            return text
    return shown(value, unit, units, _MOST_FIGURES)


def _scale(size: float, unit: Unit, units: Units) -> tuple[float, str]:
    """What one of a unit is in the operator's, for a value of that size, and how this is written."""
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
    """A number to so many significant figures, without an exponent and without zeros at its end."""
    if _SMALLEST <= abs(value) < _GREATEST:
        text = f"{value:.{figures}g}"
    else:
        text = f"{value:.{_MOST_DECIMALS + figures - _FIGURES if abs(value) < 1.0 else 0}f}"
        if "." in text:
            text = text.rstrip("0").rstrip(".")
    if text[0] == "-":
        text = "0" if text == "-0" else "−" + text[1:]
    return text


@functools.lru_cache(maxsize=256)
def _allowed(least: float, greatest: float, unit: Unit, units: Units, holds: bool) -> str:
    """What is allowed, for people; of what may only not be negative, nothing while it holds."""
    if least == 0.0 and greatest == math.inf:
        return "" if holds else "none"
    if least in (-math.inf, -greatest):
        return f"at most {shown(greatest, unit, units)}"
    if greatest == math.inf:
        return f"at least {shown(least, unit, units)}"
    per, suffix = _scale(max(abs(least), abs(greatest)), unit, units)
    return f"{_digits(least * per, _FIGURES)} to {_digits(greatest * per, _FIGURES)}{suffix}"
