"""Durations of the tests: kept in `durations.json`, compared after a run (`order.py` uses them too).

A test is a function; its parameters' times are summed, with its fixtures. ``AFTDECK_DURATIONS=write`` writes the times
of a run into the file, ``AFTDECK_DURATIONS=show`` compares them with the file. Times differ between machines: the
comparison scales the old times by the median of all ratios.
"""

from __future__ import annotations

import json
import os
import statistics
from collections import Counter
from collections.abc import Iterable
from pathlib import Path

import pytest

FILE = Path(__file__).with_name("durations.json")
VARIABLE = "AFTDECK_DURATIONS"
SHORTEST_S = 0.05
"""Time below which a test is not kept [s]."""
COUNT = 10
"""Number of tests that are shown."""
BUDGET_S = {
    "browser": 240.0,
    "simulation": 150.0,
    "station": 120.0,
    "steering": 120.0,
    "gym": 60.0,
    "recording": 60.0,
    "report": 60.0,
    "plant": 60.0,
}
"""Time of a folder's quick tests, in one process [s]; `OTHERS_S` for a folder that is not listed."""
OTHERS_S = 30.0


def function_of(nodeid: str) -> str:
    """Return a test's name without its parameters."""
    return nodeid.partition("[")[0]


def folder_of(nodeid: str) -> str:
    """Return the folder of a test inside ``tests/``; ``.`` for a module in ``tests/`` itself."""
    parts = nodeid.partition("::")[0].split("/")
    return parts[1] if len(parts) > 2 else "."


def kept() -> dict[str, float]:
    """Return the kept times [s] of the tests by their names."""
    found: dict[str, float] = json.loads(FILE.read_text(encoding="utf-8")) if FILE.is_file() else {}
    return found


class Durations:
    """Plugin of pytest that sums the times of the tests, shows them, and writes them."""

    def __init__(self) -> None:
        self.seconds: Counter[str] = Counter()

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        self.seconds[function_of(report.nodeid)] += report.duration  # type: ignore[assignment]

    def pytest_terminal_summary(self, terminalreporter: pytest.TerminalReporter) -> None:
        wish = os.environ.get(VARIABLE, "")
        if not wish or not self.seconds:
            return
        before = kept()
        terminalreporter.section("durations")
        for line in summary(dict(self.seconds), before):
            terminalreporter.line(line)
        if wish == "write":
            write({**before, **self.seconds}, self.seconds)


def write(times: dict[str, float], run: Iterable[str]) -> None:
    """Write the times into the file, without the short tests of `run`, and without tests that do not exist."""
    short = {name for name in run if times[name] < SHORTEST_S}
    rows = {name: round(seconds, 2) for name, seconds in sorted(times.items()) if name not in short and _exists(name)}
    FILE.write_text(json.dumps(rows, indent=0) + "\n", encoding="utf-8")


def _exists(name: str) -> bool:
    module, _, function = name.partition("::")
    path = FILE.parents[1] / module
    return path.is_file() and f"def {function.rpartition('::')[2]}(" in path.read_text(encoding="utf-8")


def summary(now: dict[str, float], before: dict[str, float]) -> list[str]:
    """Return the lines that compare the times of a run with the kept ones."""
    both = [name for name in now if name in before]
    ratios = [now[name] / before[name] for name in both if before[name] >= 10 * SHORTEST_S]
    scale = statistics.median(ratios) if ratios else 1.0
    lines = [
        f"total {sum(now.values()):.0f} s; the same tests in {FILE.name}: {sum(before[name] for name in both):.0f} s"
        f" (median ratio {scale:.2f})",
        f"tests that grew most (time, and the kept time x {scale:.2f}):",
    ]
    grown = sorted(now, key=lambda name: before.get(name, 0.0) * scale - now[name])
    lines += [f"{now[name]:8.1f} s {before.get(name, 0.0) * scale:8.1f} s  {name}" for name in grown[:COUNT]]
    folders = Counter[str]()
    for name, seconds in now.items():
        folders[folder_of(name)] += seconds  # type: ignore[assignment]
    lines.append("folders (time in one process, and budget of the quick tests):")
    for name, seconds in folders.most_common():
        budget = BUDGET_S.get(name, OTHERS_S)
        lines.append(f"{seconds:8.1f} s {budget:8.0f} s  {name}{'  OVER' if seconds > budget * scale else ''}")
    return lines
