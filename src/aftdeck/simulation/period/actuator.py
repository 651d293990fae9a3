"""Linear actuator in a control period: the telescope and the prong (`plant.linear_actuator`)."""

from __future__ import annotations

from aftdeck.law import law


@law
def after(position: float, drive: float, low: float, high: float, rate: float, period: float) -> float:
    """Return the position of a linear actuator after a control period: drive times `rate`, from `low` to `high` [m]."""
    return min(max(position + drive * rate * period, low), high)
