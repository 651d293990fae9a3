"""A flight where nothing is there but the simulation: ``python -m tests.elsewhere SCENARIO STEPS``.

The server's, the recording's and the terminal's libraries are missing, no thread can be started, and once the scenario
is loaded no file can be opened.
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
    """Finds none of the missing libraries, and leaves the others to who comes after it."""

    def find_spec(self, name: str, path: Sequence[str] | None, target: ModuleType | None = None) -> ModuleSpec | None:
        """As the import system asks for it."""
        if name.partition(".")[0] in MISSING:
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)
        return None


def _refused(*given: Any, **_: Any) -> NoReturn:
    raise AssertionError(f"not while it flies: {given}")


def main(name: str, steps: int) -> None:
    """Fly a scenario's script for some steps and print how far it came [s]."""
    sys.meta_path.insert(0, _Missing())
    from aftdeck.simulation.run import Simulation  # noqa: PLC0415, only now are they missing

    sim = Simulation(name)
    threading.Thread.start = _refused  # type: ignore[method-assign]
    builtins.open = io.open = os.open = _refused
    for _ in range(steps):
        frame = sim.step()
    print(frame.time_s)


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
