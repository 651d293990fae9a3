"""File of results: a line of JSON with machine, date and commit, then a line for each benchmark, written at its end."""

from __future__ import annotations

import os
import platform
import subprocess
from datetime import UTC, datetime
from pathlib import Path

import msgspec

from benchmarks.measure import Figure

ROOT = Path(__file__).resolve().parent.parent
FOLDER = ROOT / "build" / "bench"
"""Folder of the results, which git ignores."""
FOLDER_VARIABLE = "AFTDECK_BENCH_RESULTS"
"""Environment variable that names another folder for them."""


class Machine(msgspec.Struct, frozen=True):
    """Description of a machine.

    Attributes:
        processor: name of the processor.
        cores: number of processors that the system sees.
        system: operating system.
        python: version of Python.
    """

    processor: str
    cores: int
    system: str
    python: str


class Head(msgspec.Struct, frozen=True):
    """First line of the file.

    Attributes:
        machine: where the benchmarks ran.
        date: time of the start, in UTC.
        commit: commit of the source; with "+" if files were changed since, empty outside a git repository.
        size: `FULL` or `TINY`.
        busy: load average at the start: number of other running processes. None if the system does not tell it.
    """

    machine: Machine
    date: str
    commit: str
    size: str
    busy: float | None


class Outcome(msgspec.Struct, frozen=True):
    """Result of one benchmark.

    Attributes:
        benchmark: its name.
        seconds: how long it took [s].
        about: first line of its description.
        figures: what it measured; empty if it failed.
        lines: lines of its table, if it makes one.
        error: type and message of its error, in one line; empty if it succeeded.
        details: traceback and last output of a benchmark that failed.
    """

    benchmark: str
    seconds: float
    about: str = ""
    figures: tuple[Figure, ...] = ()
    lines: tuple[str, ...] = ()
    error: str = ""
    details: str = ""


def here(size: str) -> Head:
    """Return the first line of a file of results that begins now."""
    return Head(machine(), f"{datetime.now(UTC):%Y-%m-%d %H:%M} UTC", commit_of(ROOT), size, _busy())


def machine() -> Machine:
    """Return a description of this machine."""
    return Machine(_processor(), os.cpu_count() or 1, platform.platform(), platform.python_version())


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    lines = info.read_text(encoding="utf-8").splitlines() if info.is_file() else []
    found = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return found[0] if found else platform.processor() or platform.machine()


def _busy() -> float | None:
    try:
        return round(os.getloadavg()[0], 2)
    except (AttributeError, OSError):
        return None


def commit_of(root: Path) -> str:
    """Return the commit of a working tree, with "+" if its files were changed; empty if it is not a git repository."""
    try:
        commit = git(root, "rev-parse", "--short=10", "HEAD")
        return commit + ("+" if git(root, "status", "--porcelain", "--untracked-files=no") else "")
    except (OSError, subprocess.CalledProcessError):
        return ""


def git(root: Path, *arguments: str) -> str:
    """Return what a git command prints."""
    return subprocess.run(["git", *arguments], cwd=root, check=True, capture_output=True, text=True).stdout.strip()


def new_file() -> Path:
    """Return the default path of a file of results that begins now."""
    return Path(os.environ.get(FOLDER_VARIABLE, FOLDER)) / f"{datetime.now(UTC):%Y-%m-%d-%H%M%S}.jsonl"


def begin(path: Path, head: Head) -> None:
    """Write the first line of a file of results. An existing file is replaced."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(msgspec.json.encode(head) + b"\n")


def append(path: Path, row: msgspec.Struct) -> None:
    """Append one line to a file of results."""
    with path.open("ab") as file:
        file.write(msgspec.json.encode(row) + b"\n")


def read(path: Path) -> tuple[Head, list[Outcome]]:
    """Return the content of a file of results."""
    first, *rest = path.read_bytes().splitlines()
    return msgspec.json.decode(first, type=Head), [msgspec.json.decode(line, type=Outcome) for line in rest]
