"""Limit on the rate of events."""

from __future__ import annotations

import time
from collections.abc import Callable


class Allowance:
    """Number of events that are allowed: `most` at once, and `rate` per second over a long time."""

    def __init__(self, rate: float, most: float, clock: Callable[[], float] = time.monotonic) -> None:
        """Allow `most` events at first.

        Args:
            rate: events allowed per second, over a long time.
            most: events allowed at once, after a pause.
            clock: function that returns the time [s].
        """
        self._rate, self._most, self._clock = rate, most, clock
        self._left, self._at = most, clock()

    def take(self) -> bool:
        """Count one event, and return whether it is allowed; an event that is not allowed is not counted."""
        self._refill()
        if self._left < 1.0:
            return False
        self._left -= 1.0
        return True

    def turn(self, longest: float) -> float:
        """Count one event, and return the time after which it is allowed [s], at most `longest`."""
        self._refill()
        self._left = max(self._left - 1.0, -longest * self._rate)
        return max(0.0, -self._left / self._rate)

    def _refill(self) -> None:
        now = self._clock()
        self._left = min(self._most, self._left + (now - self._at) * self._rate)
        self._at = now
