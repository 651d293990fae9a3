"""Metrics of a recorded run."""

from __future__ import annotations

from aftdeck.errors import RecordingError
from aftdeck.recording.bundle import scenario_of
from aftdeck.recording.gauged import messages_of
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import FrameRecord
from aftdeck.report.lamps import lit_lamps
from aftdeck.report.metric import Metric, Value
from aftdeck.report.run_metrics import RunMetrics
from aftdeck.report.table import Row, row_of


def metrics_of(recording: Recording, *, gauged: bool = False) -> dict[Metric, Value]:
    """Return every metric for which a recording has data.

    Args:
        recording: the recording.
        gauged: whether a run with masses is simulated again, for the metrics that need gauges (`recording.gauged`).

    Raises:
        RecordingError: the recording has no step, or its re-simulation differs from it.
    """
    scenario = scenario_of(recording.opening)
    metrics, steps = RunMetrics(scenario), 0
    for message, readings in messages_of(recording, gauged=gauged):
        if isinstance(message, FrameRecord):
            metrics.see(message, lit_lamps(scenario, message, recording.delays), readings)
            steps += 1
        else:
            metrics.note(message)
    if not steps:
        raise RecordingError(f"{recording.path}: ends before its first step and has no metrics", "empty")
    return metrics.found(recording.delays)


def recorded_row(recording: Recording) -> Row:
    """Return the row of a recording in a table of runs; raises as `metrics_of`."""
    return row_of(recording, metrics_of(recording))


def gauged_row(recording: Recording) -> Row:
    """Return the row of a recording, with the metrics that need gauges; raises as `metrics_of`."""
    return row_of(recording, metrics_of(recording, gauged=True))
