"""Processes that work for this one, such as those of a study, and that end with it.

``python -m aftdeck.processes PIPE`` is such a process. It watches the process that started it before it imports
anything else, so that it ends at once however that process ends, even by SIGKILL, and whatever it is doing.
"""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import signal
import subprocess
import sys
import threading
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import Any

ONE_THREAD = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")
"""Variables that limit the threads of libraries: the processes already use all cores."""
CHILD = "AFTDECK_CHILD"
"""Variable that is set in each process that this program starts."""
BACKGROUND = 10
"""Difference between the priorities of a process that works in the background of a station, and of the station."""


def cores() -> int:
    """Return the number of cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class Child:
    """Process with a pipe to this one. Ctrl-C in a terminal does not reach it, and it ends with this process.

    Attributes:
        pipe: this process's end of the pipe.
        process: the process. It has the other end of its standard input, and reads there that this process has ended.
    """

    def __init__(self, target: Callable[..., None], *given: Any, nice: int = 0) -> None:
        """Start a process, which calls a function.

        Args:
            target: function of a module; its first argument is the process's end of the pipe.
            given: its other arguments, which are sent to the process.
            nice: difference between the priorities of the process and of this one: each level is about a fifth of a
                busy core.
        """
        self.pipe, theirs = multiprocessing.Pipe()
        with theirs:
            self.process = subprocess.Popen(
                [sys.executable, "-m", __name__, str(theirs.fileno())],
                stdin=subprocess.PIPE,
                pass_fds=[theirs.fileno()],
                env=os.environ | dict.fromkeys((*ONE_THREAD, CHILD), "1"),
                # In a session of its own it would also be in a scheduling group of its own, and its priority would not
                # count against this process.
                process_group=0,
            )
        with contextlib.suppress(ProcessLookupError):
            os.setpriority(os.PRIO_PROCESS, self.process.pid, os.getpriority(os.PRIO_PROCESS, 0) + nice)
        with contextlib.suppress(OSError):  # the process has ended, which its closed pipe tells
            self.pipe.send(sys.path)
            self.pipe.send((target, given))

    def kill(self) -> None:
        """End the process at once."""
        self.process.kill()
        self.process.wait()
        self.pipe.close()
        assert self.process.stdin is not None
        self.process.stdin.close()


def main() -> None:
    """Call the function that the other process sends; end as soon as that process has ended."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, name="parent", daemon=True).start()
    with Connection(int(sys.argv[1])) as pipe, contextlib.suppress(EOFError):
        sys.path[:] = pipe.recv()
        target, given = pipe.recv()  # imports the modules of both
        target(pipe, *given)


def _end_with_parent() -> None:
    """Wait until no process has the other end of standard input, and end this process."""
    os.read(sys.stdin.fileno(), 1)
    os._exit(1)


if __name__ == "__main__":
    main()
