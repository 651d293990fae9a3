"""Program that records runs in real time and kills each of them.

Usage: ``python -m tests.recording.killed_flights FOLDER COUNT SEED``. It prints a
`Killed` as a line of JSON for each run. It loads the laws once, and then forks a process for each run. No thread is
started before the forks.
"""

from __future__ import annotations

import math
import os
import random
import signal
import struct
import sys
import threading
import time
from pathlib import Path
from types import SimpleNamespace
from typing import NamedTuple, NoReturn

import msgspec

import aftdeck
from aftdeck.recording import index as listing
from aftdeck.recording import writer
from aftdeck.recording.records import Opening
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.warm import warm_up
from tests.waits import WAIT_S

AT_ONCE = 5
"""Number of simultaneous runs; two slow processors are sufficient for them."""
LEAST_S, MOST_S = 0.0, 2.0
"""Range of the random time until a run is killed [s]; this time starts when every simultaneous run has made a step."""
PERIOD_S = 0.02


class Check(NamedTuple):
    """Check of the queue by a recorder's thread."""

    time_s: float
    """Time on the machine's clock."""
    worked_s: float
    """Processor time that the recorder's thread has used so far."""
    process_s: float
    """Processor time that all threads of the process have used so far."""


class Killed(msgspec.Struct):
    """Run that was killed."""

    file: str
    handed_over_s: list[float]
    """Times at which the steps were handed over to the recorder."""
    checks: list[Check]
    killed_s: float
    """Time on the machine's clock at which the process was killed."""
    process_s: float
    """Processor time that it had used then."""


class Index(listing.Index):
    """List of recordings that sets `begun` when a recording is added."""

    def __init__(self) -> None:
        super().__init__()
        self.begun = threading.Event()

    def begin(self, path: Path, opening: Opening) -> None:
        """Add a recording, and set `begun`."""
        super().begin(path, opening)
        self.begun.set()


def fly(scenario: Scenario, path: Path, steps: int, checks: int, seed: int) -> NoReturn:
    """Record a run until the process is killed. Write each recorded step and each check of the queue to a pipe.

    The run starts when the file is in the list of recordings. If the machine pauses, the run does not catch up.
    """

    def monotonic() -> float:
        os.write(checks, struct.pack("ddd", *Check(time.perf_counter(), time.thread_time(), time.process_time())))
        return time.monotonic()

    clock = {name: getattr(time, name) for name in ("perf_counter", "time_ns", "sleep")}
    vars(writer)["time"] = SimpleNamespace(monotonic=monotonic, **clock)
    sim = aftdeck.Simulation(scenario)
    index = Index()
    recorder = writer.Recorder(path, scenario, 0, index=index)
    if not index.begun.wait(WAIT_S):
        raise SystemExit(f"{path} is not in the list of recordings after {WAIT_S:g} s: {recorder.unlisted}")
    due = time.perf_counter()
    while True:
        phase = 0.7 * due + seed
        inputs = Inputs((math.sin(phase), math.cos(3.0 * phase), 0.2), (0.0, math.sin(2.0 * phase), 0.0))
        recorder.step(inputs, sim.step(inputs))
        os.write(steps, struct.pack("d", time.perf_counter()))
        due = max(due + PERIOD_S, time.perf_counter())
        time.sleep(max(due - time.perf_counter(), 0.0))


class ForkedRun:
    """Recorded run in a process of its own."""

    def __init__(self, scenario: Scenario, path: Path, seed: int) -> None:
        self.path = path
        self._steps, steps = os.pipe()
        self._checks, checks = os.pipe()
        self._read_checks: list[Check] = []
        self._process = os.fork()
        if self._process == 0:
            fly(scenario, path, steps, checks, seed)
        os.close(steps)
        os.close(checks)
        self._handed_over: list[float] = []

    def wait_for_first_step(self) -> None:
        """Wait for the first step."""
        (first,) = struct.unpack("d", self._read(self._steps, 8))
        self._handed_over.append(first)

    def wait_for_check(self) -> None:
        """Wait for the next check of the queue by the recorder's thread."""
        now = time.perf_counter()
        while not self._read_checks or self._read_checks[-1].time_s < now:
            self._read_checks.append(Check._make(struct.unpack("ddd", self._read(self._checks, 24))))

    def kill(self) -> Killed:
        """Kill the process, and return the data about its run."""
        os.kill(self._process, signal.SIGKILL)
        _, _, used = os.wait4(self._process, 0)
        killed_s = time.perf_counter()
        with os.fdopen(self._steps, "rb") as steps, os.fdopen(self._checks, "rb") as checks:
            self._handed_over += [t for (t,) in struct.iter_unpack("d", steps.read())]
            self._read_checks += map(Check._make, struct.iter_unpack("ddd", checks.read()))
        return Killed(str(self.path), self._handed_over, self._read_checks, killed_s, used.ru_utime + used.ru_stime)

    def _read(self, pipe: int, count: int) -> bytes:
        data = os.read(pipe, count)
        if len(data) < count:
            raise SystemExit(f"{self.path}: the process ended before it was killed")
        return data


def kill_some(scenario: Scenario, files: list[Path], rng: random.Random) -> None:
    """Record a few runs simultaneously, kill each after a random time, and print the data about them.

    Each run is killed soon after the thread of its recorder has checked the queue.
    """
    runs = [ForkedRun(scenario, path, number) for number, path in enumerate(files)]
    for forked in runs:
        forked.wait_for_first_step()
    begin = time.perf_counter()
    lifetimes = sorted(rng.uniform(LEAST_S, MOST_S) for _ in runs)
    for lifetime, forked in zip(lifetimes, runs, strict=True):
        time.sleep(max(begin + lifetime - time.perf_counter(), 0.0))
        forked.wait_for_check()
        time.sleep(rng.uniform(0.0, 2.0 * writer.POLL_S))  # at any time between two checks
        print(msgspec.json.encode(forked.kill()).decode(), flush=True)


def main(folder: Path, count: int, seed: int) -> None:
    """Record and kill `count` runs, a few at a time."""
    listing.BUSY_S = writer.BEGIN_S = WAIT_S
    scenario = aftdeck.load_scenario("first-flight")
    warm_up(scenario)
    files = [folder / f"killed-{k}.mcap" for k in range(count)]
    rng = random.Random(seed)
    for first in range(0, count, AT_ONCE):
        kill_some(scenario, files[first : first + AT_ONCE], rng)


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]))
