"""List of all metrics, and their tables in docs/metrics.md: ``python -m aftdeck.report.catalogue FILE``."""

from __future__ import annotations

from collections.abc import Iterator

from aftdeck.made_tables import renew_file
from aftdeck.report.metric import Metric
from aftdeck.report.metrics import (
    alarms,
    announcements,
    clearance,
    desk,
    moments,
    path,
    pictures,
    steps,
    sticks,
    stopping,
    times,
)
from aftdeck.report.recorded import with_recorded
from aftdeck.simulation.readings.quantity import UNITS

_SUBJECTS: dict[str, tuple[Metric, ...]] = {
    "Times": times.METRICS,
    "Task": steps.METRICS,
    "Path": path.METRICS,
    "Captures, dockings, latchings, releases": moments.METRICS,
    "Clearance": clearance.METRICS,
    "Hand controllers": sticks.METRICS,
    "Stopping": stopping.METRICS,
    "Limits": (),
    "Alarms": (*alarms.METRICS, *announcements.METRICS),
    "Forces": (),
    "Torques, loads and bends": (),
    "Pictures": pictures.METRICS,
    "Station": desk.METRICS,
}
"""Metrics by subject, those of readings only where others follow them."""
SUBJECTS = {subject: with_recorded(subject, metrics) for subject, metrics in _SUBJECTS.items()}
"""All metrics, by subject."""
METRICS = tuple(metric for subject in SUBJECTS.values() for metric in subject)
"""All metrics, in the order of tables."""
_BY_COLUMN = {metric.column: metric for metric in METRICS}


def named(column: str) -> Metric:
    """Return the metric with this column of tables."""
    return _BY_COLUMN[column]


def tables() -> str:
    """Return a heading and a table for each subject."""
    return "\n".join(_lines())


def _lines() -> Iterator[str]:
    for subject, metrics in SUBJECTS.items():
        yield f"### {subject}\n\n| column | unit | definition | source |\n|---|---|---|---|"
        for metric in metrics:
            unit = UNITS[metric.quantity]
            yield f"| `{metric.column}` | {unit} | **{metric.title}.** {metric.definition} | {metric.source} |"
        yield ""


if __name__ == "__main__":
    renew_file(tables())
