"""Compilation of the laws that draw pictures, in a process of low priority.

To compile them in a thread of the station would delay the control steps for half a minute.
"""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys

from aftdeck import visual
from aftdeck.law import compiled_before

NICE = 10
"""Difference between the priorities of the process and of the station: each level is about a fifth of a busy core."""
COMMAND = (sys.executable, "-m", f"{visual.__name__}.warm")


def start_to_compile() -> subprocess.Popen[bytes] | None:
    """Start to compile the laws into the cache on disk; return None if they are there, or if laws are not compiled."""
    if compiled_before("visual") or os.environ.get("NUMBA_DISABLE_JIT", "0") != "0":
        return None
    # Ctrl+C in the terminal goes to the station alone, which ends the process.
    process = subprocess.Popen(COMMAND, stdin=subprocess.DEVNULL, process_group=0)
    with contextlib.suppress(ProcessLookupError):
        os.setpriority(os.PRIO_PROCESS, process.pid, os.getpriority(os.PRIO_PROCESS, 0) + NICE)
    return process
