"""List of recordings."""

from __future__ import annotations

import contextlib
import itertools
import os
import re
import sqlite3
import subprocess
import sys
import time
from pathlib import Path

import msgspec
import pytest

from aftdeck.errors import RecordingError
from aftdeck.recording.bundle import opening
from aftdeck.recording.index import Entry, Index
from aftdeck.recording.run import record
from aftdeck.recording.trial import Trial
from aftdeck.recording.writer import Recorder
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.station.session.session_recorder import SessionRecorder
from tests.recording.flown import bay, record_steps
from tests.station.stepped import one_step
from tests.waits import WAIT_S

SCRIPT = '[[phase]]\nmode = "ORB UNL"\ntranslation = [0.6, 0, 0.2]\nduration = "0.2 s"'


def made() -> Scenario:
    return bay(extra=SCRIPT)


@pytest.fixture
def index(tmp_path: Path) -> Index:
    return Index(tmp_path / "data" / "list.sqlite")


def add_entry(index: Index, path: Path, name: str = "test", ended: str = "completed", day: int = 1) -> None:
    """Add an entry; its file may be missing."""
    start = opening(bay(name=name), 0, day * 86_400 * 10**9)
    index.begin(path, start)
    if ended:
        index.end(path, ended, 1.5)


def test_run_is_listed_with_its_end(index: Index, tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"
    summary = record(made(), path, seed=4, index=index).summary
    (entry,) = index.entries()
    assert (entry.path, entry.scenario, entry.title, entry.seed) == (str(path), "test", "test", 4)
    assert (entry.ended, entry.time_s, entry.state) == ("completed", summary.time_s, "here")
    assert entry.bytes == path.stat().st_size


def test_recording_in_progress_is_listed_and_not_deleted(
    index: Index, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        "aftdeck.recording.index.FRESH_S", 1000.0
    )  # so that the file counts as new, even on a slow machine
    path = tmp_path / "run.mcap"
    recorder = Recorder(path, made(), 0, index=index)
    recorder.step(None, Simulation(made()).step())
    end = time.monotonic() + WAIT_S
    while not index.entries():
        assert time.monotonic() < end, recorder.unlisted
    (entry,) = index.entries()
    assert (entry.ended, entry.state) == ("recording", "here")
    with pytest.raises(RecordingError, match=re.escape(str(path))):
        index.delete([entry])
    assert path.exists()
    recorder.close("stopped")
    assert [e.ended for e in index.entries()] == ["stopped"]


def entry_after_kill(index: Index, path: Path, size: int) -> Entry:
    """Return the list entry of a recording whose program was killed; the file is cut to `size` bytes."""
    record_steps(path, made(), itertools.repeat(Inputs()), 30)
    path.write_bytes(path.read_bytes()[:size])
    add_entry(index, path, ended="")
    old = path.stat().st_mtime - 60.0
    os.utime(path, (old, old))
    (entry,) = index.entries()
    return entry


@pytest.mark.parametrize(
    ("size", "ended", "state"),
    [
        (10**9, "stopped", "here"),
        (13_000, "cut", "here"),
        (3000, "recording", "unreadable"),
        (0, "recording", "unreadable"),
    ],
)
def test_file_of_a_killed_program_is_read(index: Index, tmp_path: Path, size: int, ended: str, state: str) -> None:
    entry = entry_after_kill(index, tmp_path / "run.mcap", size)
    assert (entry.ended, entry.state) == (ended, state)
    assert entry.bytes == (tmp_path / "run.mcap").stat().st_size


def test_missing_file_is_listed_as_gone(index: Index, tmp_path: Path) -> None:
    add_entry(index, tmp_path / "gone.mcap")
    add_entry(index, tmp_path / ("n" * 300))
    assert {e.state for e in index.entries()} == {"gone"}


def test_filters_select_entries(index: Index, tmp_path: Path) -> None:
    for day, (name, ended) in enumerate([("a", "time"), ("b", "fault"), ("a", "stopped"), ("a", "fault")], 1):
        add_entry(index, tmp_path / f"{day}.mcap", name, ended, day)
    assert [Path(e.path).stem for e in index.entries()] == ["4", "3", "2", "1"]
    assert [Path(e.path).stem for e in index.entries(scenario="a")] == ["4", "3", "1"]
    assert [Path(e.path).stem for e in index.entries(ended="fault")] == ["4", "2"]
    assert [Path(e.path).stem for e in index.entries(since="1970-01-04")] == ["4", "3"]
    assert [Path(e.path).stem for e in index.entries("a", "fault", "1970")] == ["4"]
    assert index.entries("c") == []


def test_list_of_an_earlier_version_is_read_and_extended(index: Index, tmp_path: Path) -> None:
    index.path.parent.mkdir(parents=True)
    with contextlib.closing(sqlite3.connect(index.path)) as database, database:
        database.execute(
            "create table recordings (path text primary key, scenario text not null, title text not null, seed integer "
            "not null, version text not null, began text not null, ended text not null, time_s real not null, "
            "bytes integer not null)"
        )
        row = (str(tmp_path / "old.mcap"), "test", "test", 0, "0.0.1", "1969-12-31", "time", 1.0, 10)
        database.execute("insert into recordings values (?, ?, ?, ?, ?, ?, ?, ?, ?)", row)
    record(made(), tmp_path / "new.mcap", index=index, trial=Trial("P07", "A"))
    entries = [(Path(e.path).stem, e.participant, e.condition) for e in index.entries()]
    assert entries == [("new", "P07", "A"), ("old", "", "")]


def test_forget_keeps_the_files(index: Index, tmp_path: Path) -> None:
    record(made(), tmp_path / "run.mcap", index=index)
    index.forget(index.entries())
    assert index.entries() == [] and (tmp_path / "run.mcap").exists()


def test_delete_removes_files_and_entries(index: Index, tmp_path: Path) -> None:
    record(made(), tmp_path / "run.mcap", index=index)
    record(made(), tmp_path / "kept.mcap", index=index)
    add_entry(index, tmp_path / "gone.mcap")
    index.delete([e for e in index.entries() if "kept" not in e.path])
    assert [Path(e.path).name for e in index.entries()] == ["kept.mcap"]
    assert sorted(p.name for p in tmp_path.glob("*.mcap")) == ["kept.mcap"]


def test_file_that_cannot_be_deleted_is_reported_and_stays_listed(index: Index, tmp_path: Path) -> None:
    (tmp_path / "folder.mcap").mkdir()
    add_entry(index, tmp_path / "folder.mcap")
    with pytest.raises(RecordingError, match=r"folder\.mcap: "):
        index.delete(index.entries())
    assert len(index.entries()) == 1


def test_path_recorded_again_is_one_entry(index: Index, tmp_path: Path) -> None:
    add_entry(index, tmp_path / "run.mcap", "a")
    add_entry(index, tmp_path / "run.mcap", "b")
    assert [e.scenario for e in index.entries()] == ["b"]


def test_file_whose_name_is_not_utf_8_is_listed_and_deleted(index: Index, tmp_path: Path) -> None:
    path = tmp_path / os.fsdecode(b"\xff.mcap")
    record(made(), path, index=index)
    (entry,) = index.entries()
    assert (entry.state, entry.ended, Path(entry.path)) == ("here", "completed", path)
    assert index.chain_of(path) != ""
    index.delete([entry])
    assert not path.exists() and index.entries() == []


TEN = """
import sys
from pathlib import Path
import msgspec
from aftdeck.recording import index as listing
from aftdeck.recording.index import Index
from aftdeck.recording.records import Opening
listing.BUSY_S = 200.0
index, start = Index(Path(sys.argv[1])), msgspec.json.decode(sys.argv[3], type=Opening)
for k in range(10):
    path = Path(f"/{sys.argv[2]}/{k}.mcap")
    index.begin(path, start)
    index.end(path, "completed", float(k))
"""


def test_several_programs_write_simultaneously(index: Index) -> None:
    start = msgspec.json.encode(msgspec.structs.replace(opening(made(), 0, 0), shapes_text="", worksite_text=""))
    programs = [
        subprocess.Popen([sys.executable, "-c", TEN, str(index.path), str(n), start], stderr=subprocess.PIPE)
        for n in range(3)
    ]
    for program in programs:
        assert program.communicate(timeout=300.0)[1] == b""
    entries = index.entries()
    assert len(entries) == 30
    assert all(e.ended == "completed" and e.time_s == float(Path(e.path).stem) for e in entries)


def make_unusable(path: Path, how: str) -> None:
    match how:
        case "garbage":
            path.write_bytes(b"no database at all, " * 100)
        case "a folder":
            path.mkdir()
        case "another table":
            with sqlite3.connect(path) as database:
                database.execute("create table recordings (path text)")
            database.close()
        case _:
            path.parent.rmdir()
            path.parent.touch()


@pytest.mark.parametrize("how", ["garbage", "a folder", "another table", "below a file"])
def test_unusable_list_is_reported_and_the_run_is_recorded(tmp_path: Path, how: str) -> None:
    (tmp_path / "data").mkdir()
    index = Index(tmp_path / "data" / "list.sqlite")
    make_unusable(index.path, how)
    with pytest.raises(RecordingError, match=r"list\.sqlite: "):
        index.entries()
    path = tmp_path / "run.mcap"
    assert record(made(), path, index=index).summary.ended == "completed"
    recorder = SessionRecorder(tmp_path / "flights", index)
    one_step(recorder, made())
    recorder.close()
    assert [f.stat().st_size > 0 for f in (tmp_path / "flights").iterdir()] == [True]


def test_locked_list_does_not_stop_a_recording(index: Index, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert index.entries() == []
    monkeypatch.setattr("aftdeck.recording.index.BUSY_S", 0.5)
    other = sqlite3.connect(index.path, isolation_level=None)
    other.execute("begin exclusive")
    try:
        path = tmp_path / "run.mcap"
        recorder = Recorder(path, made(), 0, index=index)
        recorder.step(Inputs(), Simulation(made()).step(Inputs()))
        recorder.close("stopped")
    finally:
        other.close()
    assert recorder.failure == ""
    assert recorder.unlisted.startswith(f"{index.path}: ") and "locked" in recorder.unlisted


def test_list_with_more_columns_is_read(index: Index, tmp_path: Path) -> None:
    add_entry(index, tmp_path / "a.mcap")
    with sqlite3.connect(index.path) as database:
        database.execute("alter table recordings add column weather text")
    database.close()
    add_entry(index, tmp_path / "b.mcap")
    assert len(index.entries()) == 2
