"""Preparation of a station's session that continues only when the test allows it."""

from __future__ import annotations

from collections.abc import Callable
from threading import Event

from aftdeck.station.session.preparation import Preparation
from aftdeck.station.session.session import Session
from tests.loaded import scenario
from tests.waits import WAIT_S

Report = Callable[[str], None]


class Slow:
    """Preparation that continues when the test sets `go`."""

    def __init__(self, error: Exception | None = None) -> None:
        self.session = Session(scenario())  # in advance: compiling the laws takes longer than a page waits
        self.go, self.error, self.failed = Event(), error, Event()
        self.coming = Preparation(self.make)

    def make(self, report: Report) -> Session:
        report("Loading.")
        assert self.go.wait(WAIT_S)
        if self.error is not None:
            raise self.error
        return self.session
