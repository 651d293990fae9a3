"""Recording in one HTML file: complete, short enough, and without references to other files."""

from __future__ import annotations

import base64
import gzip
import re
from pathlib import Path

import msgspec
import pytest

from aftdeck.errors import InputError, RecordingError
from aftdeck.station import built as station_built
from aftdeck.station.messages.playback import Block, PlaybackIndex
from aftdeck.station.playback import one_file
from aftdeck.station.playback.one_file import write_html
from aftdeck.station.playback.store import PlaybackStore
from aftdeck.station.playback.verdict import CHECKING
from tests.station.recordings import record_run

PAGE = """<html><head><title>Aftdeck</title>
    <script type="module" crossorigin src="./assets/a.js"></script>
    <link rel="stylesheet" crossorigin href="./assets/a.css">
</head><body><div id="page"></div></body></html>"""
SCRIPT = "const text = '</script>';"
STYLE = '@font-face{src:url(./f.woff2)format("woff2"),url(./f.woff)format("woff")}'


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("html") / "a<b.mcap"
    record_run(path, 600)
    return path


@pytest.fixture(autouse=True)
def page(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Write a small page in the form of the built page."""
    assets = tmp_path / "static" / "assets"
    assets.mkdir(parents=True)
    (assets.parent / "index.html").write_text(PAGE, encoding="utf-8")
    (assets.parent / "notices.txt").write_text("a licence </script>", encoding="utf-8")
    (assets / "a.js").write_text(SCRIPT, encoding="utf-8")
    (assets / "a.css").write_text(STYLE, encoding="utf-8")
    (assets / "f.woff2").write_bytes(b"font")
    monkeypatch.setattr(station_built, "STATIC", assets.parent)
    monkeypatch.setattr(one_file, "STATIC", assets.parent)


def parts(text: str) -> tuple[PlaybackIndex, Block]:
    """Return the contents of an HTML file: its index, and its `Moment`s as one block."""
    packed = re.findall(r'<script type="text/plain" id="recording-(?:index|\d+)">([^<]+)</script>', text)
    plain = [gzip.decompress(base64.b64decode(part)) for part in packed]
    blocks = [msgspec.json.decode(part, type=Block) for part in plain[1:]]
    return msgspec.json.decode(plain[0], type=PlaybackIndex), sum(blocks, start=())


def test_file_contains_script_style_and_fonts(recording: Path, tmp_path: Path) -> None:
    write_html(recording, tmp_path / "out.html")
    text = (tmp_path / "out.html").read_text(encoding="utf-8")
    assert not re.search(r'(src|href)="', text.replace('href="data:', ""))
    assert f"url(data:font/woff2;base64,{base64.b64encode(b'font').decode()})" in text
    assert ".woff)" not in text
    assert r"const text = '<\/script>';" in text
    assert "<title>a&lt;b.mcap · Aftdeck</title>" in text
    assert r"a licence <\/script>" in text


@pytest.mark.slow
def test_file_contains_all_frames_to_a_tenth_of_a_millimetre(recording: Path, tmp_path: Path) -> None:
    write_html(recording, tmp_path / "out.html")
    index, moments = parts((tmp_path / "out.html").read_text(encoding="utf-8"))
    assert index.stride == 1
    with PlaybackStore(recording) as store:
        for shown, exact in zip(moments, store.moments(1), strict=True):
            assert shown.frame.tick == exact.frame.tick
            assert shown.frame.display.poses == pytest.approx(exact.frame.display.poses, abs=0.51e-4)
            assert shown.frame.angles == pytest.approx(exact.frame.angles, abs=0.51e-4)


@pytest.mark.slow
def test_long_run_is_thinned_but_its_lanes_strips_and_log_are_not(
    recording: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_html(recording, tmp_path / "whole.html")
    limit = 100_000
    monkeypatch.setattr(one_file, "LIMIT", limit)
    write_html(recording, tmp_path / "out.html")
    text = (tmp_path / "out.html").read_text(encoding="utf-8")
    assert limit * 0.5 < len(text.encode()) <= limit
    index, moments = parts(text)
    assert index.stride > 1
    assert [moment.frame.tick for moment in moments] == list(range(1, 601, index.stride))
    whole, _ = parts((tmp_path / "whole.html").read_text(encoding="utf-8"))
    assert msgspec.structs.replace(index, stride=1) == whole
    with PlaybackStore(recording) as store:
        assert index.events == store.index(CHECKING).events


def test_run_that_cannot_fit_is_rejected(recording: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(one_file, "LIMIT", 2000)
    with pytest.raises(RecordingError, match=r"a<b\.mcap: .* 2000 bytes"):
        write_html(recording, tmp_path / "out.html")
    assert not (tmp_path / "out.html").exists()


def test_existing_file_is_not_overwritten(recording: Path, tmp_path: Path) -> None:
    (tmp_path / "out.html").write_text("mine", encoding="utf-8")
    with pytest.raises(InputError, match=r"out\.html: "):
        write_html(recording, tmp_path / "out.html")
    assert (tmp_path / "out.html").read_text(encoding="utf-8") == "mine"


def test_file_that_cannot_be_written_is_rejected(recording: Path, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("", encoding="utf-8")
    with pytest.raises(InputError, match=r"out\.html: "):
        write_html(recording, tmp_path / "file" / "out.html")


def test_name_that_no_file_can_have_is_an_error_with_the_name(recording: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="cannot be the name"):
        write_html(recording, tmp_path / ("a" * 300 + ".html"))
