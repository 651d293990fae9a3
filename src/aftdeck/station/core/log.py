"""Log of a session. One thread adds events; other threads may read them: the list only grows."""

from __future__ import annotations

from collections.abc import Iterable

import msgspec

from aftdeck.simulation.frame import Event
from aftdeck.station.core.step import Step


class Log:
    """Events of all runs of a session, in the order in which they were added."""

    def __init__(self) -> None:
        self._events: list[Event] = []

    def add(self, events: Iterable[Event]) -> None:
        """Add events at the end."""
        self._events.extend(events)

    def see(self, step: Step) -> None:
        """Add the lines of a step: the session's own, then those of the simulation."""
        self.add(step.notes)
        self.add(step.frame.events if step.frame.tick > 1 else map(_from_the_start, step.frame.events))

    def since(self, index: int) -> tuple[Event, ...]:
        """Return all events whose index is at least `index`."""
        return tuple(self._events[index:])


def _from_the_start(event: Event) -> Event:
    """Return an event of the first step as information: it tells the state in which the scenario begins."""
    if event.level == "info":
        return event
    return msgspec.structs.replace(event, level="info", text=f"from the start: {event.text}")
