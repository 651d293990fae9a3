"""Recording of a session: one file for each run, and a warning if a run cannot be recorded."""

from __future__ import annotations

import resource
import threading
from pathlib import Path

import msgspec
import pytest

from aftdeck.recording import writer
from aftdeck.recording.index import Index
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import FrameRecord, Input
from aftdeck.recording.replay import verify
from aftdeck.recording.sink import Sink
from aftdeck.recording.trial import Trial
from aftdeck.station.messages import from_page
from aftdeck.station.messages.frame import Frame
from aftdeck.station.playback.store import PlaybackStore
from aftdeck.station.playback.verdict import CHECKING
from tests.loaded import scenario
from tests.station.flying import Flown, flying, shown, step_until, steps
from tests.station.pages import STILL, until
from tests.station.recordings import ended, files
from tests.waits import WAIT_S

ROOM = 90_000


def restarted(session: Flown) -> Frame:
    """Step until the first frame after a restart, and return it."""
    return step_until(session, lambda frame: frame.tick == 1, "the restart")


def has_warned(session: Flown) -> bool:
    """Do a step, and return whether the log has a line about the recording. Another thread writes the recording."""
    session.step()
    return any(event.kind == "recording" for event in session.log.since(0))


@pytest.mark.slow
def test_every_run_has_a_file_that_verifies(tmp_path: Path) -> None:
    with flying(record=tmp_path) as session:
        session.accept(from_page.Sticks(0, (1.0, 0.0, 0.0), STILL, 0.0))
        session.accept(from_page.SelectRate(1, "vernier"))
        steps(session, 30)
        session.accept(from_page.Restart(2))
        restarted(session)
        session.accept(from_page.EnterMode(3, "SINGLE"))
        session.accept(from_page.SelectJoint(4, 2))
        session.accept(from_page.Stop(5))
        steps(session, 10)
        session.accept(from_page.Restart(6))
        restarted(session)
        steps(session, 5)
    first, second, third = files(tmp_path)
    assert [ended(path) for path in (first, second, third)] == ["restarted", "restarted", "stopped"]
    assert all(verify(path).equal for path in (first, second, third))
    assert all(path.name.startswith("first-flight-2") for path in (first, second, third))
    flown = [m for m in Recording(first).messages() if isinstance(m, Input)]
    assert {m.rate for m in flown} >= {"vernier"} and any(m.translation == (1.0, 0.0, 0.0) for m in flown)
    (note,) = Recording(second).notes()
    assert note.kind == "restart"


def test_participant_is_in_every_recording_and_in_no_message(tmp_path: Path) -> None:
    trial = Trial("P07", "wrist camera off")
    with flying(record=tmp_path, trial=trial) as session:
        session.accept(from_page.Restart(0))
        restarted(session)
        steps(session)
        sent = (session.welcome, shown(session), session.log.since(0))
        other = session.another(scenario("tutorial"))
    other.begin()
    other.step()
    other.close()
    assert [Trial(o.participant, o.condition) for o in (Recording(path).opening for path in files(tmp_path))] == (
        [trial] * 3
    )
    assert all(verify(path).equal for path in files(tmp_path))
    assert not any(word in msgspec.json.encode(data) for data in sent for word in (b"P07", b"wrist camera off"))


def test_recordings_are_added_to_the_list(tmp_path: Path) -> None:
    with flying(record=tmp_path) as session:
        steps(session)
    (path,) = files(tmp_path)
    (entry,) = [entry for entry in Index().entries() if entry.path == str(path)]
    assert (entry.ended, entry.scenario, entry.state) == ("stopped", "first-flight", "here")


def test_demonstration_and_change_to_manual_control_are_recorded(tmp_path: Path) -> None:
    with flying(record=tmp_path, demo=True) as session:
        steps(session)
        session.accept(from_page.Sticks(0, (0.0, 0.5, 0.0), STILL, 0.0))
        step_until(session, lambda frame: frame.by == "hand", "manual control")
    (path,) = files(tmp_path)
    assert verify(path).equal
    assert {m.script for m in Recording(path).messages() if isinstance(m, Input)} == {True, False}
    assert [note.kind for note in Recording(path).notes()] == ["hand"]


def test_frames_have_the_length_of_the_recording(tmp_path: Path) -> None:
    with flying(record=tmp_path) as session:
        frame = steps(session)
        assert frame.display.recording_s == pytest.approx(frame.tick * 0.02)
        session.accept(from_page.Restart(0))
        restarted(session)
        frame = steps(session, 1)
        assert frame.display.recording_s == pytest.approx(frame.tick * 0.02)


def test_frames_without_recording_have_no_recording_length() -> None:
    with flying() as session:
        assert shown(session).display.recording_s is None


def test_latency_is_recorded_until_the_page_leaves(tmp_path: Path) -> None:
    with flying(record=tmp_path) as session:
        steps(session, 3)
        session.accept(from_page.Shown(0, 41.5))
        steps(session, 5)
        session.set_unattended()
        steps(session, 5)
    (path,) = files(tmp_path)
    latencies = [m.latency_ms for m in Recording(path).messages() if isinstance(m, FrameRecord)]
    assert latencies[0] is None and latencies[-1] is None and set(latencies) == {None, 41.5}
    first = latencies.index(41.5)
    assert set(latencies[first : first + latencies.count(41.5)]) == {41.5}


KEYS = from_page.ControllerInUse("keyboard", "Keyboard", 0.0, 0.0, ("KeyW +X", "KeyS -X"), ())
PAD = from_page.ControllerInUse("pad", "Test pad", 0.08, 0.3, ("a1 -X", "b9+b12 +telescope"), (0.0, 0.11))


def test_controllers_are_recorded_first_and_when_they_change(tmp_path: Path) -> None:
    with flying(record=tmp_path) as session:
        session.accept(from_page.Controllers(0, (KEYS,)))
        steps(session, 5)
        session.accept(from_page.Controllers(1, (KEYS, PAD)))
        steps(session, 5)
        session.accept(from_page.Restart(2))
        restarted(session)
        steps(session, 5)
        session.set_unattended()
        steps(session, 5)
    first, second = (list(Recording(path).controllers()) for path in files(tmp_path))
    assert [[used.name for used in record.controllers] for record in first] == [["Keyboard"], ["Keyboard", "Test pad"]]
    assert first[0].time_s < first[1].time_s
    assert [[used.name for used in record.controllers] for record in second] == [["Keyboard", "Test pad"], []]
    assert msgspec.structs.asdict(first[1].controllers[1]) == msgspec.structs.asdict(PAD)
    assert all(verify(path).equal for path in files(tmp_path))


def test_scripted_run_records_no_controllers(tmp_path: Path) -> None:
    with flying(record=tmp_path, demo=True) as session:
        steps(session, 5)
    (path,) = files(tmp_path)
    assert list(Recording(path).controllers()) == []


def test_measures_name_the_controllers_and_their_settings(tmp_path: Path) -> None:
    with flying(record=tmp_path) as session:
        session.accept(from_page.Controllers(0, (KEYS, PAD)))
        steps(session, 5)
    (path,) = files(tmp_path)
    with PlaybackStore(path) as store:
        (measure,) = [m for m in store.index(CHECKING).measures if m.name == "Controllers"]
    assert measure.text == "keyboard, pad"
    assert "Test pad, deadband 8 %, expo 0.3" in measure.about


def test_folder_that_cannot_be_written_is_a_warning(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "file").touch()
    with flying(record=tmp_path / "file") as session:
        assert steps(session).display.recording_s is None
        (line,) = [event for event in session.log.since(0) if event.kind == "recording"]
    assert line.level == "warning" and str(tmp_path / "file") in line.text
    assert capsys.readouterr().err == f"aftdeck: {line.text}\n"


def test_full_disk_is_a_warning_and_the_run_continues(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(writer, "FLUSH_S", 0.02)
    session = Flown(scenario(), record=tmp_path)
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (ROOM, hard))
    try:
        session.begin()
        until(lambda: has_warned(session), "the warning")
        assert steps(session).display.recording_s is None
    finally:
        session.close()
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    (line,) = [event for event in session.log.since(0) if event.kind == "recording"]
    assert line.level == "warning" and line.text.endswith(": File too large")
    (path,) = files(tmp_path)
    verdict = verify(path)
    assert verdict.equal and verdict.cut and verdict.frames > 0


def test_unusable_list_is_a_warning_and_the_run_is_recorded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "list").mkdir()
    monkeypatch.setattr("aftdeck.station.session.session.Index", lambda: Index(tmp_path / "list"))
    with flying(record=tmp_path / "flights") as session:
        until(lambda: has_warned(session), "the warning")
        assert steps(session).display.recording_s is not None
    (line,) = [event for event in session.log.since(0) if event.kind == "recording"]
    assert line.level == "warning" and str(tmp_path / "list") in line.text
    assert ended(files(tmp_path / "flights")[0]) == "stopped"


def test_restart_does_not_wait_for_the_disk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    plain, freed = Sink.close, threading.Event()

    def stuck(self: Sink) -> None:
        assert freed.wait(WAIT_S)
        plain(self)

    monkeypatch.setattr(Sink, "close", stuck)
    with flying(record=tmp_path) as session:
        steps(session)
        session.accept(from_page.Restart(0))
        restarted(session)
        steps(session)
        freed.set()
    assert [ended(path) for path in files(tmp_path)] == ["restarted", "stopped"]
