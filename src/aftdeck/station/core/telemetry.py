"""Telemetry of a session apart from its frames: log and last minutes, as late as the link makes them."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable

from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Event
from aftdeck.station.core.log import Log
from aftdeck.station.core.recent import RecentRun
from aftdeck.station.core.step import Step


class Telemetry:
    """Log and last minutes that the pages show.

    Attributes:
        log: events of all runs of the session.
        recent: last minutes of the run whose values the pages show.
    """

    def __init__(self, scenario: Scenario) -> None:
        self.log, self.recent = Log(), RecentRun(scenario)
        self._scenario = scenario
        self._newest, self._shown = 0, 0
        self._under_way: deque[tuple[int, Step | tuple[Event, ...]]] = deque()

    def see(self, step: Step) -> None:
        """Take a step, and let those arrive whose values the pages show now."""
        self._newest, self._shown = step.link.step, step.link.telemetry
        self._take(step)

    def add(self, events: Iterable[Event]) -> None:
        """Take lines of a step that is not made; they arrive with the newest step."""
        self._take(tuple(events))

    def _take(self, news: Step | tuple[Event, ...]) -> None:
        self._under_way.append((self._newest, news))
        while self._under_way and self._under_way[0][0] <= self._shown:
            self._arrive(self._under_way.popleft()[1])

    def _arrive(self, news: Step | tuple[Event, ...]) -> None:
        if not isinstance(news, Step):
            return self.log.add(news)
        if news.restarted:
            self.recent = RecentRun(self._scenario)
        self.recent.see(news)
        self.log.see(news)
