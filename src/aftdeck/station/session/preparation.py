"""Preparation of a station's first session in a thread of its own, while the server already answers."""

from __future__ import annotations

from collections.abc import Callable
from threading import Thread

from aftdeck.errors import AftdeckError
from aftdeck.station.session.session import Session

Make = Callable[[Callable[[str], None]], Session]
"""Function that makes a session; it gets a function that takes its lines of progress."""


class Preparation:
    """Session that a thread makes: loading the laws takes seconds, compiling them half a minute.

    Attributes:
        text: what is done at present, in a sentence for the pages that wait.
        session: the session; None until it is made.
        error: error that ended the preparation; None if there was none.
    """

    def __init__(self, make: Make) -> None:
        self.text = "Starting."
        self.session: Session | None = None
        self.error: Exception | None = None
        self._make = make
        self._notify: Callable[[], None] = lambda: None

    @property
    def failure(self) -> str:
        """Sentence about the error for the pages; empty if there was none."""
        if self.error is None or isinstance(self.error, AftdeckError):
            return "" if self.error is None else str(self.error)
        return f"the station cannot start: {self.error!r}"

    def start(self, notify: Callable[[], None]) -> None:
        """Start the preparation; its thread calls `notify` after each line of progress and at its end.

        The end of the process does not wait for that thread.
        """
        self._notify = notify
        Thread(target=self._run, name="preparation", daemon=True).start()

    def _run(self) -> None:
        try:
            self.session = self._make(self._say)
        except Exception as error:  # any error must reach the pages and the terminal
            self.error = error
        self._notify()

    def _say(self, text: str) -> None:
        self.text = text
        self._notify()


def ready(session: Session) -> Preparation:
    """Return the preparation of a session that is made already."""
    done = Preparation(lambda _: session)
    done.session = session
    return done
