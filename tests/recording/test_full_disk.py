"""A disk that is full, a folder that cannot be written: a sentence, and the flight goes on."""

from __future__ import annotations

import itertools
import resource
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from aftdeck.errors import RecordingError
from aftdeck.recording import writer
from aftdeck.recording.index import Index
from aftdeck.recording.reader import Recording
from aftdeck.recording.replay import verify
from aftdeck.recording.run import record
from aftdeck.recording.session_recorder import SessionRecorder
from aftdeck.recording.sink import Sink
from aftdeck.recording.writer import Recorder
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.simulation.warm import warm_up
from tests.recording.flown import bay, recorded

ROOM = 100_000
"""Bytes that a file may have where the disk is full."""
SCRIPT = '[[phase]]\nmode = "ORB UNL"\ntranslation = [0.6, 0, 0.2]\nduration = "20 s"'
WAIT_S = 60.0
"""The longest that anything is waited for [s]."""


@pytest.fixture(scope="module", autouse=True)
def compiled() -> None:
    """The laws are compiled before a disk is full: Numba keeps them on one, and breaks down where it cannot."""
    warm_up(bay(extra=SCRIPT))


@contextmanager
def full_disk(room: int = ROOM) -> Iterator[None]:
    """No file may grow beyond `room` bytes: the operating system refuses what is beyond, as on a full disk."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (room, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


def check_kept(path: Path) -> None:
    """What was written before opens, and repeats itself."""
    verdict = verify(path)
    assert verdict.equal and verdict.cut and verdict.frames > 0
    assert 0 < path.stat().st_size <= ROOM


def test_a_run_onto_a_full_disk_says_so_and_keeps_what_was_flown_before(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(writer, "FLUSH_S", 0.001)
    path = tmp_path / "full.mcap"
    made = bay(extra=SCRIPT)
    index = Index(tmp_path / "list.sqlite")
    with full_disk(), pytest.raises(RecordingError) as caught:
        record(made, path, index=index)
    assert str(caught.value) == f"{path}: recording stopped, the flight goes on: File too large"
    check_kept(path)
    (entry,) = index.entries()
    assert (entry.ended, entry.state) == ("cut", "here")


def test_a_flight_goes_on_while_its_disk_is_full(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(writer, "FLUSH_S", 0.001)
    made = bay()
    sim = Simulation(made)
    path = tmp_path / "full.mcap"
    steps = 0
    with full_disk():
        recorder = Recorder(path, made, 0)
        end = time.monotonic() + WAIT_S
        while not recorder.failure:
            assert time.monotonic() < end
            recorder.step(None, sim.step(Inputs(translation=(0.5, 0.0, 0.0))))
            recorder.wait_for_room()
            steps += 1
        for _ in range(100):
            recorder.step(None, sim.step(Inputs()))
        assert sim.frame is not None and sim.frame.tick == steps + 100
        recorder.close("stopped")
    assert recorder.failure.endswith("File too large")
    assert Recording(path).opening.scenario == "test"


def test_a_disk_that_takes_nothing_at_all_leaves_no_trap(tmp_path: Path) -> None:
    made = bay()
    path = tmp_path / "none.mcap"
    with full_disk(0):
        recorder = Recorder(path, made, 0)
        recorder.step(None, Simulation(made).step())
        recorder.close("stopped")
    assert recorder.failure.endswith("File too large")
    with pytest.raises(RecordingError, match="nothing in it to read"):
        Recording(path)


def test_a_writer_that_falls_far_behind_stops_and_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(writer, "MAX_WAITING", 30)
    monkeypatch.setattr(writer, "BEGIN_S", 0.0)
    plain, freed = Sink.write, threading.Event()

    def stuck(self: Sink, data: bytes) -> int:
        assert freed.wait(WAIT_S)
        return plain(self, data)

    monkeypatch.setattr(Sink, "write", stuck)
    made = bay()
    sim = Simulation(made)
    recorder = Recorder(tmp_path / "slow.mcap", made, 0)
    for _ in range(30):
        recorder.step(None, sim.step())
    assert recorder.failure == ""
    recorder.step(None, sim.step())
    assert recorder.failure.endswith("30 steps wait to be written: the disk is too slow")
    freed.set()
    recorder.close("stopped")


@pytest.mark.parametrize("below", ["file/run.mcap", "file/deeper/run.mcap"])
def test_a_folder_that_cannot_be_made_is_told_before_the_flight(tmp_path: Path, below: str) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(RecordingError, match=r"run\.mcap: cannot be written: (Not a directory|File exists)"):
        record(bay(extra=SCRIPT), tmp_path / below)


def test_a_folder_that_is_missing_is_made(tmp_path: Path) -> None:
    path = tmp_path / "a" / "b" / "c.mcap"
    recorded(path, bay(), itertools.repeat(Inputs()), 5)
    assert verify(path).frames == 5


def test_a_folder_in_place_of_a_file_is_not_written_over(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match="exists already"):
        record(bay(extra=SCRIPT), tmp_path)


@pytest.mark.parametrize("name", ["test", "n" * 250])
def test_a_tape_without_a_place_complains_once_and_lets_fly(
    tmp_path: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path if len(name) > 200 else tmp_path / "file"
    (tmp_path / "file").touch()
    recorder = SessionRecorder(folder, None)
    made = bay(name=name)
    recorder.begin(made, 0)
    recorder.step(Inputs(), Simulation(made).step(Inputs()), None)
    (text,) = recorder.take_errors()
    assert text.startswith("nothing is recorded: ") and "cannot be written" in text
    assert recorder.take_errors() == [] and recorder.running_s is None and recorder.file is None
    recorder.end("restarted")
    recorder.close()
    assert capsys.readouterr().err == f"aftdeck: {text}\n"


def test_flights_that_begin_in_one_second_get_names_of_their_own(tmp_path: Path) -> None:
    made = bay()
    recorder = SessionRecorder(tmp_path, None)
    for _ in range(5):
        recorder.begin(made, 0)
        recorder.step(Inputs(), Simulation(made).step(Inputs()), None)
        recorder.end("restarted")
    recorder.close()
    assert recorder.take_errors() == []
    files = list(tmp_path.glob("test-*.mcap"))
    assert len(files) == 5 and all(verify(path).equal for path in files)


def test_a_tape_without_a_folder_records_nothing(tmp_path: Path) -> None:
    recorder = SessionRecorder(None, Index(tmp_path / "list.sqlite"))
    made = bay()
    recorder.begin(made, 0)
    recorder.step(Inputs(), Simulation(made).step(Inputs()), None)
    recorder.close()
    assert recorder.running_s is None and list(tmp_path.iterdir()) == []
