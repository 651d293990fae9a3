"""Sheets that show what decides the order of a picture, requested from a station over HTTP."""

from __future__ import annotations

import dataclasses
import itertools
import re
import threading
import time
import xml.etree.ElementTree as ET

import pytest

from aftdeck.errors import SimulationError
from aftdeck.scenario.all_cameras import cameras_of
from aftdeck.station.server import sheets
from aftdeck.station.session.painter import Painter
from aftdeck.station.session.session import Session
from tests.loaded import scenario
from tests.station.pages import Station, served, until
from tests.waits import WAIT_S

NAME = "concept-1972-script"


def title(svg: str) -> str:
    """Return the first text of a sheet."""
    found = ET.fromstring(svg).find("{http://www.w3.org/2000/svg}text")
    assert found is not None
    return found.text or ""


def time_s(svg: str) -> float:
    """Return the time in the title of a sheet [s]."""
    found = re.search(r"at ([\d.]+) s$", title(svg))
    assert found is not None
    return float(found[1])


def sheet(station: Station, camera: str) -> str:
    """Return a sheet; the first ones may be answered while laws are still being compiled."""
    until(lambda: station.get(f"/planes/{camera}.svg")[0] != 202, "the laws of the pictures")
    status, text = station.get(f"/planes/{camera}.svg")
    assert status == 200
    return text


def test_sheets_follow_the_run_and_name_unknown_cameras() -> None:
    with served(Session(scenario(NAME), demo=True)) as station:
        first = sheet(station, "A")
        assert f"{scenario(NAME).title}, camera A" in title(first)
        until(lambda: time_s(sheet(station, "A")) > time_s(first) + 0.5, "a later sheet")
        assert "camera AFT at" in title(sheet(station, "AFT"))
        names = ", ".join(camera.name for camera in cameras_of(scenario(NAME)))
        assert station.get("/planes/A9.svg") == (404, f"no camera is called 'A9'; cameras are {names}\n")
        station.session.painter.prepare = lambda: False  # type: ignore[method-assign]
        assert station.get("/planes/A.svg") == (202, f"{station.session.painter.text}\n")


def test_a_picture_that_cannot_be_drawn_is_explained(monkeypatch: pytest.MonkeyPatch) -> None:
    def inside(*_: object) -> str:
        raise SimulationError("camera B at 3 s is inside payload-1 or touches it")

    with served(Session(scenario(NAME))) as station:
        sheet(station, "A")
        monkeypatch.setattr(Painter, "sheet", inside)
        answer = station.get("/planes/B.svg")
        assert answer == (409, "No picture: camera B at 3 s is inside payload-1 or touches it.\n")


def test_sheets_show_the_frame_of_the_pictures() -> None:
    delay = 1.5
    with served(Session(dataclasses.replace(scenario(NAME), camera_delay=delay))) as station:

        def newest_s() -> float:
            newest = station.session.painter.newest
            return newest.frame.time_s if newest is not None else 0.0

        sheet(station, "A")
        until(lambda: newest_s() > 2.0 * delay, "a frame that pictures show later")
        before, shown = newest_s(), time_s(sheet(station, "A"))
        assert before - delay - 0.01 < shown < newest_s() - delay + 0.01


def test_requests_beyond_the_allowed_rate_wait(monkeypatch: pytest.MonkeyPatch) -> None:
    drawn: list[float] = []

    def draw(*_: object) -> bytes:
        drawn.append(time.monotonic())
        return b"<svg/>"

    monkeypatch.setattr(sheets, "SHEETS_PER_SECOND", 2.0)
    monkeypatch.setattr(sheets, "SHEETS_AT_ONCE", 1.0)
    monkeypatch.setattr(Painter, "sheet", draw)
    monkeypatch.setattr(Painter, "prepare", lambda *_: True)
    with served(Session(scenario(NAME))) as station:
        until(lambda: station.session.painter.newest is not None, "a frame")
        for _ in range(3):
            assert station.get("/planes/A.svg") == (200, "<svg/>")
    assert all(later - earlier >= 0.49 for earlier, later in itertools.pairwise(drawn))


def test_station_ends_while_a_sheet_is_drawn(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    drawing, ended = threading.Event(), threading.Event()

    def draw(*_: object) -> bytes:
        drawing.set()
        assert ended.wait(WAIT_S)
        return b"<svg/>"

    monkeypatch.setattr(Painter, "sheet", draw)
    monkeypatch.setattr(Painter, "prepare", lambda *_: True)
    with served(Session(scenario(NAME))) as station:
        until(lambda: station.session.painter.newest is not None, "a frame")
        client = threading.Thread(target=station.get, args=("/planes/A.svg",), daemon=True)
        client.start()
        assert drawing.wait(WAIT_S)
        threading.Timer(3.0, ended.set).start()
    client.join(WAIT_S)
    assert "Traceback" not in capsys.readouterr().err
