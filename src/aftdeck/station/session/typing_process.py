"""Console of a session in a process of its own: the scenario of a change takes tenths of a second to make."""

from __future__ import annotations

import threading
from multiprocessing.connection import Connection
from typing import Any, NamedTuple

from aftdeck.errors import InputError
from aftdeck.law import run_kept
from aftdeck.scenario.model import Scenario
from aftdeck.station.core.typewriter import Now, Reply, Typewriter
from aftdeck.station.session.answering import Answering, answer_all

ENDED = "the process of the console has ended; type the line again"


class _Line(NamedTuple):
    """A line; `whole`: whether it is to be answered, or completed."""

    text: str
    now: Now
    whole: bool


class TypingProcess:
    """Console of a run (`typewriter.Console`); its process starts with the first line."""

    def __init__(self, scenario: Scenario) -> None:
        """Set up the console; `scenario`: the one with which the run began."""
        self._scenario = scenario
        self._lock = threading.Lock()
        self._process: Answering | None = None
        self._closed = False

    def reply(self, line: str, now: Now) -> Reply:
        """Return the result of a line; errors as for `Console.reply`, and also if the process has ended."""
        reply: Reply = self._ask(_Line(line, now, whole=True))
        return reply

    def completions(self, line: str, now: Now) -> tuple[str, ...]:
        """Return the words with which the last word of a line can go on; none if the process has ended."""
        try:
            words: tuple[str, ...] = self._ask(_Line(line, now, whole=False))
        except InputError:
            return ()
        return words

    @property
    def pid(self) -> int | None:
        """Number of the process in the operating system; None before the first line."""
        process = self._process
        return None if process is None else process.pid

    def close(self) -> None:
        """End the process, for good."""
        with self._lock:
            self._closed = True
            process = self._process
        if process is not None:
            process.close()

    def _ask(self, line: _Line) -> Any:
        with self._lock:
            if self._closed:
                raise InputError("the session is closed")
            if self._process is None:
                self._process = Answering(_answer_lines, self._scenario)
            process = self._process
        try:
            return process.ask(line)
        except EOFError:
            with self._lock:
                if self._process is process:
                    self._process = None
            process.close()
            raise InputError(ENDED) from None


def _answer_lines(pipe: Connection, scenario: Scenario) -> None:
    """Answer the lines of a console. What the process runs."""
    run_kept()
    typewriter = Typewriter(scenario)

    def answer(line: _Line) -> object:
        return (typewriter.reply if line.whole else typewriter.completions)(line.text, line.now)

    answer_all(pipe, answer)
