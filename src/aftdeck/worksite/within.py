"""Measured values with the ranges that conditions allow, as laws compute them; `conditions` makes their texts."""

from __future__ import annotations

from aftdeck.law import law

Within = tuple[float, float, float]
"""A measured value, and the least and the greatest value that are allowed; one of them may be infinite."""


@law
def holds(value: float, least: float, greatest: float) -> bool:
    """Return whether a value is in its range; with NaN it is not."""
    return min(value - least, greatest - value) >= 0.0


@law
def number_that_hold(values: tuple[Within, ...]) -> int:
    """Return how many of the values are in their ranges."""
    number = 0
    for value, least, greatest in values:
        number += holds(value, least, greatest)
    return number
