"""List of a station's recordings, and their playback in a page of the station."""

from __future__ import annotations

import os
from pathlib import Path
from urllib.parse import quote

import msgspec
import pytest

from aftdeck.station import built as station_built
from aftdeck.station.messages.playback import Block, PlaybackIndex, Recorded
from aftdeck.station.server import app as station_app
from aftdeck.station.server import player as station_player
from aftdeck.station.session.session import Session
from tests.loaded import scenario
from tests.station.pages import Station, served, until
from tests.station.recordings import record_run

PAGE = "<html><head><title>Aftdeck</title></head><body></body></html>"


@pytest.fixture(autouse=True)
def built(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    """Write a page, so that the tests do not need the built page."""
    folder = tmp_path_factory.mktemp("static")
    (folder / "index.html").write_text(PAGE, encoding="utf-8")
    for module in (station_app, station_built, station_player):
        monkeypatch.setattr(module, "STATIC", folder)


def listed(station: Station) -> tuple[Recorded, ...]:
    status, body = station.get("/recordings.json")
    assert status == 200
    return msgspec.json.decode(body, type=tuple[Recorded, ...])


def index(station: Station, file: str) -> PlaybackIndex:
    status, body = station.get(f"/replay/{file}/recording/index.json")
    assert status == 200, body
    return msgspec.json.decode(body, type=PlaybackIndex)


def test_recordings_are_listed_newest_first_with_the_present_run(tmp_path: Path) -> None:
    record_run(tmp_path / "before.mcap", 60)
    os.utime(tmp_path / "before.mcap", (1e9, 1e9))
    (tmp_path / "notes.txt").write_text("no recording", encoding="utf-8")
    with served(Session(scenario(), record=tmp_path)) as station:
        until(lambda: len(listed(station)) == 2 and listed(station)[0].title != "", "the file of the present run")
        now, before = listed(station)
    assert (before.file, before.now, before.changed) == ("before.mcap", False, "2001-09-09T01:46:40+00:00")
    assert now.now and now.file.startswith(scenario().name)
    assert (now.title, now.time_s, now.ended) == (scenario().title, None, "")


def test_finished_recording_is_listed_with_its_title_length_and_end(tmp_path: Path) -> None:
    with served(Session(scenario(), record=tmp_path)) as station:
        until(lambda: bool(listed(station)) and station.get("/health")[0] == 200, "the file of the first run")
        (first,) = listed(station)
    with served(Session(scenario(), record=tmp_path)) as station:
        until(lambda: len(listed(station)) == 2 and listed(station)[0].now, "the file of the second run")
        (ended,) = (each for each in listed(station) if each.file == first.file)
    assert (ended.title, ended.ended) == (scenario().title, "stopped")
    assert ended.time_s is not None
    assert ended.time_s >= 0.0


@pytest.mark.slow
def test_recording_is_played_in_a_page_that_links_to_the_station(tmp_path: Path) -> None:
    record_run(tmp_path / "before.mcap", 300)
    with served(Session(scenario(), record=tmp_path)) as station:
        status, page = station.get("/replay/before.mcap/")
        assert status == 200
        assert '<meta name="recording" content="recording/" />' in page
        assert '<meta name="flying" content="../../" />' in page
        assert index(station, "before.mcap").ticks == 300
        block = msgspec.json.decode(station.get("/replay/before.mcap/recording/blocks/1")[1], type=Block)
        assert block[-1].frame.tick == 300
        assert station.get("/replay/before.mcap/recording/verdict.json")[0] == 200
        assert station.get("/") == (200, PAGE)


@pytest.mark.slow
def test_recording_whose_name_is_not_utf_8_is_listed_and_played(tmp_path: Path) -> None:
    folder = tmp_path / os.fsdecode(b"runs-\xff")
    record_run(folder / os.fsdecode(b"before-\xff.mcap"), 60)
    with served(Session(scenario(), record=folder)) as station:
        until(lambda: len(listed(station)) == 2 and listed(station)[0].title != "", "the file of the present run")
        before = listed(station)[1]
        assert before.file == r"before-\udcff.mcap"
        played = index(station, quote(before.file))
        assert (played.file, played.ticks) == (before.file, 60)
    assert len(list(folder.glob("*.mcap"))) == 2


@pytest.mark.slow
def test_present_run_is_read_again_when_its_file_has_grown(tmp_path: Path) -> None:
    with served(Session(scenario(), record=tmp_path)) as station:
        until(lambda: bool(listed(station)), "the file of the present run")
        (now,) = listed(station)
        until(lambda: station.get(f"/replay/{now.file}/recording/index.json")[0] == 200, "the first steps on disk")
        first = index(station, now.file)
        until(lambda: index(station, now.file).ticks > first.ticks, "more steps on disk")
        assert not first.ended


@pytest.mark.slow
@pytest.mark.parametrize("file", ["none.mcap", "notes.txt", "broken.mcap", "..%2fsecret.mcap", "%2e%2e"])
def test_file_that_cannot_be_played_is_not_found(tmp_path: Path, file: str) -> None:
    folder = tmp_path / "flights"
    folder.mkdir()
    record_run(tmp_path / "secret.mcap", 10)
    for name in ("notes.txt", "broken.mcap"):
        (folder / name).write_text("no recording", encoding="utf-8")
    with served(Session(scenario(), record=folder)) as station:
        assert station.get(f"/replay/{file}/")[0] == 404
        assert station.get(f"/replay/{file}/recording/index.json")[0] == 404


def test_station_without_recording_serves_no_list() -> None:
    with served(Session(scenario())) as station:
        assert station.get("/recordings.json")[0] == 404
        assert station.get("/replay/before.mcap/")[0] == 404
