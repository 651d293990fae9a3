"""Events at limits and singularities, use of the brakes, and alarms."""

from __future__ import annotations

from collections.abc import Iterator

from aftdeck.report.metric import FORMAN, Found, Metric, Value
from aftdeck.simulation.frame import AT_HARD, PAST_REACH, PAST_SOFT, Frame

BRAKES = Metric("brakes_used", "Brakes used", "count", "Number of times that the brakes were set.")
HARD_STOPS = Metric(
    "hard_stop_events",
    "Hard stop",
    "count",
    "Number of times that the arm came to a hard stop, with one joint or several.",
    FORMAN,
)
RATE_LIMIT = Metric(
    "rate_limit_events",
    "Rate limit",
    "count",
    "Number of times that the limit of a joint's rate began to slow the arm.",
)
REACH_LIMIT = Metric(
    "reach_limit_events",
    "Reach limit",
    "count",
    "Number of times that the arm came beyond a reach limit, with one joint or several.",
    FORMAN,
)
SOFT_STOP = Metric(
    "soft_stop_events",
    "Soft stop",
    "count",
    "Number of times that the arm came to or beyond a soft stop, with one joint or several.",
    FORMAN,
)
SINGULARITY = Metric(
    "singularity_events",
    "Singularity",
    "count",
    "Number of times that the arm came nearer to a singularity than its threshold.",
    FORMAN,
)
METRICS = (RATE_LIMIT, REACH_LIMIT, SOFT_STOP, HARD_STOPS, SINGULARITY, BRAKES)


def _states(frame: Frame) -> tuple[bool, ...]:
    """Return the states whose beginnings are counted, in the order of `METRICS`."""
    worst, kinds = max(frame.zones), [limit.kind for limit in frame.limits]
    return (
        "joint rate" in kinds,
        worst >= PAST_REACH,
        worst >= PAST_SOFT or "soft stop" in kinds,
        worst >= AT_HARD,
        bool(frame.singular),
        frame.brakes,
    )


class Limits:
    """Number of times that each state began. What the first frame has already is no event: the arm in its cradle."""

    def __init__(self) -> None:
        self._counts = dict.fromkeys(METRICS, 0)
        self._before: tuple[bool, ...] | None = None

    def see(self, frame: Frame, before: Frame | None) -> None:
        """Add the next frame."""
        now = _states(frame)
        if self._before is not None and now != self._before:
            for metric, new, old in zip(METRICS, now, self._before, strict=True):
                self._counts[metric] += new and not old
        self._before = now

    def found(self) -> Iterator[Found]:
        """Yield all numbers."""
        for metric, count in self._counts.items():
            yield metric, Value(float(count))
