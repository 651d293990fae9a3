"""Benchmark of the report of a ten-minute run: the whole command, as a user starts it."""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

from aftdeck.operators.pilot import pilot
from aftdeck.operators.spec import OperatorSpec
from aftdeck.recording.run import record
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from benchmarks.measure import Figure

SCENARIO = "concept-1972"
PROMISED_S = 5.0
"""Promised time of the command, with a page of one run [s]."""


class Size(NamedTuple):
    """Extent of the measurement.

    Attributes:
        long_s: duration of the run [s].
        rounds: number of commands of which the shortest counts.
        many: number of runs on a page with several runs.
    """

    long_s: float
    rounds: int
    many: int


FULL, TINY = Size(600.0, 3, 4), Size(10.0, 1, 2)


def report(size: Size) -> list[Figure]:
    """Measure the page of one run, and of several runs."""
    with tempfile.TemporaryDirectory() as name:
        files = [Path(name) / f"{k}.mcap" for k in range(size.many)]
        _record(files[0], size.long_s)
        for file in files[1:]:
            shutil.copyfile(files[0], file)
        note = f"{SCENARIO}, {size.long_s:g} s of flight"
        return [
            Figure("page of one run", _command(files[:1], size.rounds), "s", PROMISED_S, note),
            Figure(f"page of {size.many} runs", _command(files, size.rounds), "s", None, note),
        ]


def _record(file: Path, long_s: float) -> None:
    """Record a run in which synthetic operators fly the task again and again."""
    scenario, seed = load_scenario(SCENARIO), 1
    flown = pilot(scenario, OperatorSpec("human"), seed)

    def inputs(sim: Simulation) -> Inputs | None:
        nonlocal flown, seed
        if sim.frame is not None and sim.frame.time_s >= long_s:
            return None
        given = flown(sim)
        if given is None:
            seed += 1
            flown = pilot(scenario, OperatorSpec("human"), seed)
            if sim.frame is not None:
                flown.progress.see(sim.frame)
        return given or Inputs()

    record(scenario, file, inputs=inputs)


def _command(files: list[Path], rounds: int) -> float:
    """Return the shortest time of the command [s]."""
    times = []
    for _ in range(rounds):
        page = files[0].with_suffix(".html")
        begin = time.perf_counter()
        command = [sys.executable, "-m", "aftdeck", "report", *map(str, files), "-o", str(page)]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        times.append(time.perf_counter() - begin)
        page.unlink()
    return min(times)
