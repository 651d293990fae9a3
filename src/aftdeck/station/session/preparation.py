"""Preparation of a station's first session in a thread, while the server already answers requests."""

from __future__ import annotations

from collections.abc import Callable
from threading import Thread

from aftdeck.errors import AftdeckError
from aftdeck.station.session.session import Session

Make = Callable[[Callable[[str], None]], Session]
"""Function that makes a session; its argument is a function that reports lines of progress."""


class Preparation:
    """Thread that makes a session, which takes seconds.

    Attributes:
        text: line of progress for the waiting pages.
        session: the session; None until it is made.
        error: error that ended the preparation; None if no error occurred.
    """

    def __init__(self, make: Make) -> None:
        self.text = "Starting."
        self.session: Session | None = None
        self.error: Exception | None = None
        self._make = make
        self._notify: Callable[[], None] = lambda: None

    @property
    def failure(self) -> str:
        """Sentence about the error, for the pages; empty if no error occurred."""
        if self.error is None or isinstance(self.error, AftdeckError):
            return "" if self.error is None else str(self.error)
        return f"the station cannot start: {self.error!r}"

    def start(self, notify: Callable[[], None]) -> None:
        """Start the thread; it calls `notify` after each line of progress and when the session is made or has failed.

        The process can end without waiting for the thread.
        """
        self._notify = notify
        Thread(target=self._run, name="preparation", daemon=True).start()

    def _run(self) -> None:
        try:
            self.session = self._make(self._report)
        except Exception as error:  # any error must reach the pages and the terminal
            self.error = error
        self._notify()

    def _report(self, text: str) -> None:
        self.text = text
        self._notify()


def ready(session: Session) -> Preparation:
    """Return a preparation that has already made `session`."""
    done = Preparation(lambda _: session)
    done.session = session
    return done
