"""Conversion of a run's metrics to the figures that the page shows."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from aftdeck.report.catalogue import named
from aftdeck.report.metric import Metric, Value
from aftdeck.station.messages.measure import Measure

RESULT = tuple(map(named, ("run_time_s", "capture_offset_m", "min_clearance_m", "alarms", "tip_path_m", "lost_time_s")))
"""Metrics in the result of a task."""
REPLAY = tuple(
    named(column)
    for column in (
        *("run_time_s", "manual_share", "lost_time_s", "controllers", "target_distance_m", "min_clearance_m"),
        *("capture_offset_m", "capture_speed_m_s", "dock_offset_m", "dock_speed_m_s", "latch_offset_m"),
        *("tip_off_rate_rad_s", "tip_path_m", "greatest_speed_m_s", "worst_joint_rate", "vernier_time_s"),
        *("two_handed_share", "multi_axis_share", "reversals_a_minute", "most_reversed_axis"),
        *("peak_contact_force_n", "alarms", "brakes_used", "camera_changes"),
    )
)
"""Metrics in a replay, in their order."""
_ANGLES = {named("target_distance_m"): named("target_angle_rad")} | {
    named(f"{kind}_offset_m"): named(f"{kind}_angle_rad") for kind in ("capture", "dock", "latch")
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
