"""Playback server: it serves a recording to its own page only."""

from __future__ import annotations

import json
import webbrowser
from collections.abc import Iterator
from pathlib import Path
from urllib.error import HTTPError
from urllib.request import Request, urlopen

import msgspec
import pytest
import uvicorn

from aftdeck.errors import RecordingError
from aftdeck.station import built as station_built
from aftdeck.station.messages.playback import BLOCK, Block, PlaybackIndex, Verdict
from aftdeck.station.playback import answers
from aftdeck.station.server import player as station_player
from aftdeck.station.server.playback_server import serve_recording
from tests.station.pages import until
from tests.station.recordings import playing, record_run
from tests.waits import WAIT_S

PAGE = "<html><head><title>Aftdeck</title></head><body></body></html>"


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("replay") / "flight.mcap"
    record_run(path, 300)
    return path


@pytest.fixture
def built(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Write a page, so that the tests do not need the built page."""
    (tmp_path / "index.html").write_text(PAGE, encoding="utf-8")
    monkeypatch.setattr(station_built, "STATIC", tmp_path)
    monkeypatch.setattr(station_player, "STATIC", tmp_path)


@pytest.fixture
def address(recording: Path, built: None) -> Iterator[str]:
    with playing(recording) as address:
        yield address


def get(address: str, headers: dict[str, str] | None = None) -> bytes:
    with urlopen(Request(address, headers=headers or {}), timeout=WAIT_S) as answer:
        body: bytes = answer.read()
    return body


def test_page_has_the_element_that_starts_playback(address: str) -> None:
    for page in (address, f"{address}index.html"):
        assert '<meta name="recording" content="recording/" />\n</head>' in get(page).decode()


def test_index_and_blocks_are_those_of_the_recording(address: str) -> None:
    index = msgspec.json.decode(get(f"{address}recording/index.json"), type=PlaybackIndex)
    assert (index.file, index.ticks, index.stride, index.ended) == ("flight.mcap", 300, 1, "stopped")
    first, second = (msgspec.json.decode(get(f"{address}recording/blocks/{number}"), type=Block) for number in range(2))
    assert [moment.frame.tick for moment in first + second] == list(range(1, 301))
    assert len(first) == BLOCK


def test_block_number_out_of_range_is_not_found(address: str) -> None:
    with pytest.raises(HTTPError) as rejected:
        get(f"{address}recording/blocks/2")
    assert rejected.value.code == 404 and b"0 to 1, got 2" in rejected.value.read()
    rejected.value.close()


def test_page_of_another_site_is_rejected(address: str) -> None:
    with pytest.raises(HTTPError) as rejected:
        get(f"{address}recording/index.json", {"Origin": "http://elsewhere.example"})
    assert rejected.value.code == 403
    rejected.value.close()


def test_verdict_is_served_when_it_is_known(recording: Path, built: None, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(answers, "verdict", lambda _: Verdict("equal", "result"))
    with playing(recording) as address:
        until(lambda: json.loads(get(f"{address}recording/verdict.json"))["state"] == "equal", "the verdict")
        index = msgspec.json.decode(get(f"{address}recording/index.json"), type=PlaybackIndex)
    assert index.verdict == Verdict("equal", "result")


def test_address_is_printed_and_opened(
    recording: Path, built: None, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    opened: list[str] = []
    monkeypatch.setattr(webbrowser, "open", opened.append)
    monkeypatch.setattr(uvicorn.Server, "run", lambda *_, **__: None)
    serve_recording(recording, host="127.0.0.1", port=0, open_browser=True)
    first, second = capsys.readouterr().out.splitlines()
    assert first.endswith(f" {opened[0]}") and "flight.mcap" in second


def test_file_that_is_not_a_recording_is_rejected_before_serving(built: None, tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("no recording", encoding="utf-8")
    with pytest.raises(RecordingError, match=r"notes\.txt: "):
        serve_recording(tmp_path / "notes.txt", host="127.0.0.1", port=0, open_browser=False)
