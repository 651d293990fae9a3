"""A killed program loses at most the last second of its recording: each file can be read and verified up to its end."""

from __future__ import annotations

import itertools
import subprocess
import sys
from pathlib import Path

import msgspec
import pytest

from aftdeck.errors import RecordingError
from aftdeck.recording.index import Index
from aftdeck.recording.reader import Recording
from aftdeck.recording.replay import verify
from aftdeck.recording.writer import POLL_S
from tests.each import number
from tests.recording import killed_flights
from tests.recording.killed_flights import PERIOD_S, Check, Killed

MAX_LOST_S = 1.0
WAIT_S = 500.0
"""Longest time for a hundred runs on a slow machine that compiles the laws first [s]."""


def record_and_kill(folder: Path, count: int) -> list[Killed]:
    """Record and kill runs in a subprocess, and return the data about them."""
    command = [sys.executable, "-m", killed_flights.__name__, str(folder), str(count), "5"]
    done = subprocess.run(command, capture_output=True, timeout=WAIT_S, check=False)
    assert (done.returncode, done.stderr) == (0, b"")
    runs = [msgspec.json.decode(line, type=Killed) for line in done.stdout.splitlines()]
    assert len(runs) == count
    return runs


def delay(run_: Killed, since_s: float) -> float:
    """Return how long a busy machine or disk has delayed a recorder's thread since the time `since_s` [s].

    This is the sum of the pauses between the thread's checks of the queue, without the thread's work and sleep. The
    last pause ends when the process is killed; all work of the process since the last check counts as the thread's.
    """
    checked = run_.checks[-1]
    last = Check(run_.killed_s, checked.worked_s + run_.process_s - checked.process_s, run_.process_s)
    pauses = [
        after.time_s - max(before.time_s, since_s) - (after.worked_s - before.worked_s) - POLL_S
        for before, after in itertools.pairwise([*run_.checks, last])
        if after.time_s > since_s
    ]
    return sum(max(pause, 0.0) for pause in pauses)


def lost_s(run_: Killed) -> float:
    """Return the duration of the steps that a run's file lacks, minus the recorder's `delay` [s]."""
    recording = Recording(Path(run_.file))
    kept, handed_over = sum(1 for _ in recording.steps()), len(run_.handed_over_s)
    assert recording.cut and recording.ended == ""
    assert kept <= handed_over + 1  # the last step may be recorded but not reported
    if kept >= handed_over:
        return 0.0
    return (handed_over - kept) * PERIOD_S - delay(run_, run_.handed_over_s[kept])


def check(folder: Path, count: int, monkeypatch: pytest.MonkeyPatch) -> None:
    runs = record_and_kill(folder, count)
    for run_ in runs:
        assert lost_s(run_) <= MAX_LOST_S, run_.file
    for file in [Path(run_.file) for run_ in runs[:: max(count // 5, 1)]]:
        if any(True for _ in Recording(file).steps()):
            verdict = verify(file)
            assert verdict.equal and verdict.cut
        else:  # killed before its first second was written
            with pytest.raises(RecordingError) as caught:
                verify(file)
            assert caught.value.fault == "empty"
    monkeypatch.setattr("aftdeck.recording.index.FRESH_S", -1.0)
    listed = {entry.path: entry for entry in Index().entries()}
    assert {listed[run_.file].ended for run_ in runs} == {"cut"}


@pytest.mark.slow
def test_killed_program_loses_at_most_a_second(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    check(tmp_path, 2, monkeypatch)


@pytest.mark.slow
def test_many_killed_programs_lose_at_most_a_second(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    check(tmp_path, number(25, 100), monkeypatch)
