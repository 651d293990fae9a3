"""Alarms: lamps that changed to a higher level."""

from __future__ import annotations

from collections.abc import Iterator

from aftdeck.report.lamps import Lamp, StandingLamps
from aftdeck.report.metric import Found, Metric, Value
from aftdeck.worksite.watch.alarm import Level

RAISED = Metric(
    "alarms",
    "Alarms raised",
    "count",
    "Number of times that a lamp changed to a higher level, caution or warning; without what was lit from the start.",
)
METRICS = (RAISED,)
_RANK: dict[Level, int] = {"info": 0, "caution": 1, "warning": 2}


class Alarms:
    """Alarms of a run."""

    def __init__(self) -> None:
        self._standing = StandingLamps()
        self._lit: dict[str, Level] = {}
        self._raised = 0
        self._worst: Level = "info"

    def see(self, lamps: tuple[Lamp, ...]) -> None:
        """Add the lamps that are lit in the next step."""
        lit: dict[str, Level] = {lamp.name: lamp.level for lamp in self._standing.marked(lamps) if not lamp.standing}
        if lit == self._lit:
            return
        self._worst = max((self._worst, *lit.values()), key=_RANK.__getitem__)
        self._raised += sum(_RANK[level] > _RANK[self._lit.get(name, "info")] for name, level in lit.items())
        self._lit = lit

    def found(self) -> Iterator[Found]:
        """Yield the number of alarms."""
        yield RAISED, Value(float(self._raised), level=self._worst)
