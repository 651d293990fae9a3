"""Run benchmarks, each in a process of its own, and pass on every outcome as it comes."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path

import msgspec

from benchmarks.names import Benchmark
from benchmarks.results import ROOT, Outcome

TINY_LIMIT_S = 600.0
"""Time after which a tiny run of a benchmark is ended [s]. On a new machine it has to compile the laws."""
LAST_OUTPUT = 8000
"""Number of characters of a failed benchmark's output that are kept."""


def run_all(benchmarks: Iterable[tuple[str, Benchmark]], size: str) -> Iterator[Outcome]:
    """Yield the outcome of each benchmark when it has ended.

    Args:
        benchmarks: names and benchmarks.
        size: `FULL` or `TINY`.
    """
    for name, benchmark in benchmarks:
        yield run_one(name, benchmark, size)


def run_one(name: str, benchmark: Benchmark, size: str) -> Outcome:
    """Run a benchmark in a new process. A crash, or a benchmark that does not end, gives an outcome too."""
    limit = TINY_LIMIT_S if size == "TINY" else benchmark.limit_s
    with tempfile.TemporaryDirectory(prefix="bench") as folder:
        file, output = Path(folder) / "outcome.json", Path(folder) / "output.txt"
        arguments = [name, benchmark.module, benchmark.function, size, str(file)]
        begin = time.perf_counter()
        code = call([sys.executable, "-m", "benchmarks.child", *arguments], ROOT, dict(os.environ), output, limit)
        seconds = time.perf_counter() - begin
        said = output.read_text(encoding="utf-8", errors="replace")[-LAST_OUTPUT:]
        if code is None:
            error = f"TimeoutError: did not end within {limit:g} s"
        elif not file.is_file():
            error = f"ChildProcessError: ended with exit code {code}"
        else:
            found = msgspec.json.decode(file.read_bytes(), type=Outcome)
            return msgspec.structs.replace(found, details=f"{found.details}\n{said}") if found.error else found
    return Outcome(name, seconds, error=error, details=said)


def call(
    command: list[str],
    folder: Path,
    environment: dict[str, str],
    output: Path,
    limit_s: float,
    errors: Path | None = None,
) -> int | None:
    """Run a command, and end all processes that it leaves behind.

    Args:
        command: program and arguments.
        folder: its working folder.
        environment: its environment.
        output: file for its standard output.
        limit_s: time after which it is ended [s].
        errors: file for its standard error; None for the same as for its standard output.

    Returns:
        Its exit code; None if it was ended.
    """
    with output.open("wb") as said, (errors or output).open("ab") as complained:
        process = subprocess.Popen(
            command,
            cwd=folder,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=said,
            stderr=complained if errors else subprocess.STDOUT,
            start_new_session=True,  # it and its children are ended together
        )
        try:
            return process.wait(limit_s)
        except subprocess.TimeoutExpired:
            return None
        finally:
            with suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()
