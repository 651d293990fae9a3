"""Clearance, contacts, and what they caused."""

from __future__ import annotations

from collections.abc import Iterator

from aftdeck.report.metric import FORMAN, Found, Metric, Value
from aftdeck.simulation.frame import Frame
from aftdeck.worksite.report import Near
from aftdeck.worksite.watch.alarm import Level

LEAST = Metric(
    "min_clearance",
    "Smallest clearance",
    "gap",
    "Minimum clearance of the run, without essential contacts.",
    FORMAN,
)
MEAN = Metric(
    "mean_clearance",
    "Mean clearance",
    "gap",
    "Mean over time of the minimum clearance of all monitored pairs.",
    FORMAN,
)
WARNINGS = Metric(
    "clearance_warnings",
    "Clearance warnings",
    "count",
    "Number of times that the minimum clearance fell below the threshold of a warning.",
)
COLLISIONS = Metric(
    "collisions",
    "Collisions",
    "count",
    "Number of times that two parts came into contact, without contacts that belong to the task.",
    FORMAN,
)
INHIBITS = Metric("inhibits", "Inhibits", "count", "Number of times that a contact began to inhibit the arm.")
METRICS = (LEAST, MEAN, WARNINGS, COLLISIONS, INHIBITS)


class Clearance:
    """Clearance and contacts. What the first frame has already is no event: the arm in its cradle."""

    def __init__(self) -> None:
        self._nearest: tuple[Near, float] | None = None
        self._worst: Level = "info"
        self._sum, self._steps = 0.0, 0
        self._warnings = self._collisions = self._inhibits = 0

    def see(self, frame: Frame, before: Frame | None) -> None:
        """Add the next frame."""
        work, near = frame.work, frame.work.nearest
        if near is not None:
            self._sum += near.clearance
            self._steps += 1
            if self._nearest is None or near.clearance < self._nearest[0].clearance:
                self._nearest = near, frame.time_s
        if work.clearance_level != "info" and self._worst != "warning":
            self._worst = work.clearance_level
        if before is None:
            return
        old = before.work
        self._warnings += work.clearance_level == "warning" and old.clearance_level != "warning"
        self._inhibits += work.arm_inhibit and not old.arm_inhibit
        if work.contacts:
            self._collisions += len(_touching(work.contacts) - _touching(old.contacts))

    def found(self) -> Iterator[Found]:
        """Yield all metrics; clearances only if a pair was monitored."""
        if self._nearest is not None:
            near, when = self._nearest
            where = f"{near.a} to {near.b}, at {when:.1f} s"
            yield LEAST, Value(near.clearance, detail=where, level=self._worst)
            yield MEAN, Value(self._sum / self._steps)
        yield WARNINGS, Value(float(self._warnings))
        yield COLLISIONS, Value(float(self._collisions))
        yield INHIBITS, Value(float(self._inhibits))


def _touching(contacts: tuple[Near, ...]) -> set[tuple[str, str]]:
    return {(near.a, near.b) for near in contacts if not near.essential}
