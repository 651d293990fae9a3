"""Metrics and task of a run of a study, step by step."""

from __future__ import annotations

from aftdeck.report.lamps import lit_lamps
from aftdeck.report.metric import Metric, Value
from aftdeck.report.run_metrics import RunMetrics
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.task.progress import Progress


class Watch:
    """Metrics and task of a run, step by step."""

    def __init__(self, scenario: Scenario, shown: tuple[tuple[str, ...], ...]) -> None:
        self._scenario = scenario
        self._metrics = RunMetrics(scenario)
        self._metrics.shown(shown)
        self._progress = Progress(scenario) if scenario.steps else None

    def see(self, frame: Frame) -> None:
        """Add the next frame."""
        self._metrics.see(frame, lit_lamps(self._scenario, frame))
        if self._progress is not None:
            self._progress.see(frame)

    def found(self) -> dict[Metric, Value]:
        """Return the metrics."""
        return self._metrics.found()

    @property
    def steps_done(self) -> float | None:
        """Share of the task's steps that were completed; None if the scenario has no steps."""
        if self._progress is None:
            return None
        return sum(time_s is not None for time_s in self._progress.done_s) / len(self._progress.done_s)
