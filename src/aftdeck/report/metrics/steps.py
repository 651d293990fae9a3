"""Steps of the task that a run completes."""

from __future__ import annotations

from collections.abc import Iterator

from aftdeck.report.metric import Found, Metric, Value
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.task.progress import Progress

DONE = Metric("steps_done", "Steps done", "count", "Number of steps of the task that were completed.")
SHARE = Metric("steps_share", "Share of steps done", "share", "Completed steps, as a share of all steps.")
TASK = Metric(
    "task_time",
    "Task time",
    "time",
    "Time in which all steps of the task, or of its part after a re-initialisation, were completed.",
)
LONGEST = Metric(
    "longest_step_time",
    "Longest step",
    "time",
    "Longest time between the completions of two steps of the task, or from the start to the first.",
)
METRICS = (DONE, SHARE, TASK, LONGEST)


class Steps:
    """Completed steps of a run.

    Args:
        scenario: the scenario.
        progress: progress that someone else updates by the same frames; None to compute it here.
    """

    def __init__(self, scenario: Scenario, progress: Progress | None) -> None:
        self._own = progress is None
        self._progress = Progress(scenario) if progress is None else progress
        self._period_s = scenario.control_period
        self._began_s: float | None = None

    def see(self, frame: Frame, before: Frame | None) -> None:
        """Add the next frame."""
        if self._began_s is None:
            self._began_s = frame.time_s - self._period_s
        if self._own and self._progress.steps:
            self._progress.see(frame)

    def look(self) -> None:
        """Note that the operator has put another camera on a monitor."""
        if self._own and self._began_s is not None:
            self._progress.look()

    def found(self) -> Iterator[Found]:
        """Yield the metrics, if the scenario has steps."""
        steps, done_s = self._progress.steps, self._progress.done_s
        if not steps:
            return
        began_s = self._began_s or 0.0
        done = [
            (time_s - began_s, step.title) for time_s, step in zip(done_s, steps, strict=True) if time_s is not None
        ]
        yield DONE, Value(len(done))
        yield SHARE, Value(len(done) / len(steps))
        if self._progress.present is None and len(done) == len(steps) - self._progress.first:
            yield TASK, Value(done[-1][0])
        if done:
            began = [0.0, *(time_s for time_s, _ in done)]
            longest, title = max((time_s - before, title) for (time_s, title), before in zip(done, began, strict=False))
            yield LONGEST, Value(longest, detail=title)
