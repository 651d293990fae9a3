"""Collisions."""

from __future__ import annotations

from collections.abc import Iterator

from aftdeck.report.metric import Found, Metric, Value
from aftdeck.report.recorded import recorded
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.readings.source import FORMAN
from aftdeck.worksite.report import Near

COLLISIONS = Metric(
    "collisions",
    "Collisions",
    "count",
    "Number of times that two parts came into contact, without contacts that belong to the task.",
    FORMAN,
)
METRICS = (*map(recorded, ("min_clearance_m", "mean_clearance_m", "clearance_warnings")), COLLISIONS)


class Collisions:
    """Contacts of a run. What the first frame has already is no event: the arm in its cradle."""

    def __init__(self) -> None:
        self._collisions = 0

    def see(self, frame: Frame, before: Frame | None) -> None:
        """Add the next frame."""
        if before is not None and frame.work.contacts:
            self._collisions += len(_touching(frame.work.contacts) - _touching(before.work.contacts))

    def found(self) -> Iterator[Found]:
        """Yield the number of collisions."""
        yield COLLISIONS, Value(float(self._collisions))


def _touching(contacts: tuple[Near, ...]) -> set[tuple[str, str]]:
    return {(near.a, near.b) for near in contacts if not near.essential}
