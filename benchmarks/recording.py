"""Benchmark of recordings: time to record a step, size of the file, and time to verify the file."""

from __future__ import annotations

import random
import statistics
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from aftdeck.recording.replay import verify
from aftdeck.recording.writer import Recorder
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from benchmarks.measure import Figure, against, percentile

QUEUED, MORE, VERIFIED = 0.02, 0.05, 8.0
"""Promises: mean time to queue a step, and extra time of a recorded step, as shares of the median step without a
recording; verification, as a share of a simulation of the same inputs with frames."""


class Size(NamedTuple):
    """Real time for which a run is recorded [s], and time of the run before that compiles the laws [s]."""

    flown_s: float
    warm_s: float


FULL, TINY = Size(30.0, 2.0), Size(0.5, 0.1)
TURN = 25
"""Number of steps for which the same one of two simulations is recorded."""
SMOOTH = 0.1
"""Fraction of a stick's distance to its next deflection that the stick covers in each step."""


def recording(size: Size) -> list[Figure]:
    """Measure a run with random sticks in real time, without and with a recording, and verify the recording."""
    scenario = load_scenario("first-flight")
    _again(scenario, size.warm_s)  # compiles
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "flight.mcap"
        recorder = Recorder(file, scenario, 0)
        without, steps, appends = _flown(scenario, recorder, size.flown_s)
        recorder.close("stopped")
        if recorder.failure:
            raise RuntimeError(recorder.failure)
        megabytes = file.stat().st_size / 1e6
        empty = _empty(Path(folder) / "empty.mcap", scenario)
        before = _again(scenario, size.flown_s)
        first = _verified(file)
        alone = min(before, _again(scenario, size.flown_s))
        second = min(first, _verified(file))
    more = statistics.median(steps) - statistics.median(without)
    count = f"{len(appends)} steps in {size.flown_s:g} s"
    bare = Figure("step without a recording, median", statistics.median(without), "us", None, "in real time")
    again = Figure("simulation of one second", 1e3 * alone, "ms", None, "processor time, with frames")
    minute = empty + (megabytes - empty) * 60.0 / size.flown_s
    mean = statistics.mean(appends)
    checked = f"processor time, {1.0 / second:.0f} times real time"
    return [
        bare,
        Figure("queueing a step, median", statistics.median(appends), "us", None, count),
        against(bare, QUEUED, "queueing a step, mean", mean, "us", "on the simulation's thread"),
        Figure("queueing a step, 99 %", percentile(appends, 99.0), "us", None, "while the writer's thread runs"),
        against(bare, MORE, "recorded step, extra time", more, "us", "difference of the medians"),
        Figure(
            "file size of one minute", minute, "MB", 1.5, f"random sticks in two modes; {empty:.2f} MB without a step"
        ),
        again,
        against(again, VERIFIED, "verification of one second", 1e3 * second, "ms", checked),
    ]


def _empty(file: Path, scenario: Scenario) -> float:
    """Return the size of a recording without a step [MB]."""
    Recorder(file, scenario, 0).close("stopped")
    return file.stat().st_size / 1e6


def _verified(file: Path) -> float:
    """Return the processor time to verify a recording, for one second of the run [s]."""
    begin = time.process_time()
    verdict = verify(file)
    used = time.process_time() - begin
    if not verdict.equal:
        raise RuntimeError(f"the re-simulation differs from the recording: {verdict.first}")
    return used / verdict.time_s


def _again(scenario: Scenario, span: float) -> float:
    """Return the processor time to simulate the inputs of a run, with frames, for one second of the run [s]."""
    sim = Simulation(scenario)
    begin = time.process_time()
    for inputs in _random_inputs(round(span / scenario.control_period)):
        sim.step(inputs)
    return (time.process_time() - begin) / span


def _flown(scenario: Scenario, recorder: Recorder, span: float) -> tuple[list[float], list[float], list[float]]:
    """Run two simulations of the same inputs in real time; they step in turn, and one of them is recorded.

    Each waits a control period before its next step, as in a station. Both have the same frames, and take turns in
    being recorded, because one of them is always a little slower. The inputs are made before, because what runs after a
    wait is slow.

    Returns:
        Times of the steps without and with a recording, and times to queue a step for the file [us].
    """
    both = Simulation(scenario), Simulation(scenario)
    without: list[float] = []
    steps: list[float] = []
    appends: list[float] = []
    due = time.perf_counter()
    for i, inputs in enumerate(list(_random_inputs(round(span / scenario.control_period)))):
        for simulation in both:
            recorded = simulation is both[i // TURN % 2]
            record = recorder.step if recorded else _not_recorded
            begin = time.perf_counter()
            frame = simulation.step(inputs)
            stepped = time.perf_counter()
            record(inputs, frame, 40.0)
            end = time.perf_counter()
            (steps if recorded else without).append((end - begin) * 1e6)
            if recorded:
                appends.append((end - stepped) * 1e6)
            due = _wait(due + scenario.control_period / 2.0)
    return without, steps, appends


def _not_recorded(inputs: Inputs, frame: Frame, latency_ms: float) -> None:
    """Take a step that is not recorded."""


def _wait(due: float) -> float:
    """Wait until a time of the performance counter [s]; return it."""
    time.sleep(max(0.0, due - time.perf_counter()))
    return due


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
