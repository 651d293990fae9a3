"""Times of a run: in total, by task phase, and of work and rest."""

from __future__ import annotations

from collections.abc import Iterator

from aftdeck.report.metric import PONTILLO, Found, Metric, Value
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.payloads.task_phases import TASKS
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
MANUAL = Metric("manual_share", "Manual share", "share", "Share of the run's time with manual inputs.")
VERNIER = Metric("vernier_time", "Time in vernier", "time", "Time with the rate setting vernier.")
PHASES = {
    task: Metric(
        f"{name}_time",
        f"Time of {name}",
        "time",
        f"Time in task phase {task}: {name}.",
        "Remote Manipulator Simulation, final report",
    )
    for task, name in TASKS.items()
}
"""Time in each task phase."""
METRICS = (RUN, PREPARATION, IDLE, MANUAL, VERNIER, *PHASES.values())


class Times:
    """Times of a run."""

    def __init__(self, period_s: float) -> None:
        self._period_s = period_s
        self._steps = self._manual = self._vernier = self._idle = 0
        self._first: int | None = None
        self._tasks = dict.fromkeys(TASKS, 0)
        self._payloads = False

    def see(self, frame: Frame, before: Frame | None) -> None:
        """Add the next frame."""
        self._steps += 1
        self._manual += frame.by == "hand"
        self._vernier += frame.rate == "vernier"
        self._tasks[frame.work.task] += 1
        self._payloads = bool(frame.work.cargo)
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
        yield MANUAL, Value(self._manual / max(self._steps, 1))
        yield VERNIER, Value(self._vernier * self._period_s)
        if self._payloads:
            for task, steps in self._tasks.items():
                yield PHASES[task], Value(steps * self._period_s)
