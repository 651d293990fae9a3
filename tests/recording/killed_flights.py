"""A program that records flights at real-time pace and kills each of them: ``killed_flights.py FOLDER COUNT SEED``.

Prints a line of JSON, a `Killed`, for each. The laws are loaded once, then each flight is a fork; nothing starts a
thread before that.
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

AT_ONCE = 5
"""So few that each has its share of two slow processors."""
LEAST_S, MOST_S = 0.0, 2.0
"""A flight lives for a time between these, from the first step of the last of those that fly at once."""
PERIOD_S = 0.02
WAIT_S = 60.0
"""The longest that anything is waited for [s]."""


class Look(NamedTuple):
    """A writer looks for what waits to be written."""

    time_s: float
    """On the machine's clock."""
    worked_s: float
    """The processor's time that the writer's thread has had so far."""


class Killed(msgspec.Struct):
    """A flight that was killed."""

    file: str
    handed_over_s: list[float]
    """When each step was handed over to the recorder."""
    looks: list[Look]


class Index(listing.Index):
    """A list of recordings that tells once a recording is in it."""

    def __init__(self) -> None:
        super().__init__()
        self.begun = threading.Event()

    def begin(self, path: Path, opening: Opening) -> None:
        """A recording has begun."""
        super().begin(path, opening)
        self.begun.set()


def fly(scenario: Scenario, path: Path, steps: int, looks: int, seed: int) -> NoReturn:
    """Fly into a file until killed; tell one pipe of each step that was handed over, one of the writer's looks.

    It flies once the file is in the list, to which a thread of the recorder's sees. Where the machine pauses, the
    flight does, and does not catch up.
    """

    def look() -> float:
        os.write(looks, struct.pack("dd", *Look(time.perf_counter(), time.thread_time())))
        return time.monotonic()

    clock = {name: getattr(time, name) for name in ("perf_counter", "time_ns", "sleep")}
    vars(writer)["time"] = SimpleNamespace(monotonic=look, **clock)
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


class Flight:
    """A flight under way in a process of its own."""

    def __init__(self, scenario: Scenario, path: Path, seed: int) -> None:
        self.path = path
        self._steps, steps = os.pipe()
        self._looks, looks = os.pipe()
        self._seen: list[Look] = []
        self._process = os.fork()
        if self._process == 0:
            fly(scenario, path, steps, looks, seed)
        os.close(steps)
        os.close(looks)
        self._handed_over: list[float] = []

    def begins(self) -> None:
        """Wait for its first step."""
        (first,) = struct.unpack("d", self._read(self._steps, 8))
        self._handed_over.append(first)

    def look(self) -> None:
        """Wait for its writer to look for what waits, from now on."""
        now = time.perf_counter()
        while not self._seen or self._seen[-1].time_s < now:
            self._seen.append(Look._make(struct.unpack("dd", self._read(self._looks, 16))))

    def kill(self) -> Killed:
        """Kill it; what is known of it."""
        os.kill(self._process, signal.SIGKILL)
        os.waitpid(self._process, 0)
        with os.fdopen(self._steps, "rb") as steps, os.fdopen(self._looks, "rb") as looks:
            self._handed_over += [t for (t,) in struct.iter_unpack("d", steps.read())]
            self._seen += map(Look._make, struct.iter_unpack("dd", looks.read()))
        return Killed(str(self.path), self._handed_over, self._seen)

    def _read(self, pipe: int, count: int) -> bytes:
        data = os.read(pipe, count)
        if len(data) < count:
            raise SystemExit(f"{self.path}: the flight ended before it was killed")
        return data


def some(scenario: Scenario, files: list[Path], rng: random.Random) -> None:
    """Fly a few flights at once, kill each after a random time, and print what is known of them.

    Each is killed soon after its writer has looked for what waits: one that no longer does is waited for in vain.
    """
    flights = [Flight(scenario, path, number) for number, path in enumerate(files)]
    for flight in flights:
        flight.begins()
    begin = time.perf_counter()
    lifetimes = sorted(rng.uniform(LEAST_S, MOST_S) for _ in flights)
    for lifetime, flight in zip(lifetimes, flights, strict=True):
        time.sleep(max(begin + lifetime - time.perf_counter(), 0.0))
        flight.look()
        time.sleep(rng.uniform(0.0, 2.0 * writer.POLL_S))  # anywhere between two looks
        print(msgspec.json.encode(flight.kill()).decode(), flush=True)


def main(folder: Path, count: int, seed: int) -> None:
    """Fly and kill `count` flights, a few at a time."""
    listing.BUSY_S = writer.BEGIN_S = WAIT_S
    scenario = aftdeck.load_scenario("first-flight")
    warm_up(scenario)
    files = [folder / f"killed-{k}.mcap" for k in range(count)]
    rng = random.Random(seed)
    for first in range(0, count, AT_ONCE):
        some(scenario, files[first : first + AT_ONCE], rng)


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]))
