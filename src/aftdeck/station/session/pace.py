"""Times at which the control steps of a run are due, and the time that is lost."""

from __future__ import annotations

from collections.abc import Callable

from aftdeck.station.core.step import Delay

MAX_CATCH_UP = 0.25
"""Largest delay that is made up [s]; a larger delay postpones all following steps and is thereby lost."""


class Pace:
    """Pace of a run in real time: one step is due in each control period."""

    def __init__(self, period: float, clock: Callable[[], float]) -> None:
        """Let the first step be due now.

        Args:
            period: control period [s].
            clock: function that returns the time [s].
        """
        self._period, self._clock = period, clock
        self.begin()

    def begin(self) -> None:
        """Let the next step be due now; what was before is no delay."""
        self._due = self._clock()

    def step(self) -> Delay:
        """Return the delay of the step that begins now."""
        late = max(0.0, self._clock() - self._due)
        lost = late if late > MAX_CATCH_UP else 0.0
        self._due += self._period + lost
        return Delay(late, lost)

    @property
    def late(self) -> float:
        """Time since the next step was due [s]; 0 or less if it is not due yet."""
        return self._clock() - self._due

    def wait(self) -> float:
        """Return the time until the next step is due [s]; 0 if it is late."""
        return max(0.0, self._due - self._clock())
