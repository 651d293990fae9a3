"""Log of the server on the terminal: of equal lines, one in a minute, and the number of the others."""

from __future__ import annotations

import logging
from threading import Timer

from aftdeck.lines import print_error

SILENCE = 60.0
"""Time after a line for which equal lines are only counted [s]."""
MAX_KINDS = 100
"""Maximum number of lines that are counted at the same time; other lines are dropped meanwhile."""

log = logging.getLogger("aftdeck.station")
"""Log of the station's server."""


class TerseHandler(logging.Handler):
    """Handler that prints the first of equal lines at once and counts the others.

    Lines are equal if their text before the insertion of values is equal, up to its first line break. Every
    `SILENCE`, the handler prints how many equal lines there were, and the last of them.
    """

    def __init__(self) -> None:
        super().__init__(logging.WARNING)
        self._more: dict[str, int] = {}
        self._last: dict[str, str] = {}
        self._timers: dict[str, Timer] = {}

    def emit(self, record: logging.LogRecord) -> None:
        """Print or count a line."""
        text = str(record.msg).partition("\n")[0]
        if text in self._more:
            self._more[text] += 1
            self._last[text] = record.getMessage().partition("\n")[0]
        elif len(self._more) < MAX_KINDS:
            self._more[text] = 0
            print_error(self.format(record))
            self._wait(text)

    def _wait(self, text: str) -> None:
        timer = self._timers[text] = Timer(SILENCE, self._report, (text,))
        timer.daemon = True
        timer.start()

    def flush(self) -> None:
        """Print at once how many lines have been counted, and reset the counts. A server calls this when it ends."""
        with self.lock or logging._lock:  # type: ignore[attr-defined]
            timers, more, last = self._timers, self._more, self._last
            self._timers, self._more, self._last = {}, {}, {}
        for timer in timers.values():
            timer.cancel()
        for text, count in more.items():
            if count:
                print_error(f"{count} more like this: {last[text]}")

    def _report(self, text: str) -> None:
        with self.lock or logging._lock:  # type: ignore[attr-defined]
            more, last = self._more.pop(text, 0), self._last.pop(text, "")
            self._timers.pop(text, None)
            if more:
                self._more[text] = 0
        if more:
            print_error(f"{more} more like this in {SILENCE:g} s: {last}")
            self._wait(text)


_handler = TerseHandler()


def flush() -> None:
    """Print at once how many lines the handler has counted."""
    _handler.flush()


def install() -> None:
    """Print the lines of the station, of its web server and of asyncio through one `TerseHandler`."""
    for name in (log.name, "uvicorn", "asyncio"):
        logger = logging.getLogger(name)
        logger.addHandler(_handler)
        logger.setLevel(logging.WARNING)
        logger.propagate = False
