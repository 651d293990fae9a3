"""Conversion of a run's metrics to the figures that the page shows."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from aftdeck.report.metric import Metric, Value
from aftdeck.report.metrics import (
    alarms,
    clearance,
    desk,
    forces,
    limits,
    moments,
    path,
    pictures,
    sticks,
    times,
)
from aftdeck.station.messages.measure import Measure

RESULT = (times.RUN, moments.CAPTURE.offset, clearance.LEAST, alarms.RAISED, path.PATH, desk.LOST)
"""Metrics in the result of a task."""
REPLAY = (
    times.RUN,
    times.MANUAL,
    desk.LOST,
    desk.CONTROLLERS,
    path.TARGET,
    clearance.LEAST,
    moments.CAPTURE.offset,
    moments.CAPTURE.speed,
    moments.DOCK.offset,
    moments.DOCK.speed,
    moments.LATCH.offset,
    moments.TIP_OFF,
    path.PATH,
    path.SPEED,
    path.RATE,
    times.VERNIER,
    sticks.TWO_HANDED,
    sticks.MULTI_AXIS,
    sticks.REVERSAL_RATE,
    sticks.WORST_AXIS,
    forces.PEAK,
    alarms.RAISED,
    limits.BRAKES,
    pictures.CAMERAS,
)
"""Metrics in a replay, in their order."""
_ANGLES = {path.TARGET: path.TARGET_ANGLE} | {
    kind.offset: kind.angle for kind in (moments.CAPTURE, moments.DOCK, moments.LATCH)
}
"""Distances that are shown with an angle."""


def measures_of(found: Mapping[Metric, Value], shown: Iterable[Metric]) -> tuple[Measure, ...]:
    """Return those metrics of `shown` for which the run has data."""
    return tuple(_measure(metric, found) for metric in shown if metric in found)


def ended(reason: str) -> Measure:
    """Return the figure that tells why a run ended; `reason` is empty for a recording that was cut short."""
    return Measure("Ended", "words", None, reason or "cut short", "Reason for the end of the run.")


def _measure(metric: Metric, found: Mapping[Metric, Value]) -> Measure:
    value, angle = found[metric], found.get(_ANGLES[metric]) if metric in _ANGLES else None
    sentences = [metric.definition]
    if angle is not None:
        sentences.append(_ANGLES[metric].definition)
    if value.detail:
        sentences.append(f"{value.detail[:1].upper()}{value.detail[1:]}.")
    return Measure(
        metric.title,
        metric.quantity,
        value.number,
        value.text,
        " ".join(sentences),
        None if angle is None else angle.number,
        value.level,
    )
