"""The operator's task in one run of a session: progress, faults, and the result when all steps are past."""

from __future__ import annotations

from aftdeck.recording.delays import Delays
from aftdeck.report.grade import faults, grade
from aftdeck.report.lamps import Lamp
from aftdeck.report.run_metrics import RunMetrics
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.station.conversion.measures_of import RESULT, measures_of
from aftdeck.station.core.step import Step
from aftdeck.station.messages.frame import Debrief
from aftdeck.task.progress import Progress


class TaskRun:
    """The task of one run.

    Attributes:
        progress: progress through the steps.
        debrief: result of the run; None until all steps are past.
    """

    def __init__(self, scenario: Scenario) -> None:
        self._scenario = scenario
        self.progress = Progress(scenario)
        self._metrics = RunMetrics(scenario, self.progress)
        self._uncounted: tuple[Frame, tuple[Lamp, ...]] | None = None
        self._begin()

    def _begin(self) -> None:
        self.debrief: Debrief | None = None
        self._flown_by: str | None = None

    def see(self, step: Step) -> None:
        """Add a step; note the steps of the task that it completes, and put the task's result into it."""
        for i in self.add(step.frame, step.lamps, step.autopilot, step.delays):
            text = f"step {i + 1} of {len(self._scenario.steps)} done: {self._scenario.steps[i].title}"
            step.note("task", text)
        step.debrief = self.debrief

    def add(
        self, frame: Frame, lamps: tuple[Lamp, ...], autopilot: str | None = None, delays: Delays | None = None
    ) -> tuple[int, ...]:
        """Add the next frame and its lamps; return the indices of the steps that it completes.

        `delays` are those of the run's control steps, from which the result tells the time that was lost; None if they
        are not known.
        `autopilot` is the autopilot that flies, if it is not the script.
        """
        self.settle()
        done = self.progress.see(frame)
        if not self.progress.steps:
            return done
        if any(event.kind == "initialise" for event in frame.events):
            self._begin()
        if self.progress.present is not None:
            self.debrief = None
        self._uncounted = frame, lamps
        if self.debrief is None:
            self._flown_by = "script" if frame.by == "script" else autopilot or self._flown_by
        if self.progress.present is None and self.debrief is None:
            self.settle()
            self.debrief = self._result(delays)
        return done

    def settle(self) -> None:
        """Count the last frame in the metrics, for which no page waits until the result."""
        if self._uncounted is not None:
            self._metrics.see(*self._uncounted)
            self._uncounted = None

    def _result(self, delays: Delays | None) -> Debrief:
        skipped, found = len(self.progress.skipped), self._metrics.found(delays)
        kinds = faults(found)
        others = [f"{skipped} step skipped" if skipped == 1 else f"{skipped} steps skipped"] if skipped else []
        others += [f"flown by the {self._flown_by}"] if self._flown_by else []
        return Debrief(None if others else grade(kinds), (*kinds, *others), measures_of(found, RESULT))
