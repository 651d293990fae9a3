"""Recordings of hours: the file stays small, and memory does not grow."""

from __future__ import annotations

import itertools
import os
import subprocess
import time
from pathlib import Path
from types import SimpleNamespace

import msgspec
import numpy as np
import pytest

import aftdeck
from aftdeck.recording import writer
from aftdeck.recording.reader import Recording
from aftdeck.recording.writer import Recorder
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from tests.each import number
from tests.steering.flying import scenario
from tests.steering.random_runs import inputs

HOUR_S = 3600.0
WARM_S = 600.0
"""Initial time in which growth of the memory is not counted [s]."""
MAX_GROWTH = 8e6
"""Maximum growth of the memory for each hour [bytes]; the index of the file causes most of the growth."""
LENGTH_S = number(1, 2) * HOUR_S
"""Duration of the long recording [s]."""
MAX_MINUTE_SIZE = 1.5e6
"""Maximum size of a recording for each minute [bytes]."""


def memory() -> int:
    """Return the resident memory [bytes]."""
    return int(subprocess.check_output(["ps", "-o", "rss=", "-p", str(os.getpid())])) * 1024


def steps_of(made: aftdeck.Scenario, count: int) -> list[tuple[Inputs, Frame]]:
    """Return inputs and frames of a run with random inputs."""
    sim = aftdeck.Simulation(made)
    operator = inputs(np.random.default_rng(8), sim)
    return [(given, sim.step(given)) for given, _ in zip(operator, range(count), strict=False)]


def record_long_run(path: Path, made: aftdeck.Scenario, seconds: float, patch: pytest.MonkeyPatch) -> dict[float, int]:
    """Record a long run; return the memory in use [bytes] at each of several simulated times [s].

    One minute is simulated, and its steps are recorded repeatedly. The recorder's clock advances one control period at
    each check of the queue, so that a chunk of the file has as many steps as in real time.
    """
    period = made.control_period
    flown = steps_of(made, round(60.0 / period))
    checks = itertools.count()
    clock = {name: getattr(time, name) for name in ("perf_counter", "time_ns", "sleep")}
    patch.setattr(writer, "time", SimpleNamespace(monotonic=lambda: next(checks) * period, **clock))
    patch.setattr(writer, "MAX_WAITING", 2000)
    recorder = Recorder(path, made, 0)
    used = {}
    for k in range(round(seconds / period)):
        given, frame = flown[k % len(flown)]
        time_s = round((k + 1) * period, 9)
        recorder.step(given, msgspec.structs.replace(frame, tick=k + 1, time_s=time_s))
        recorder.take_turns()
        if k % 2000 == 0:
            used[time_s] = memory()
    recorder.close("stopped")
    assert recorder.failure == ""
    return used


@pytest.mark.slow
def test_memory_does_not_grow_over_hours(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "long.mcap"
    used = record_long_run(path, scenario(extra="control_period = 0.08"), LENGTH_S, monkeypatch)
    warm = max(size for when, size in used.items() if when < WARM_S)
    assert max(used.values()) - warm < MAX_GROWTH * LENGTH_S / HOUR_S
    assert path.stat().st_size < MAX_MINUTE_SIZE * LENGTH_S / 60.0
    recording = Recording(path)
    assert sum(1 for _ in recording.steps()) == round(LENGTH_S / 0.08)
    assert recording.ended == "stopped" and recording.time_s == pytest.approx(LENGTH_S)


@pytest.mark.slow
def test_minute_of_random_inputs_takes_at_most_1_5_megabytes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "busy.mcap"
    record_long_run(path, scenario(), 300.0, monkeypatch)
    assert path.stat().st_size / 5.0 <= MAX_MINUTE_SIZE
