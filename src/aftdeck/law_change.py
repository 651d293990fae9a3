"""Compiled laws for a process that starts with plain Python: another process compiles, and this one changes over.

A law gives the same result in both ways, to the last bit. So a run may start at once, long before its laws are
compiled: a process calls `run_plain`, and `Laws` replaces its laws between two calls when their machine code is there.
"""

from __future__ import annotations

import pickle
import queue
import threading
import time
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import Any, NamedTuple

from aftdeck import law_cache
from aftdeck.errors import AftdeckError
from aftdeck.exact_pickle import pickled
from aftdeck.law import are_compiled, is_plain, prepare, run_compiled
from aftdeck.law_cache import NotKept, only_kept
from aftdeck.law_folder import compiled_before
from aftdeck.processes import BACKGROUND, Child

FILES = 530
"""Number of files with machine code that a run of a built-in scenario needs; `tests/test_law_change.py` counts them."""
_GUESS_FROM = 0.04
"""Share of the work from which the time left is computed [1]."""
_ENDED = "the process that compiles the laws has ended; is the memory full?"


class CompilationError(AftdeckError):
    """The laws cannot be compiled."""


class Progress(NamedTuple):
    """Progress of a compilation.

    Attributes:
        share: part of the work that is done, 0 to 1 [1].
        left_s: time until its end [s]; None at its beginning, when it is not known.
    """

    share: float
    left_s: float | None


class Counter:
    """Progress of a compilation, from the number of files with machine code that it has written."""

    def __init__(self, files: int, tell: Callable[[Progress], None]) -> None:
        """Begin to count.

        Args:
            files: number of files at the end, roughly.
            tell: called with the progress at the beginning, and after each file.
        """
        self._files, self._tell = files, tell
        self._start, self._done = time.monotonic(), 0
        tell(Progress(0.0, None))

    def add_one(self) -> None:
        """Count one more file."""
        self._done += 1
        share = min(self._done / self._files, 0.99)
        passed = time.monotonic() - self._start
        self._tell(Progress(share, passed / share - passed if share > _GUESS_FROM else None))


class Work(NamedTuple):
    """Call that needs laws: a function of a module, and its arguments, which can be sent to another process."""

    call: Callable[..., None]
    given: tuple[Any, ...]
    files: int = FILES


class Laws:
    """Compiled laws of this process.

    Attributes:
        progress: progress of a compilation; None while none is in progress.
        failure: sentence about the error that ended the last compilation; empty if there was none.
    """

    def __init__(
        self, *, background: bool = True, tell: Callable[[Progress | None], None] = lambda progress: None
    ) -> None:
        """Prepare the compilation.

        Args:
            background: whether this process needs a core for other work, so that the compilation takes what is left.
            tell: called in some thread with each new `progress`.
        """
        self.progress: Progress | None = None
        self.failure = ""
        self._tell = tell
        self._nice = BACKGROUND if background else 0
        self._wanted: queue.SimpleQueue[Work] = queue.SimpleQueue()
        self._child: Child | None = None
        self._lock = threading.Lock()
        self._ended = threading.Event()
        self._ended.set()

    def want(self, call: Callable[..., None], *given: Any, files: int = FILES) -> None:
        """Provide the compiled laws that a call needs, from the disk or by another process.

        A process that has called `run_plain` goes on at once, and uses them from the moment when they are there. In any
        other process they are there on return.

        Args:
            call: function of a module; it calls the laws.
            given: its arguments.
            files: number of files with their machine code, roughly.

        Raises:
            CompilationError: the laws cannot be compiled, in a process that runs no plain Python.
        """
        work = Work(call, given, files)
        if not are_compiled():
            return
        if compiled_before() and _missing(work) is None:
            prepare()
        elif is_plain():
            self._ended.clear()
            self._wanted.put(work)
            threading.Thread(target=self._change_over, name="laws", daemon=True).start()
        else:
            with self._lock:
                self._get(work)

    def wait(self, timeout: float) -> bool:
        """Wait until this process calls compiled laws, or never will; return whether this is so.

        Args:
            timeout: longest time [s].
        """
        return self._ended.wait(timeout)

    def close(self) -> None:
        """End the process that compiles."""
        self._ended.set()
        child = self._child
        if child is not None:
            child.process.kill()

    def _change_over(self) -> None:
        with self._lock:
            try:
                self._get(self._wanted.get())
                if self._wanted.empty():
                    prepare()
            except Exception as error:  # whatever it is, the process goes on with plain Python
                self.failure = str(error)
            if self._wanted.empty():
                self._ended.set()

    def _get(self, work: Work) -> None:
        """Let another process compile the laws of a call, and load them."""
        try:
            self._compile(work)
        except (EOFError, OSError):
            raise CompilationError(_ENDED) from None
        finally:
            self._set(None)
        if (missing := _missing(work)) is not None:
            raise CompilationError(f"the machine code of {missing} was lost after its compilation")

    def _compile(self, work: Work) -> None:
        counter = Counter(work.files, self._set)
        self._child = child = Child(_compile_for, nice=self._nice)
        try:
            child.pipe.send_bytes(pickled(work))
            while (file := child.pipe.recv()) is not None:
                if isinstance(file, str):
                    raise CompilationError(f"the laws cannot be compiled: {file}")
                name, data = file
                if data:
                    law_cache.in_memory[name] = data
                counter.add_one()
        finally:
            child.kill()

    def _set(self, progress: Progress | None) -> None:
        self.progress = progress
        self._tell(progress)


def _missing(work: Work) -> str | None:
    """Load the laws of a call from the disk; return the name of the first one that is not there, None if all are."""
    try:
        with only_kept():
            work.call(*work.given)
    except NotKept as error:
        return str(error)
    return None


def _compile_for(pipe: Connection) -> None:
    """Compile the laws of the call that is received. What the other process runs.

    Args:
        pipe: connection to the process that needs the laws. It gets the name of each file, and its content if it cannot
            be written; at the end, None.
    """

    def tell(name: str) -> None:
        pipe.send((name, law_cache.in_memory.get(name, b"")))

    law_cache.observers.append(tell)
    run_compiled()
    work: Work = pickle.loads(pipe.recv_bytes())
    try:
        work.call(*work.given)
        pipe.send(None)
    except Exception as error:  # any error must reach the process that waits
        pipe.send(f"{type(error).__name__}: {error}")
