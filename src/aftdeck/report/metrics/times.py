"""Times of a run: in total, and of work and rest."""

from __future__ import annotations

from collections.abc import Iterator

from aftdeck.report.metric import Found, Metric, Value
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.readings.source import PONTILLO
from aftdeck.task.reached import at_rest, sticks_released

RUN = Metric("run_time", "Run time", "time", "Simulated time of the run.", PONTILLO)
PREPARATION = Metric(
    "preparation_time",
    "Preparation time",
    "time",
    "Time until the first command that moves the arm: a deflected stick, or an automatic motion.",
    PONTILLO,
)
IDLE = Metric(
    "idle_time",
    "Idle time",
    "time",
    "After the first command: time in which the arm is at rest, without a deflected stick, an automatic motion or a "
    "moving mechanism.",
)
METRICS = (RUN, PREPARATION, IDLE)


class Times:
    """Times of a run."""

    def __init__(self, period_s: float) -> None:
        self._period_s = period_s
        self._steps = self._idle = 0
        self._first: int | None = None

    def see(self, frame: Frame, before: Frame | None) -> None:
        """Add the next frame."""
        self._steps += 1
        commanded = frame.sequence == "in progress" or not sticks_released(frame)
        if self._first is None:
            if commanded:
                self._first = self._steps
        elif not commanded and not frame.motions and at_rest(frame):
            self._idle += 1

    def found(self) -> Iterator[Found]:
        """Yield all times; preparation and idle time only if the arm was commanded."""
        yield RUN, Value(self._steps * self._period_s)
        if self._first is not None:
            yield PREPARATION, Value((self._first - 1) * self._period_s)
            yield IDLE, Value(self._idle * self._period_s)
