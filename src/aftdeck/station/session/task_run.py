"""The operator's task in one run of a session: progress, faults, and the result when all steps are past."""

from __future__ import annotations

from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.station.lamps import Lamp
from aftdeck.station.messages.frame import Debrief
from aftdeck.station.playback.measures import (
    ALARMS_RAISED,
    CAPTURE_MISALIGNMENT,
    RUN_TIME,
    SMALLEST_CLEARANCE,
    TIP_PATH,
    RunMetrics,
)
from aftdeck.task.grade import Faults, grade
from aftdeck.task.progress import Progress

_SHOWN = (RUN_TIME, CAPTURE_MISALIGNMENT, SMALLEST_CLEARANCE, ALARMS_RAISED, TIP_PATH)
"""Names of the figures in the result."""


class TaskRun:
    """The task of one run.

    Attributes:
        progress: progress through the steps.
        debrief: result of the run; None until all steps are past.
    """

    def __init__(self, scenario: Scenario) -> None:
        self.progress = Progress(scenario)
        self._period_s = scenario.control_period
        self._begin()

    def _begin(self) -> None:
        self.debrief: Debrief | None = None
        self._faults, self._metrics, self._scripted = Faults(), RunMetrics(self._period_s), False

    def see(self, frame: Frame, lamps: tuple[Lamp, ...]) -> tuple[int, ...]:
        """Add the next frame and its lamps; return the indices of the steps that it completes."""
        done = self.progress.see(frame)
        if not self.progress.steps:
            return done
        if any(event.kind == "initialise" for event in frame.events):
            self._begin()
        if self.progress.present is not None:
            self.debrief = None
        if self.debrief is None:
            self._faults.see(frame)
            self._scripted = self._scripted or frame.by == "script"
            self._metrics.add(frame, lamps)
        if self.progress.present is None and self.debrief is None:
            self.debrief = self._result()
        return done

    def _result(self) -> Debrief:
        skipped, faults = len(self.progress.skipped), self._faults.texts()
        figures = [figure for figure in self._metrics.measures("completed") if figure.name in _SHOWN]
        others = [f"{skipped} step skipped" if skipped == 1 else f"{skipped} steps skipped"] if skipped else []
        others += ["flown by the script"] if self._scripted else []
        return Debrief(None if others else grade(faults), (*faults, *others), tuple(figures))
