"""Figures as text for people: rounded, in aligned columns."""

from __future__ import annotations

import math

from benchmarks.measure import Figure

NAME, VALUE, UNIT, TARGET = 52, 9, 5, 15
"""Widths of the columns. A longer text moves the rest of its line."""
FAMILIAR = {"us": "µs", "1": "", "ratio": ""}
"""Units that are printed in another way."""


def number(value: float) -> str:
    """Return a number with three digits, as a person would write it: no exponent, and groups of thousands.

    A whole number has no decimals and all its digits.

    >>> [number(value) for value in (5, 0.014, 3.28513, 28.53, 99.96, 1204.4, 0.00012345)]
    ['5', '0.0140', '3.29', '28.5', '100', '1,204', '0.000123']
    """
    if value == math.floor(value):
        return f"{value:,.0f}"
    rounded = float(f"{value:.3g}")  # 99.96 becomes 100, which has no decimals
    decimals = 2 - math.floor(math.log10(abs(rounded)))
    return f"{value:,.{max(0, decimals)}f}"


def limit(value: float) -> str:
    """Return a target with at most three digits and without zeros at its end.

    >>> [limit(value) for value in (0.3, 30.0, 1.5, 1000.0)]
    ['0.3', '30', '1.5', '1,000']
    """
    text = number(value)
    return text.rstrip("0").rstrip(".") if "." in text else text


def value_text(figure: Figure) -> str:
    """Return a figure's value as text."""
    return "–" if figure.value is None else number(figure.value)


def unit_text(unit: str) -> str:
    """Return a unit as it is printed."""
    return FAMILIAR.get(unit, unit)


def target_text(figure: Figure) -> str:
    """Return a figure's target as text; empty if it has none."""
    return "" if figure.target is None else f"≤ {limit(figure.target)}"


def note_text(figure: Figure) -> str:
    """Return the ratio of a figure to its peer, and its note."""
    if figure.ratio is None or figure.share is None:
        return figure.note
    ratio = f"{limit(figure.ratio)} of “{figure.peer}”, at most {limit(figure.share)}"
    return f"{ratio}; {figure.note}" if figure.note else ratio


def line(figure: Figure, *, judged: bool = True) -> str:
    """Return one line of the table: name, value, unit, target, and the note.

    Args:
        figure: the figure.
        judged: True if a missed target is marked.
    """
    target = target_text(figure)
    if judged and not figure.kept:
        target = f"MISSED {target}"
    cells = (
        f"{figure.name:<{NAME}}",
        f"{value_text(figure):>{VALUE}} {unit_text(figure.unit):<{UNIT}}",
        f"{target:<{TARGET}}",
        note_text(figure),
    )
    return "  ".join(("", *cells)).rstrip()
