"""Process that answers requests of a session, so that long work delays no control step.

The work and the control steps need the same interpreter lock if one process does both.
"""

from __future__ import annotations

import contextlib
import threading
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import Any

from aftdeck.errors import AftdeckError
from aftdeck.exact_pickle import pickled
from aftdeck.processes import BACKGROUND, Child


class Answering:
    """Process with a function that answers requests; the methods may be called from any thread."""

    def __init__(self, target: Callable[..., None], *given: Any) -> None:
        """Start the process.

        Args:
            target: what the process runs; it calls `answer_all` with its first argument.
            given: its other arguments.
        """
        self._child = Child(target, *given, nice=BACKGROUND)
        self._lock = threading.Lock()

    @property
    def pid(self) -> int:
        """Number of the process in the operating system."""
        return self._child.process.pid

    def messages(self, take: Callable[[Any], None]) -> None:
        """Wait for the messages before the first request, and pass each to a function; None is the last one.

        Raises:
            EOFError: the process has ended.
        """
        with self._lock:
            while (message := self._receive()) is not None:
                take(message)

    def ask(self, request: object) -> Any:
        """Return the answer to a request.

        Raises:
            AftdeckError: what the function raised.
            EOFError: the process has ended.
        """
        with self._lock:
            with contextlib.suppress(OSError):  # the process has ended, which `_receive` tells
                self._child.pipe.send_bytes(pickled(request))
            answer = self._receive()
        if isinstance(answer, AftdeckError):
            raise answer
        return answer

    def close(self) -> None:
        """End the process; a method that waits for it then raises an EOFError."""
        self._child.process.kill()
        with self._lock:
            self._child.kill()

    def _receive(self) -> Any:
        try:
            return self._child.pipe.recv()
        except OSError:  # the pipe is broken or closed
            raise EOFError from None


def answer_all(pipe: Connection, answer: Callable[[Any], object]) -> None:
    """Answer requests with a function until the pipe is closed; the process does no more than this."""
    while True:
        try:
            answered: object = answer(pipe.recv())
        except AftdeckError as error:
            answered = error
        pipe.send_bytes(pickled(answered))
