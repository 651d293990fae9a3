"""Log of a session. One thread adds events; other threads read them."""

from __future__ import annotations

from collections.abc import Iterable
from threading import Lock

from aftdeck.simulation.frame import Event


class Log:
    """Events of all runs of a session, in the order in which they were added."""

    def __init__(self) -> None:
        self._events: list[Event] = []
        self._lock = Lock()

    def add(self, events: Iterable[Event]) -> None:
        """Add events at the end."""
        with self._lock:
            self._events.extend(events)

    def since(self, index: int) -> tuple[Event, ...]:
        """Return all events whose index is at least `index`."""
        with self._lock:
            return tuple(self._events[index:])
