"""Values of metrics as texts, and axes of charts: SI units, angles in degrees, shares in per cent."""

from __future__ import annotations

import math

from aftdeck.report.metric import Metric
from aftdeck.simulation.readings.quantity import UNITS, Quantity

_ANGLES = ("angle", "turn rate")


def text_of(metric: Metric, value: str | float | None) -> str:
    """Return a value with its unit; "-" for no value."""
    if value is None:
        return "-"
    if isinstance(value, str):
        return value
    if metric.quantity == "count":
        return f"{value:.0f}" if float(value).is_integer() else f"{value:.1f}"
    unit, factor = axis_of(metric.quantity)
    decimals = {"share": 0, "time": 1, "angle": 2, "turn rate": 2}.get(metric.quantity, 3)
    return f"{value * factor:.{decimals}f} {unit}".rstrip()


def axis_of(quantity: Quantity) -> tuple[str, float]:
    """Return the unit of a chart's axis, and the factor from SI to it."""
    if quantity == "share":
        return "%", 100.0
    if quantity in _ANGLES:
        return UNITS[quantity].replace("rad", "deg"), math.degrees(1.0)
    return UNITS[quantity], 1.0
