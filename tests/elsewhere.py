"""Program that runs a scenario under restrictions: ``python -m tests.elsewhere SCENARIO STEPS``.

The libraries of server, recording and terminal cannot be imported. After the scenario is loaded, no thread can be
started and no file can be opened.
"""

from __future__ import annotations

import builtins
import importlib.abc
import io
import os
import sys
import threading
from collections.abc import Sequence
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import Any, NoReturn

MISSING = frozenset({"foxglove", "mcap", "rich", "starlette", "typer", "uvicorn", "websockets", "zstandard"})


class _Missing(importlib.abc.MetaPathFinder):
    """Finder that raises an error for the missing libraries, and leaves other modules to the next finder."""

    def find_spec(self, name: str, path: Sequence[str] | None, target: ModuleType | None = None) -> ModuleSpec | None:
        """Raise ModuleNotFoundError for a missing library; otherwise return None."""
        if name.partition(".")[0] in MISSING:
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)
        return None


def _refused(*given: Any, **_: Any) -> NoReturn:
    raise AssertionError(f"not allowed during a run: {given}")


def main(name: str, steps: int) -> None:
    """Run a scenario's script for some steps, and print the simulated time [s]."""
    sys.meta_path.insert(0, _Missing())
    from aftdeck.simulation.run import Simulation  # noqa: PLC0415, imported after the libraries were made missing

    sim = Simulation(name)
    threading.Thread.start = _refused  # type: ignore[method-assign]
    builtins.open = io.open = os.open = _refused
    for _ in range(steps):
        frame = sim.step()
    print(frame.time_s)


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
