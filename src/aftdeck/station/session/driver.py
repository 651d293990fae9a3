"""Driver of a session: the thread that steps the session once in each control period."""

from __future__ import annotations

import gc
import math
import threading
import time
from collections.abc import Callable
from enum import Enum

from aftdeck.station.messages.kinds import WaitsFor
from aftdeck.station.session.pace import Pace
from aftdeck.station.session.session import Session

MAX_JOIN = 5.0
"""Longest wait for the end of the thread [s]."""
PAGE_WITHIN = 10.0
"""Longest time for which a run waits for the first pictures of a page [s]."""
NO_PAGE = f"the run has started: no page in control has drawn a picture within {PAGE_WITHIN:g} s"
"""Line of the log after this time."""
TOO_LATE = 0.1
"""Delay of a step from which the run waits for compiled laws, if plain Python is the cause [s]."""
SENT_WITHIN = 0.001
"""Time left to the server to send a frame, before the rest of the step competes with it for Python's lock [s]."""
TELL_EVERY = 0.25
"""Time from one notification to the next while the run waits [s]."""


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
        waits_for: what the run waits for; empty if it goes on.
    """

    def __init__(
        self, session: Session, clock: Callable[[], float] = time.perf_counter, *, for_page: bool = False
    ) -> None:
        """Prepare the thread.

        Args:
            session: the session.
            clock: returns the time [s].
            for_page: whether the run waits after its first step until the page in control has drawn it.
        """
        self.session = session
        self.phase = Phase.READY
        self.failure = ""
        self.waits_for: WaitsFor = ""
        self._for_page = for_page
        self._drawn = threading.Event()
        self._clock = clock
        self._notify: Callable[[], None] = lambda: None
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._run, name="simulation", daemon=True)

    def start(self, notify: Callable[[], None]) -> None:
        """Start the run; `notify` is called after each step, after a failure, and after pictures of the painter."""
        self._notify = self.session.painter.notify = notify
        self.phase = Phase.FLYING
        self._thread.start()

    def drawn(self) -> None:
        """Let a run go on that waits for a page's first pictures."""
        self._drawn.set()

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
            if self._for_page:
                self._let_page_draw()
            pace = Pace(self.session.scenario.control_period, self._clock)
            work = 0.0
            while not self._stop.is_set():
                # A busy machine is no reason to wait: it makes a step late, but not its own work longer.
                slow = work > self.session.scenario.control_period
                if slow and pace.late > TOO_LATE and self._wait("laws", self.session.laws.wait):
                    pace.begin()
                began = time.thread_time()
                if self.session.step_to_frame(pace.step()):
                    pace.begin()
                self._notify()
                self._stop.wait(min(SENT_WITHIN, pace.wait()))
                self.session.settle()
                work = time.thread_time() - began
                if wait := pace.wait():
                    self._stop.wait(wait)
        except Exception as error:  # any error must reach the pages
            self.failure = f"the simulation stopped at {self.session.time_s:.2f} s: {error}"
            self.phase = Phase.FAILED
            self._notify()
            raise

    def _let_page_draw(self) -> None:
        """Do the first step, and wait until the page in control has drawn it, for `PAGE_WITHIN` at most."""
        self.session.step()
        self._notify()
        self._wait("page", self._drawn.wait, PAGE_WITHIN)
        if not self._drawn.is_set():
            self.session.note("page", NO_PAGE)

    def _wait(self, what: WaitsFor, over: Callable[[float], bool], longest: float = math.inf) -> bool:
        """Let the run stand still until something is over, so that it loses no time; return whether it has waited.

        Args:
            what: what the run waits for.
            over: waits for at most a given time [s]; returns whether the wait is over.
            longest: longest wait [s].
        """
        until = time.monotonic() + longest
        waited = not over(0.0)
        while not (over(0.0) or self._stop.is_set() or time.monotonic() > until):
            self.waits_for = what
            self._notify()
            over(TELL_EVERY)
        self.waits_for = ""
        return waited


def _spare_the_collector() -> None:
    """Exempt all present objects from garbage collection: to visit them once takes as long as several steps.

    Objects that an earlier session has left are collected first.
    """
    gc.unfreeze()
    gc.collect()
    gc.freeze()
