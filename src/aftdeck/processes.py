"""Worker processes, as a study and a report of several runs start them."""

from __future__ import annotations

import multiprocessing
import multiprocessing.connection
import os
import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

ONE_THREAD = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")
"""Variables that limit the threads of libraries: the processes already use all cores."""


def cores() -> int:
    """Return the number of cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class Child:
    """Process with a pipe to this one. It leaves Ctrl-C to this process, and ends with it.

    Attributes:
        pipe: this process's end of the pipe.
        process: the process.
    """

    def __init__(self, target: Callable[..., None], *given: Any) -> None:
        """Start a process, which calls a function.

        Args:
            target: function of a module; its first argument is the process's end of the pipe.
            given: its other arguments, which are sent to the process.
        """
        context = multiprocessing.get_context("spawn")
        self.pipe, theirs = context.Pipe()
        self.process = context.Process(target=_obedient, args=(target, theirs, *given), daemon=True)
        with _one_thread():
            self.process.start()
        theirs.close()

    def kill(self) -> None:
        """End the process at once."""
        self.process.kill()
        self.process.join()
        self.pipe.close()


def _obedient(target: Callable[..., None], *given: Any) -> None:
    _obey_parent()
    target(*given)


@contextmanager
def _one_thread() -> Iterator[None]:
    """Set the variables of `ONE_THREAD` for the processes that start meanwhile."""
    before = {name: os.environ.get(name) for name in ONE_THREAD}
    os.environ.update(dict.fromkeys(ONE_THREAD, "1"))
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                os.environ.pop(name, None)
            else:
                os.environ[name] = value


def _obey_parent() -> None:
    """Leave Ctrl-C to the parent process, and end this process as soon as the parent has ended."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    if parent is None:
        return
    sentinel = parent.sentinel

    def wait() -> None:
        multiprocessing.connection.wait([sentinel])
        os._exit(1)

    threading.Thread(target=wait, name="parent", daemon=True).start()
