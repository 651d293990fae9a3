"""``python -m benchmarks.child NAME MODULE FUNCTION SIZE FILE``: run one benchmark and write its outcome to a file.

Each benchmark has a process of its own, so that imports, caches, settings of MuJoCo and crashes of one do not affect
the next.
"""

from __future__ import annotations

import os
import sys
import time
import traceback
from importlib import import_module
from pathlib import Path

import msgspec

from benchmarks.measure import Figure
from benchmarks.results import Outcome


def main() -> None:
    """Run the benchmark. An error becomes part of the outcome."""
    name, module, function, size, file = sys.argv[1:]
    os.environ.setdefault("MUJOCO_GL", "egl")  # MuJoCo reads it when it is imported: draw without a display
    begin, about = time.perf_counter(), ""
    try:
        found = import_module(module)
        measure = getattr(found, function)
        about = (measure.__doc__ or "").partition("\n")[0]
        made = list(measure(getattr(found, size)))
        seconds = time.perf_counter() - begin
        figures = tuple(one for one in made if isinstance(one, Figure))
        lines = tuple(one for one in made if isinstance(one, str))
        if not made or len(figures) + len(lines) < len(made):
            raise TypeError(f"{module}.{function} returned {made!r}; expected figures or lines of a table")
        if len({figure.name for figure in figures}) < len(figures):
            raise ValueError(f"{module}.{function} has two figures of the same name: {[one.name for one in figures]}")
        outcome = Outcome(name, seconds, about, figures, lines)
    except Exception as error:  # whatever it is, the other benchmarks run
        seconds, details = time.perf_counter() - begin, traceback.format_exc()
        outcome = Outcome(name, seconds, about, error=_line(error), details=details)
    Path(file).write_bytes(msgspec.json.encode(outcome))


def _line(error: Exception) -> str:
    """Return the type and the message of an error in one line."""
    return f"{type(error).__name__}: {' '.join(str(error).split())}"[:300]


if __name__ == "__main__":
    main()
