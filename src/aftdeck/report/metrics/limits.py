"""Events at limits and singularities, use of the brakes, and alarms."""

from __future__ import annotations

from collections.abc import Callable, Iterator

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
_STATES: dict[Metric, Callable[[Frame], bool]] = {
    Metric(
        "rate_limit_events",
        "Rate limit",
        "count",
        "Number of times that the limit of a joint's rate began to slow the arm.",
    ): lambda f: bool(f.limits) and any(limit.kind == "joint rate" for limit in f.limits),
    Metric(
        "reach_limit_events",
        "Reach limit",
        "count",
        "Number of times that the arm came beyond a reach limit, with one joint or several.",
        FORMAN,
    ): lambda f: max(f.zones) >= PAST_REACH,
    Metric(
        "soft_stop_events",
        "Soft stop",
        "count",
        "Number of times that the arm came to or beyond a soft stop, with one joint or several.",
        FORMAN,
    ): lambda f: max(f.zones) >= PAST_SOFT or (bool(f.limits) and any(limit.kind == "soft stop" for limit in f.limits)),
    HARD_STOPS: lambda f: AT_HARD in f.zones,
    Metric(
        "singularity_events",
        "Singularity",
        "count",
        "Number of times that the arm came nearer to a singularity than its threshold.",
        FORMAN,
    ): lambda f: bool(f.singular),
    BRAKES: lambda f: f.brakes,
}
"""States whose beginnings are counted."""
METRICS = tuple(_STATES)


class Limits:
    """Number of times that each state began. What the first frame has already is no event: the arm in its cradle."""

    def __init__(self) -> None:
        self._counts = dict.fromkeys(_STATES, 0)
        self._before: list[bool] | None = None

    def see(self, frame: Frame, before: Frame | None) -> None:
        """Add the next frame."""
        now = [holds(frame) for holds in _STATES.values()]
        if self._before is not None and now != self._before:
            for metric, new, old in zip(_STATES, now, self._before, strict=True):
                self._counts[metric] += new and not old
        self._before = now

    def found(self) -> Iterator[Found]:
        """Yield all numbers."""
        for metric, count in self._counts.items():
            yield metric, Value(float(count))
