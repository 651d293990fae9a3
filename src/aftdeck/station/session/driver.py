"""Driver of a session: the thread that steps the session once in each control period."""

from __future__ import annotations

import gc
import threading
import time
from collections.abc import Callable
from enum import Enum

from aftdeck.station.session.pace import Pace
from aftdeck.station.session.session import Session

MAX_JOIN = 5.0
"""Longest wait for the end of the thread [s]."""


class Phase(Enum):
    """Phase in the life of a driver."""

    READY = "ready"
    FLYING = "flying"
    FAILED = "failed"
    CLOSED = "closed"


class Driver:
    """Thread that steps a session in real time, without waiting for pages.

    Attributes:
        session: the session.
        phase: phase in the life of the driver.
        failure: reason for a failure, in a sentence; empty if no failure occurred.
    """

    def __init__(self, session: Session, clock: Callable[[], float] = time.perf_counter) -> None:
        """Prepare the thread; `clock` returns the time [s]."""
        self.session = session
        self.phase = Phase.READY
        self.failure = ""
        self._clock = clock
        self._notify: Callable[[], None] = lambda: None
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._run, name="simulation", daemon=True)

    def start(self, notify: Callable[[], None]) -> None:
        """Start the run; `notify` is called after each step, after a failure, and after pictures of the painter."""
        self._notify = self.session.painter.notify = notify
        self.phase = Phase.FLYING
        self._thread.start()

    def close(self) -> None:
        """Stop the run, wait for the thread, and finish the recording."""
        self._stop.set()
        if self._thread.is_alive():
            self._thread.join(MAX_JOIN)
        self.session.close()
        self.phase = Phase.CLOSED

    def _run(self) -> None:
        try:
            _spare_the_collector()
            self.session.begin()
            pace = Pace(self.session.scenario.control_period, self._clock)
            while not self._stop.is_set():
                if self.session.step(pace.step()):
                    pace.begin()
                self._notify()
                if wait := pace.wait():
                    self._stop.wait(wait)
        except Exception as error:  # any error must reach the pages
            self.failure = f"the simulation stopped at {self.session.time_s:.2f} s: {error}"
            self.phase = Phase.FAILED
            self._notify()
            raise


def _spare_the_collector() -> None:
    """Exempt all present objects from garbage collection: to visit them once takes as long as several steps.

    Objects that an earlier session has left are collected first.
    """
    gc.unfreeze()
    gc.collect()
    gc.freeze()
