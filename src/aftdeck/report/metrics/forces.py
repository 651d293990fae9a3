"""Forces, on plants with masses."""

from __future__ import annotations

import math
from collections.abc import Iterator

from aftdeck.report.metric import Found, Metric, Value
from aftdeck.simulation.frame import Frame

PEAK = Metric("peak_contact_force", "Peak contact force", "force", "Greatest force between two parts in contact.")
IMPULSE = Metric(
    "contact_impulse",
    "Contact impulse",
    "impulse",
    "Sum over all contacts and control steps of mean force times duration.",
)
HOLDING = Metric(
    "peak_holding_force",
    "Peak holding force",
    "force",
    "Greatest force with which the end effector or a berth held a payload.",
)
METRICS = (PEAK, IMPULSE, HOLDING)


class Forces:
    """Forces of a run."""

    def __init__(self, period_s: float) -> None:
        self._period_s = period_s
        self._known = False
        self._peak = self._impulse = self._holding = 0.0

    def see(self, frame: Frame, before: Frame | None) -> None:
        """Add the next frame."""
        dynamics = frame.dynamics
        if dynamics is None:
            return
        self._known = True
        for contact in dynamics.contacts:
            self._peak = max(self._peak, contact.peak)
            self._impulse += math.hypot(*contact.force) * self._period_s
        for hold in dynamics.holds:
            self._holding = max(self._holding, hold.peak)

    def found(self) -> Iterator[Found]:
        """Yield all metrics, on a plant with masses."""
        if self._known:
            yield PEAK, Value(self._peak)
            yield IMPULSE, Value(self._impulse)
            yield HOLDING, Value(self._holding)
