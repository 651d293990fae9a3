"""Benchmark of recordings: time to record a step, size of the file, and time to verify the file."""

from __future__ import annotations

import random
import statistics
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from aftdeck.recording.replay import verify
from aftdeck.recording.writer import Recorder
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from benchmarks.measure import Figure, percentile

FLOWN_S = 30.0
"""Real time for which a run is recorded [s]."""
SMOOTH = 0.1
"""Fraction of a stick's distance to its next deflection that the stick covers in each step."""


def recording() -> list[Figure]:
    """Measure a run with random sticks in real time, without and with a recording, and verify the recording."""
    scenario = load_scenario("first-flight")
    _flown(scenario, None, 2.0)  # compiles
    bare, _ = _flown(scenario, None, FLOWN_S)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "flight.mcap"
        recorder = Recorder(file, scenario, 0)
        steps, appends = _flown(scenario, recorder, FLOWN_S)
        recorder.close("stopped")
        if recorder.failure:
            raise RuntimeError(recorder.failure)
        size = file.stat().st_size / 1e6 / (FLOWN_S / 60.0)
        begin = time.perf_counter()
        verdict = verify(file)
        speed = verdict.time_s / (time.perf_counter() - begin)
        if not verdict.equal:
            raise RuntimeError(f"the re-simulation differs from the recording: {verdict.first}")
    more = statistics.median(steps) - statistics.median(bare)
    count = f"{len(appends)} steps in {FLOWN_S:g} s"
    return [
        Figure("queueing a step, median", statistics.median(appends), "us", None, count),
        Figure("queueing a step, mean", statistics.mean(appends), "us", 30.0, "on the simulation's thread"),
        Figure("queueing a step, 99 %", percentile(appends, 99.0), "us", None, "while the writer's thread runs"),
        Figure("recorded step, extra time", more, "us", 30.0, "median, compared with the run without a recording"),
        Figure("file size of one minute", size, "MB", 1.5, "random sticks in ORB UNL and END EFF"),
        Figure("verification of one second", 1000.0 / speed, "ms", 30.0, f"{speed:.0f} times real time"),
    ]


def _flown(scenario: Scenario, recorder: Recorder | None, span: float) -> tuple[list[float], list[float]]:
    """Run in real time; return the time of each step, and how long it takes to queue the step for the file [us]."""
    sim = Simulation(scenario)
    steps, appends = [], []
    due = time.perf_counter()
    for inputs in _random_inputs(round(span / scenario.control_period)):
        begin = time.perf_counter()
        frame = sim.step(inputs)
        stepped = time.perf_counter()
        if recorder is not None:
            recorder.step(inputs, frame, 40.0)
        end = time.perf_counter()
        steps.append((end - begin) * 1e6)
        appends.append((end - stepped) * 1e6)
        due += scenario.control_period
        time.sleep(max(0.0, due - time.perf_counter()))
    return steps, appends


def _random_inputs(count: int) -> Iterator[Inputs]:
    """Yield the inputs of `count` steps, with smoothly moving sticks and some changes of mode."""
    chance = random.Random(4)
    at, to = [0.0] * 6, [0.0] * 6
    for step in range(count):
        if step % 25 == 0:
            to = [chance.uniform(-1.0, 1.0) if chance.random() < SMOOTH * 6 else 0.0 for _ in at]
        at = [round(a + SMOOTH * (b - a), 3) for a, b in zip(at, to, strict=True)]  # rounded as in the page's messages
        mode = chance.choice(("ORB UNL", "END EFF")) if step % 250 == 0 else None
        yield Inputs((at[0], at[1], at[2]), (at[3], at[4], at[5]), mode=mode)
