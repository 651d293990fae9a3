"""Two hours of flight: the file stays small, and memory flat."""

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
from tests.steering.flying import scenario
from tests.steering.test_promises import inputs

HOUR_S = 3600.0
WARM_S = 600.0
"""What a program still fetches at its beginning is not counted [s]."""
MOST_GROWN = 16e6
"""Of memory in what is left of two hours: the file's index, kept for its end [bytes]."""
MOST_A_MINUTE = 1.5e6


def memory() -> int:
    """Resident memory [bytes]."""
    return int(subprocess.check_output(["ps", "-o", "rss=", "-p", str(os.getpid())])) * 1024


def steps_of(made: aftdeck.Scenario, count: int) -> list[tuple[Inputs, Frame]]:
    """A flight with random sticks and switches."""
    sim = aftdeck.Simulation(made)
    operator = inputs(np.random.default_rng(8), sim)
    return [(given, sim.step(given)) for given, _ in zip(operator, range(count), strict=False)]


def long_flight(path: Path, made: aftdeck.Scenario, seconds: float, patch: pytest.MonkeyPatch) -> dict[float, int]:
    """A long flight into a file, chunks closed at least as often as at real-time pace; memory by time [s].

    A minute is flown; its steps are handed over again and again. The writer's clock goes a step each time it looks.
    """
    period = made.control_period
    flown = steps_of(made, round(60.0 / period))
    looks = itertools.count()
    clock = {name: getattr(time, name) for name in ("perf_counter", "time_ns", "sleep")}
    patch.setattr(writer, "time", SimpleNamespace(monotonic=lambda: next(looks) * period, **clock))
    patch.setattr(writer, "MAX_WAITING", 2000)
    recorder = Recorder(path, made, 0)
    used = {}
    for k in range(round(seconds / period)):
        given, frame = flown[k % len(flown)]
        time_s = round((k + 1) * period, 9)
        recorder.step(given, msgspec.structs.replace(frame, tick=k + 1, time_s=time_s))
        recorder.wait_for_room()
        if k % 2000 == 0:
            used[time_s] = memory()
    recorder.close("stopped")
    assert recorder.failure == ""
    return used


@pytest.mark.slow
def test_memory_stays_flat_over_two_hours(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "long.mcap"
    used = long_flight(path, scenario(extra="control_period = 0.08"), 2.0 * HOUR_S, monkeypatch)
    warm = max(size for when, size in used.items() if when < WARM_S)
    assert max(used.values()) - warm < MOST_GROWN
    assert path.stat().st_size < MOST_A_MINUTE * 120.0
    recording = Recording(path)
    assert sum(1 for _ in recording.steps()) == round(2.0 * HOUR_S / 0.08)
    assert recording.ended == "stopped" and recording.time_s == pytest.approx(2.0 * HOUR_S)


@pytest.mark.slow
def test_a_minute_of_random_sticks_takes_a_megabyte_and_a_half_at_most(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "busy.mcap"
    long_flight(path, scenario(), 300.0, monkeypatch)
    assert path.stat().st_size / 5.0 <= MOST_A_MINUTE
