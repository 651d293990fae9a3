"""A program that records flights at real-time pace and kills each of them: ``killed_flights.py FOLDER COUNT SEED``.

Prints, for each, a line of JSON: the file, and when each step was handed over, to the moment of the kill [s]. The
laws are loaded once, then each flight is a fork; nothing starts a thread before that.
"""

from __future__ import annotations

import json
import math
import os
import random
import signal
import struct
import sys
import time
from pathlib import Path

import aftdeck
from aftdeck.recording.index import Index
from aftdeck.recording.writer import Recorder
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.warm import warm_up

AT_ONCE = 10
LEAST_S, MOST_S = 0.0, 2.5
"""A flight lives for a time between these, from the first step of the last of those that fly at once."""
PERIOD_S = 0.02


def fly(scenario: Scenario, path: Path, pipe: int, seed: int) -> None:
    """Fly into a file until killed; tell of each step once it has been handed over."""
    sim = aftdeck.Simulation(scenario)
    recorder = Recorder(path, scenario, 0, index=Index())
    due = time.perf_counter()
    while True:
        phase = 0.7 * due + seed
        inputs = Inputs((math.sin(phase), math.cos(3.0 * phase), 0.2), (0.0, math.sin(2.0 * phase), 0.0))
        recorder.step(inputs, sim.step(inputs))
        os.write(pipe, struct.pack("d", time.perf_counter()))
        due += PERIOD_S
        time.sleep(max(due - time.perf_counter(), 0.0))


def some(scenario: Scenario, files: list[Path], seed: int) -> None:
    """Fly a few flights at once, kill each after a random time, and print what they told."""
    rng = random.Random(seed)
    flights = []
    for number, path in enumerate(files):
        out, pipe = os.pipe()
        process = os.fork()
        if process == 0:
            os.close(out)
            fly(scenario, path, pipe, number)
        os.close(pipe)
        flights.append((rng.uniform(LEAST_S, MOST_S), process, out, path))
    first = {path: os.read(out, 8) for _, _, out, path in flights}  # all fly
    begin = time.perf_counter()
    for lifetime, process, out, path in sorted(flights):
        time.sleep(max(begin + lifetime - time.perf_counter(), 0.0))
        os.kill(process, signal.SIGKILL)
        os.waitpid(process, 0)
        told = first[path]
        while part := os.read(out, 65536):
            told += part
        os.close(out)
        times = [t for (t,) in struct.iter_unpack("d", told)]
        print(json.dumps({"file": str(path), "handed_over": times}), flush=True)


def main(folder: Path, count: int, seed: int) -> None:
    """Fly and kill `count` flights, ten at a time."""
    scenario = aftdeck.load_scenario("first-flight")
    warm_up(scenario)
    files = [folder / f"killed-{k}.mcap" for k in range(count)]
    for first in range(0, count, AT_ONCE):
        some(scenario, files[first : first + AT_ONCE], seed + first)


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]))
