"""Time history of a recorded run, as a table."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from aftdeck.errors import RecordingError
from aftdeck.recording.bundle import scenario_of
from aftdeck.recording.gauged import messages_of
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import FrameRecord
from aftdeck.simulation.series.series import Series
from aftdeck.table import Table


def series_of(
    recording: Recording, columns: Sequence[str] = (), progress: Callable[[float], None] | None = None
) -> Table:
    """Return the time history of a recorded run, a row for each step.

    Columns that need gauges re-simulate the run. The others are read: as recorded, rounded.

    Args:
        recording: the recording.
        columns: names of groups or of columns (docs/series.md); () for all.
        progress: called repeatedly with the fraction of the recording that is done, 0 to 1.

    Raises:
        InputError: there is no such group or column.
        RecordingError: the recording has no step or is damaged, or its re-simulation differs from it.
    """
    series = Series(scenario_of(recording.opening), columns)
    steps = 0
    for message, readings in messages_of(recording, gauged=series.gauged):
        if isinstance(message, FrameRecord):
            series.see(message, readings)
            steps += 1
            if progress is not None and steps % 256 == 0:
                progress(recording.share)
    if not steps:
        raise RecordingError(f"{recording.path}: ends before its first step and has no time history", "empty")
    return series.table()
