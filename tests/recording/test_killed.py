"""A program that is killed loses at most its last second: every file opens, and verifies as far as it goes."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from aftdeck.recording.index import Index
from aftdeck.recording.reader import Recording
from aftdeck.recording.replay import verify
from tests.recording import killed_flights

MOST_LOST_S = 1.0
WAIT_S = 200.0


def killed(folder: Path, count: int) -> list[tuple[Path, list[float]]]:
    """Flights that were killed: their files, and when each of their steps was handed over [s]."""
    command = [sys.executable, killed_flights.__file__, str(folder), str(count), "5"]
    done = subprocess.run(command, capture_output=True, timeout=WAIT_S, check=False)
    assert (done.returncode, done.stderr) == (0, b"")
    flights = [json.loads(line) for line in done.stdout.splitlines()]
    assert len(flights) == count
    return [(Path(flight["file"]), flight["handed_over"]) for flight in flights]


def lost(path: Path, handed_over: list[float]) -> float:
    """The wall time of the steps that are not in a killed flight's file [s]."""
    recording = Recording(path)
    kept = sum(1 for _ in recording.steps())
    assert recording.cut and recording.ended == ""
    assert kept <= len(handed_over) + 1  # the last may be recorded, and no longer be told of
    return handed_over[-1] - handed_over[max(kept - 1, 0)] if kept < len(handed_over) else 0.0


def check(folder: Path, count: int, monkeypatch: pytest.MonkeyPatch) -> None:
    flights = killed(folder, count)
    for path, handed_over in flights:
        assert lost(path, handed_over) <= MOST_LOST_S, path
    for path, _ in flights[:: max(count // 5, 1)]:
        verdict = verify(path)
        assert verdict.equal and verdict.cut
    monkeypatch.setattr("aftdeck.recording.index.FRESH_S", -1.0)
    listed = {entry.path: entry for entry in Index().entries()}
    assert {listed[str(path)].ended for path, _ in flights} == {"cut"}


def test_a_killed_flights_file_is_whole_to_its_last_second(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    check(tmp_path, 2, monkeypatch)


@pytest.mark.slow
def test_a_hundred_killed_flights_lose_a_second_at_most(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    check(tmp_path, 100, monkeypatch)
