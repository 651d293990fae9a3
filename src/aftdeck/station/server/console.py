"""Console in the terminal of a station (`aftdeck fly --console`): lines from standard input, with completion by Tab."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterator
from importlib import import_module
from types import ModuleType
from typing import Any

from aftdeck.lines import print_line
from aftdeck.station.session.session import Session

PROMPT = "> "
NOT_READY = "the scenario is being loaded; wait until it flies"


class TerminalConsole:
    """Thread that reads lines and prints their answers."""

    def __init__(self, session: Callable[[], Session | None]) -> None:
        """Begin to read.

        Args:
            session: returns the present session; None before there is one.
        """
        self._session = session
        self._words: tuple[str, ...] = ()
        self._restore = _terminal_state()
        self._readline = _module("readline") if sys.stdin.isatty() else None
        if self._readline is not None:
            self._readline.set_completer_delims(" \t;=")
            self._readline.set_completer(self._complete)
            self._readline.parse_and_bind("tab: complete")
        threading.Thread(target=self._read, name="console", daemon=True).start()

    def close(self) -> None:
        """Restore the terminal, which the reading of a line may have changed."""
        self._restore()

    def _read(self) -> None:
        for line in self._lines():
            if line.strip():
                session = self._session()
                for text in (NOT_READY,) if session is None else session.type_line(line).lines:
                    print_line(text)

    def _lines(self) -> Iterator[str]:
        while True:
            try:
                line = sys.stdin.readline() if self._readline is None else input(PROMPT) + "\n"
            except (EOFError, OSError, ValueError):  # ValueError: standard input is closed, because the program ends
                return
            if not line:
                return
            yield line

    def _complete(self, _: str, state: int) -> str | None:
        """Return completion number `state` of the present line (a function for `readline`)."""
        session = self._session()
        if session is None or self._readline is None:
            return None
        if state == 0:
            self._words = session.complete_line(self._readline.get_line_buffer())
        return self._words[state] if state < len(self._words) else None


def _module(name: str) -> ModuleType | None:
    """Return a module that some systems lack; None there."""
    try:
        return import_module(name)
    except ImportError:
        return None


def _terminal_state() -> Callable[[], None]:
    """Return a function that gives the terminal the settings that it has now."""
    termios: Any = _module("termios")
    if termios is None or not sys.stdin.isatty():
        return lambda: None
    settings = termios.tcgetattr(sys.stdin)
    return lambda: termios.tcsetattr(sys.stdin, termios.TCSADRAIN, settings)
