"""A program that is killed loses at most its last second: every file opens, and verifies as far as it goes."""

from __future__ import annotations

import itertools
import subprocess
import sys
from pathlib import Path

import msgspec
import pytest

from aftdeck.recording.index import Index
from aftdeck.recording.reader import Recording
from aftdeck.recording.replay import verify
from aftdeck.recording.writer import POLL_S
from tests.recording import killed_flights
from tests.recording.killed_flights import PERIOD_S, Killed, Look

MOST_LOST_S = 1.0
WAIT_S = 500.0
"""The longest that a hundred flights may take on a slow machine that compiles the laws first [s]."""


def killed(folder: Path, count: int) -> list[Killed]:
    """Flights that were killed."""
    command = [sys.executable, killed_flights.__file__, str(folder), str(count), "5"]
    done = subprocess.run(command, capture_output=True, timeout=WAIT_S, check=False)
    assert (done.returncode, done.stderr) == (0, b"")
    flights = [msgspec.json.decode(line, type=Killed) for line in done.stdout.splitlines()]
    assert len(flights) == count
    return flights


def kept_away(looks: list[Look], since_s: float) -> float:
    """How long a writer was kept from its work since a time [s]: by a busy machine, or by its disk.

    It is what is left of the pauses between its looks, less its own work and its sleep.
    """
    pauses = [
        after.time_s - max(before.time_s, since_s) - (after.worked_s - before.worked_s) - POLL_S
        for before, after in itertools.pairwise(looks)
        if after.time_s > since_s
    ]
    return sum(max(pause, 0.0) for pause in pauses)


def lost(flight: Killed) -> float:
    """How much of a killed flight is not in its file, in its writer's own time [s]."""
    recording = Recording(Path(flight.file))
    kept, handed_over = sum(1 for _ in recording.steps()), len(flight.handed_over_s)
    assert recording.cut and recording.ended == ""
    assert kept <= handed_over + 1  # the last may be recorded, and no longer be told of
    if kept >= handed_over:
        return 0.0
    return (handed_over - kept) * PERIOD_S - kept_away(flight.looks, flight.handed_over_s[kept])


def check(folder: Path, count: int, monkeypatch: pytest.MonkeyPatch) -> None:
    flights = killed(folder, count)
    for flight in flights:
        assert lost(flight) <= MOST_LOST_S, flight.file
    for flight in flights[:: max(count // 5, 1)]:
        verdict = verify(Path(flight.file))
        assert verdict.equal and verdict.cut
    monkeypatch.setattr("aftdeck.recording.index.FRESH_S", -1.0)
    listed = {entry.path: entry for entry in Index().entries()}
    assert {listed[flight.file].ended for flight in flights} == {"cut"}


def test_a_killed_flights_file_is_whole_to_its_last_second(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    check(tmp_path, 2, monkeypatch)


@pytest.mark.slow
def test_a_hundred_killed_flights_lose_a_second_at_most(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    check(tmp_path, 100, monkeypatch)
