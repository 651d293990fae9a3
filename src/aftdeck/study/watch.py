"""Metrics of a run of a study, step by step."""

from __future__ import annotations

from aftdeck.recording.records import Shown
from aftdeck.report.lamps import lit_lamps
from aftdeck.report.metric import Metric, Value
from aftdeck.report.run_metrics import RunMetrics
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.run import Simulation
from aftdeck.task.progress import Progress

Monitors = tuple[tuple[str, ...], tuple[str, ...]]
"""Cameras on each of the two monitors."""


class Watch:
    """Metrics of a run, step by step."""

    def __init__(self, scenario: Scenario, shown: Monitors = ((), ()), progress: Progress | None = None) -> None:
        """Begin a run.

        Args:
            scenario: the scenario.
            shown: cameras on each monitor, during the whole run.
            progress: the pilot's progress through the task; None without a pilot.
        """
        self._scenario = scenario
        self._metrics = RunMetrics(scenario, progress)
        self._metrics.note(Shown(0.0, *shown))
        self._sim: Simulation | None = None

    def see(self, sim: Simulation) -> None:
        """Add the step that a simulation has made."""
        self._sim, frame = sim, sim.look()
        self._metrics.see(frame, lit_lamps(self._scenario, frame), sim.readings)

    def state(self) -> bytes:
        """Return the digest of the exact state after the last step."""
        assert self._sim is not None, "a run has a step"
        return self._sim.seal()

    def found(self) -> dict[Metric, Value]:
        """Return the metrics."""
        return self._metrics.found()
