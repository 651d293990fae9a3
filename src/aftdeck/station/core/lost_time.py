"""Late steps of one run, and the lines of the log about lost time."""

from __future__ import annotations

import math

from aftdeck.recording.delays import Delays
from aftdeck.station.core.step import Delay

LOGGED_EVERY = 60.0
"""Least time from one line about lost time to the next [s]."""


class LostTime:
    """Late steps of one run.

    Attributes:
        delays: delays of the run's steps so far.
    """

    def __init__(self, period: float) -> None:
        """Begin a run with this control period [s]."""
        self.delays = Delays()
        self._period = period
        self._logged, self._log_from = 0.0, -math.inf

    def count(self, time_s: float, delay: Delay, *, commanded: bool) -> tuple[Delay | None, str]:
        """Count the delay of a step.

        Args:
            time_s: simulated time at which the step begins [s].
            delay: its delay.
            commanded: whether an input has been given before.

        Returns:
            The delay, None if it is not longer than a control period; and a line for the log, empty if there is none.
        """
        late = delay if delay.late_s > self._period else None
        if late is not None:
            self.delays = self.delays.after(time_s, *late, commanded=commanded)
        if not commanded:
            self._logged = self.delays.lost_s
        if self.delays.lost_s <= self._logged or time_s < self._log_from:
            return late, ""
        lost, self._logged = self.delays.lost_s - self._logged, self.delays.lost_s
        self._log_from = time_s + LOGGED_EVERY
        return late, f"the computer was too slow: {lost:.2f} s lost ({self.delays.lost_s:.2f} s in this run)"
