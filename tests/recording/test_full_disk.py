"""Full disks and folders that cannot be written: the recording ends with an error, the run continues."""

from __future__ import annotations

import itertools
import threading
import time
from pathlib import Path

import pytest

from aftdeck.errors import RecordingError
from aftdeck.recording import writer
from aftdeck.recording.index import Index
from aftdeck.recording.reader import Recording
from aftdeck.recording.replay import verify
from aftdeck.recording.run import record
from aftdeck.recording.sink import Sink
from aftdeck.recording.writer import Recorder
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.simulation.warm import warm_up
from aftdeck.station.session.session_recorder import SessionRecorder
from tests.full_disk import full_disk
from tests.recording.flown import bay, record_steps
from tests.station.stepped import one_step
from tests.waits import WAIT_S

ROOM = 100_000
"""Maximum size of a file on the full disk [bytes]."""
SCRIPT = '[[phase]]\nmode = "ORB UNL"\ntranslation = [0.6, 0, 0.2]\nduration = "20 s"'


@pytest.fixture(scope="module", autouse=True)
def compiled() -> None:
    """Compile the laws before the disk is full, because Numba writes the compiled laws to the disk."""
    warm_up(bay(extra=SCRIPT))


@pytest.fixture
def freed(monkeypatch: pytest.MonkeyPatch) -> threading.Event:
    """Return the event until which the disk does not write."""
    monkeypatch.setattr(writer, "BEGIN_S", 0.0)
    plain, freed = Sink.write, threading.Event()

    def stuck(self: Sink, data: bytes) -> int:
        assert freed.wait(WAIT_S)
        return plain(self, data)

    monkeypatch.setattr(Sink, "write", stuck)
    return freed


def check_kept(path: Path) -> None:
    """Check that the written part of a recording can be read and verified."""
    verdict = verify(path)
    assert verdict.equal and verdict.cut and verdict.frames > 0
    assert 0 < path.stat().st_size <= ROOM


def test_run_onto_a_full_disk_raises_and_keeps_the_written_part(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(writer, "FLUSH_S", 0.001)
    path = tmp_path / "full.mcap"
    made = bay(extra=SCRIPT)
    index = Index(tmp_path / "list.sqlite")
    with full_disk(ROOM), pytest.raises(RecordingError) as caught:
        record(made, path, index=index)
    text = str(caught.value)
    assert text.startswith(f"{path}: ") and text.endswith(": File too large")
    check_kept(path)
    (entry,) = index.entries()
    assert (entry.ended, entry.state) == ("cut", "here")


def test_run_continues_on_a_full_disk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(writer, "FLUSH_S", 0.001)
    made = bay()
    sim = Simulation(made)
    path = tmp_path / "full.mcap"
    steps = 0
    with full_disk(ROOM):
        recorder = Recorder(path, made, 0)
        end = time.monotonic() + WAIT_S
        while not recorder.failure:
            assert time.monotonic() < end
            recorder.step(None, sim.step(Inputs(translation=(0.5, 0.0, 0.0))))
            recorder.take_turns()
            steps += 1
        for _ in range(100):
            recorder.step(None, sim.step(Inputs()))
        assert sim.frame is not None and sim.frame.tick == steps + 100
        recorder.close("stopped")
    assert recorder.failure.endswith("File too large")
    assert Recording(path).opening.scenario == "test"


def test_disk_without_any_space_leaves_an_empty_recording(tmp_path: Path) -> None:
    made = bay()
    path = tmp_path / "none.mcap"
    with full_disk(0):
        recorder = Recorder(path, made, 0)
        recorder.step(None, Simulation(made).step())
        recorder.close("stopped")
    assert recorder.failure.endswith("File too large")
    with pytest.raises(RecordingError) as caught:
        Recording(path)
    assert caught.value.fault == "empty"


def test_recording_ends_when_the_queue_is_full(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, freed: threading.Event
) -> None:
    monkeypatch.setattr(writer, "MAX_WAITING", 30)
    made = bay()
    sim = Simulation(made)
    recorder = Recorder(tmp_path / "slow.mcap", made, 0)
    for _ in range(30):
        recorder.step(None, sim.step())
    assert recorder.failure == ""
    recorder.step(None, sim.step())
    assert "30 steps" in recorder.failure
    freed.set()
    recorder.close("stopped")


def test_run_that_takes_turns_does_not_wait_for_a_stuck_disk(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, freed: threading.Event
) -> None:
    monkeypatch.setattr(writer, "MAX_DISK_WAIT_S", 0.2)
    made = bay()
    sim = Simulation(made)
    recorder = Recorder(tmp_path / "stuck.mcap", made, 0)
    for _ in range(writer.BATCH):
        recorder.step(None, sim.step())
    recorder.take_turns()
    assert "disk" in recorder.failure
    freed.set()
    recorder.close("stopped")


def test_queue_is_written_in_each_turn(tmp_path: Path) -> None:
    made = bay()
    sim = Simulation(made)
    path = tmp_path / "turns.mcap"
    recorder = Recorder(path, made, 0)
    for _ in range(3 * writer.BATCH + 1):
        recorder.step(None, sim.step())
        recorder.take_turns()
        assert len(recorder._waiting) < writer.BATCH
    recorder.close("stopped")
    assert verify(path).frames == 3 * writer.BATCH + 1


@pytest.mark.parametrize("below", ["file/run.mcap", "file/deeper/run.mcap"])
def test_folder_that_cannot_be_created_is_rejected_before_the_run(tmp_path: Path, below: str) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(RecordingError, match=r"run\.mcap: .*(Not a directory|File exists)") as caught:
        record(bay(extra=SCRIPT), tmp_path / below)
    assert caught.value.fault == "unwritable"


def test_missing_folder_is_created(tmp_path: Path) -> None:
    path = tmp_path / "a" / "b" / "c.mcap"
    record_steps(path, bay(), itertools.repeat(Inputs()), 5)
    assert verify(path).frames == 5


def test_folder_in_place_of_a_file_is_not_overwritten(tmp_path: Path) -> None:
    with pytest.raises(RecordingError) as caught:
        record(bay(extra=SCRIPT), tmp_path)
    assert caught.value.fault == "exists"


@pytest.mark.parametrize("name", ["test", "n" * 250])
def test_session_recorder_reports_an_unusable_folder_once(
    tmp_path: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path if len(name) > 200 else tmp_path / "file"
    (tmp_path / "file").touch()
    recorder = SessionRecorder(folder, None)
    made = bay(name=name)
    one_step(recorder, made)
    (text,) = recorder.take_errors()
    assert str(folder) in text
    assert recorder.take_errors() == [] and not recorder.recorded and recorder.file is None
    recorder.end("restarted")
    recorder.close()
    assert capsys.readouterr().err == f"aftdeck: {text}\n"


def test_runs_that_begin_in_one_second_have_different_names(tmp_path: Path) -> None:
    made = bay()
    recorder = SessionRecorder(tmp_path, None)
    for _ in range(5):
        one_step(recorder, made)
        recorder.end("restarted")
    recorder.close()
    assert recorder.take_errors() == []
    files = list(tmp_path.glob("test-*.mcap"))
    assert len(files) == 5 and all(verify(path).equal for path in files)


def test_session_recorder_without_a_folder_records_nothing(tmp_path: Path) -> None:
    recorder = SessionRecorder(None, Index(tmp_path / "list.sqlite"))
    made = bay()
    one_step(recorder, made)
    recorder.close()
    assert not recorder.recorded and list(tmp_path.iterdir()) == []
