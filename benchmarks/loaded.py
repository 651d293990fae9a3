"""Benchmark of the station under load, and the soak: ``python -m benchmarks.loaded --help``.

The operator's page runs in this process. The pages that load the station run in processes of their own (`load.py`).
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from math import cos, sin
from pathlib import Path
from typing import NamedTuple

import aftdeck
from aftdeck.recording.reader import Recording
from aftdeck.recording.writer import Recorder
from aftdeck.simulation.inputs import Inputs
from benchmarks.load import Wire, text
from benchmarks.measure import Figure, percentile
from benchmarks.station import AFTDECK
from benchmarks.table import line

SCENARIO = "first-flight"
PERIOD = 0.02
"""Control period [s]."""
P99_MS, WORST_MS = 30.0, 60.0
"""Promised intervals between the operator's frames under load [ms]."""


class Size(NamedTuple):
    """Extent of the measurement.

    Attributes:
        quiet: time for which the station without load is measured [s].
        seconds: time for which the loaded station is measured [s].
        settle: time after the start of the load that is not measured [s].
        hour: simulated time of the recording that is opened [s].
        first: first part of the soak [s], after which the memory is read.
        minutes: duration of the soak [min].
        recording: existing recording to open; None makes one, in about two minutes.
    """

    quiet: float = 10.0
    seconds: float = 60.0
    settle: float = 5.0
    hour: float = 3600.0
    first: float = 60.0
    minutes: float = 60.0
    recording: Path | None = None


FULL = Size()
TINY = Size(quiet=0.5, seconds=1.0, settle=0.2, hour=5.0, first=0.5, minutes=0.02)
_FRAME, _TICK = b'{"type":"frame"', re.compile(rb'"tick":(\d+)')
_STICKS = {"type": "sticks", "translation": [0.1, 0, 0], "rotation": [0, 0, 0], "drive": 0}


class Seen(NamedTuple):
    """What the operator's page has received.

    Attributes:
        intervals: times between the frames [ms].
        seconds: time of the measurement [s].
    """

    intervals: list[float]
    seconds: float


def loaded(size: Size) -> list[Figure]:
    """Measure the operator's frames while pages watch, one page floods, and an hour's replay is opened."""
    with tempfile.TemporaryDirectory() as folder:
        hour = Path(folder) / "hour.mcap"
        if size.recording is None:
            record_hour(hour, size.hour)
        else:
            hour.symlink_to(size.recording.resolve())
        with flying(folder) as (address, _), operator(address) as page, ExitStack() as load:
            quiet = _figures(operate(page, size.quiet, size.settle), "no load", "", promised=False)
            load.enter_context(loading("watch", address))
            load.enter_context(loading("flood", address))
            load.enter_context(loading("replay", address, f"/replay/{hour.name}/"))
            seen = operate(page, size.seconds, size.settle)
        late = delays(folder)
    return [*quiet, *_figures(seen, "loaded", "8 watchers, a flood, a replay", promised=True), *late]


def soak(size: Size) -> list[Figure]:
    """Measure a flight of some minutes with eight watchers: frames, lost time and memory."""
    with tempfile.TemporaryDirectory() as folder:
        with flying(folder) as (address, process), operator(address) as page, loading("watch", address):
            first = operate(page, size.first, size.settle)
            early = _memory(process)
            rest = operate(page, max(60.0 * size.minutes - size.first, 1.0), size.settle)
            grown = _memory(process)
        late = delays(folder)
    seen = Seen(first.intervals + rest.intervals, first.seconds + rest.seconds)
    return [
        *_figures(seen, "soak", f"8 watchers, {size.minutes:g} minutes", promised=True),
        *late,
        Figure("memory early", early, "MB", None, f"after {size.first:g} s"),
        Figure("memory at the end", grown, "MB"),
    ]


def record_hour(path: Path, seconds: float) -> None:
    """Record an hour, or another time [s], of manual inputs."""
    simulation = aftdeck.Simulation(SCENARIO)
    recorder = Recorder(path, simulation.scenario, simulation.seed)
    for k in range(round(seconds / PERIOD)):
        given = Inputs(translation=(0.3 * sin(0.01 * k), 0.2 * cos(0.013 * k), 0.0), rotation=(0.0, 0.0, 0.1))
        recorder.step(given, simulation.step(given))
        recorder.take_turns()
    recorder.close("stopped")
    assert not recorder.failure, recorder.failure


@contextmanager
def operator(address: str) -> Iterator[Wire]:
    """Connect as the first page, which is the operator; yield it when its first frame has arrived."""
    wire = Wire(address)
    with wire.socket:
        while not any(message.startswith(_FRAME) for message in wire.messages()):
            pass
        yield wire


def operate(wire: Wire, seconds: float, settle: float) -> Seen:
    """Send sticks with every frame; return what the page has received in `seconds` after `settle` [s]."""
    intervals: list[float] = []
    before = begun = 0.0
    start = time.perf_counter()
    while time.perf_counter() - start < seconds + settle:
        for message in wire.messages():
            if not message.startswith(_FRAME):
                continue
            now = time.perf_counter()
            found = _TICK.search(message)
            assert found is not None
            if now - start < settle:
                begun = now
            else:
                intervals.append(1e3 * (now - before))
            before = now
            wire.socket.sendall(text({**_STICKS, "seq": int(found[1])}))
    return Seen(intervals, before - begun)


def _figures(seen: Seen, load: str, note: str, *, promised: bool) -> list[Figure]:
    p99, worst = (P99_MS, WORST_MS) if promised else (None, None)
    rate = f"{len(seen.intervals) / seen.seconds:.1f} frames/s"
    return [
        Figure(
            f"frame interval, {load}, p50",
            percentile(seen.intervals, 50),
            "ms",
            None,
            "; ".join(filter(None, (note, rate))),
        ),
        Figure(f"frame interval, {load}, p99", percentile(seen.intervals, 99), "ms", p99, note),
        Figure(f"frame interval, {load}, worst", max(seen.intervals), "ms", worst, note),
    ]


def delays(folder: str) -> list[Figure]:
    """Return the delays of the control steps, as the newest recording in a folder tells them."""
    recording = Recording(max(Path(folder).glob(f"{SCENARIO}-*.mcap")))
    for _ in recording.messages():
        pass
    delays = recording.delays
    assert delays is not None and recording.ended == "stopped"
    note = f"of the whole flight of {recording.time_s:.0f} s"
    return [
        Figure("late steps", delays.late_steps, "", None, note),
        Figure("greatest delay of a step", 1e3 * delays.worst_s, "ms", None, note),
        Figure("time lost", delays.lost_s, "s", None, note),
    ]


@contextmanager
def flying(folder: str) -> Iterator[tuple[str, subprocess.Popen[str]]]:
    """Run a station that records into a folder; yield its address and its process once it flies."""
    command = [*AFTDECK, "fly", SCENARIO, "--no-browser", "--port", "0", "--record", folder]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        try:
            address = process.stdout.readline().partition("http://")[2].strip().rstrip("/")
            while not (line := process.stdout.readline()).startswith("Flying"):
                assert line, "the station has ended"
            yield address, process
        finally:
            process.terminate()
            process.wait(30)


@contextmanager
def loading(kind: str, *arguments: str) -> Iterator[None]:
    """Load a station in a process of its own; `kind` is one of `load.KINDS`.

    Raises:
        AssertionError: the process has ended by itself, so that it was no load.
    """
    with subprocess.Popen([sys.executable, "-m", "benchmarks.load", kind, *arguments]) as process:
        try:
            yield
            assert process.poll() is None, f"the load {kind} has ended"
        finally:
            process.terminate()
            process.wait(10)


def _memory(process: subprocess.Popen[str]) -> float:
    """Return a process's resident memory [MB]."""
    return int(subprocess.check_output(["ps", "-o", "rss=", "-p", str(process.pid)])) / 1e3


def main() -> None:
    """Run the benchmark or the soak, and print the figures."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.loaded", description=__doc__)
    parser.add_argument("--hour", type=Path, metavar="FILE", help="recording of an hour; default: make one")
    parser.add_argument("--seconds", type=float, default=FULL.seconds, help="time to measure")
    parser.add_argument("--soak", type=float, metavar="MINUTES", help="fly this long with eight watchers alone")
    given = parser.parse_args()
    print(f"load average {os.getloadavg()[0]:.2f}", flush=True)
    size = FULL._replace(seconds=given.seconds, recording=given.hour)
    for figure in soak(size._replace(minutes=given.soak)) if given.soak else loaded(size):
        print(line(figure))


if __name__ == "__main__":
    main()
