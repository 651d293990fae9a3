"""A recording played back in a browser: from its server, and as one HTML file."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from aftdeck.recording.reader import Recording
from aftdeck.recording.trial import Trial
from aftdeck.station.playback.one_file import write_html
from tests.browser.conftest import NARROW, SIZES, OpenPage
from tests.browser.flight import WAIT_MS, Flight
from tests.browser.layout_checks import assert_readable, assert_tidy
from tests.station.recordings import playing, record_run

pytestmark = pytest.mark.browser

DURATION = 12.0
"""Length of the recording [s]."""
MEGABYTES = 5_000_000
TRIAL = Trial("P07", "command delay 2 s, wrist camera off, second of three sessions, orbiter axes first")


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("replay") / "flight.mcap"
    record_run(path, 600, trial=TRIAL)
    return path


@pytest.fixture(scope="module")
def station(recording: Path) -> Iterator[str]:
    """Address of the recording's server, for `open_page`."""
    with playing(recording) as address:
        yield address


@pytest.fixture
def replay(open_page: OpenPage) -> Flight:
    """A page that shows the first frame of the recording."""
    return open_page()


def press(replay: Flight, name: str) -> None:
    """Press a button of the transport."""
    replay.page.get_by_role("group", name="Playing").get_by_role("button", name=name, exact=True).first.click()


def assert_values_are_those_recorded(replay: Flight, recording: Path) -> None:
    """Assert that the displayed frame and read-outs equal the recorded frame of the same tick."""
    shown = replay.frame()
    record = next(frame for _, frame in Recording(recording).steps() if frame.tick == shown.tick)
    assert shown.angles == record.angles
    parts = [abs(rate) / limit for rate, limit in zip(record.rates, record.rate_limits, strict=True)]
    joint = Recording(recording).opening.joints[parts.index(max(parts))].replace("_", " ")
    tag = "[...document.querySelectorAll('.strip')].find((row) => row.textContent.startsWith('Joint rate'))"
    replay.until(f"{tag}.querySelector('.tag').textContent === '{max(parts):.2f} {joint}'")
    replay.until(f"document.querySelector('.picture .code').textContent.endsWith('{record.time_s:05.2f}')")


def test_replay_plays_faster_pauses_and_ends_at_the_last_frame(replay: Flight) -> None:
    assert replay.frame().tick == 1
    words = replay.page.locator(".rail").inner_text()
    assert "REPLAY" in words
    assert "flight.mcap" in words
    assert "First flight" in words
    assert replay.page.locator(".burned.time").first.inner_text().endswith("recorded")
    press(replay, "Play")
    replay.until("frame.tick > 10")
    replay.press(" ")
    replay.until("document.querySelector('.play').textContent === 'Play'")
    tick = replay.frame().tick
    press(replay, "8×: speed 8")
    drawn = replay.script("window.__aftdeck.frames")
    assert replay.frame().tick == tick
    replay.press(" ")
    replay.until("frame.tick === 600")
    assert replay.script("window.__aftdeck.frames") > drawn
    replay.until("document.querySelector('.play').textContent === 'Play'")


def test_click_and_keys_seek_to_recorded_values(replay: Flight, recording: Path) -> None:
    box = replay.page.locator(".scrub").bounding_box()
    assert box is not None
    replay.page.mouse.click(box["x"] + box["width"] * 0.3, box["y"] + box["height"] / 2)
    replay.until(f"Math.abs(frame.time_s - {0.3 * DURATION}) < 0.03")
    assert_values_are_those_recorded(replay, recording)
    before = replay.frame().tick
    replay.press("ArrowRight")
    replay.until(f"Math.abs(frame.tick - {before + 50}) <= 1")
    before = replay.frame().tick
    replay.press("Shift+ArrowLeft")
    replay.until(f"frame.tick === {before - 1}")
    replay.press("End")
    replay.until("frame.tick === 600")
    assert_values_are_those_recorded(replay, recording)
    replay.press("[")
    replay.until("frame.tick < 600")
    replay.press("Home")
    replay.until("frame.tick === 1")


def test_desk_of_a_replay_shows_recorded_values_and_is_inert(replay: Flight) -> None:
    replay.press("d")
    replay.page.get_by_role("slider", name="Playhead").focus()
    for _ in range(4):
        replay.press("ArrowRight")
    replay.until("frame.time_s > 4")
    replay.until("document.querySelector('.thc .value').textContent === '+0.50'")
    replay.until("document.querySelector('[aria-label=Rate] [aria-pressed=true]').textContent === 'Vernier'")
    assert replay.script("document.querySelector('.desk').inert")


def test_nothing_scrolls_overlaps_or_fades(replay: Flight) -> None:
    replay.press("End")
    replay.until("frame.tick === 600")
    for width, height in SIZES:
        replay.page.set_viewport_size({"width": width, "height": height})
        replay.until(f"innerWidth === {width} && innerHeight === {height}")
        for _ in range(2):
            assert_tidy(replay)
            assert_readable(replay)
            replay.press("d")


def test_rail_shows_participant_and_condition(replay: Flight) -> None:
    words = replay.page.locator(".rail .words")
    for (name, text), fact in zip(TRIAL._asdict().items(), words.all(), strict=True):
        assert fact.inner_text().lower() == f"{name} {text}".lower()
        assert fact.get_attribute("title") == text, "the tooltip has the whole text"


def test_narrow_replay_is_tidy_with_and_without_the_desk(replay: Flight) -> None:
    replay.press("End")
    replay.until("frame.tick === 600")
    for width, height in NARROW:
        for change in ("size", "desk", "time"):
            drawn = replay.script("window.__aftdeck.frames")
            if change == "size":
                replay.page.set_viewport_size({"width": width, "height": height})
            else:
                replay.press("d")
            replay.until(f"innerWidth === {width} && window.__aftdeck.frames > {drawn}")
            if change != "desk" or height > 768:  # at a height of 768 px or less, the desk scrolls
                assert_tidy(replay)
                assert_readable(replay)


def test_html_file_plays_without_requests_or_errors(browser: Browser, recording: Path, tmp_path: Path) -> None:
    out = tmp_path / "flight.html"
    write_html(recording, out)
    assert out.stat().st_size < MEGABYTES
    page = browser.new_page(viewport={"width": 1280, "height": 720})
    page.set_default_timeout(WAIT_MS)
    requests: list[str] = []
    console: list[str] = []
    page.on("request", lambda request: requests.append(request.url))
    page.on("console", lambda message: console.append(message.text))
    page.on("pageerror", lambda error: console.append(str(error)))
    page.goto(f"{out.as_uri()}?quality=low")
    replay = Flight(page)
    replay.press(" ")
    replay.until("frame.tick > 5")
    replay.press("End")
    replay.until("frame.tick === 600")
    assert_tidy(replay)
    page.close()
    assert [url for url in requests if not url.startswith("data:")] == [f"{out.as_uri()}?quality=low"]
    assert [text for text in console if "GPU stall" not in text] == []


def test_monitors_show_the_recorded_cameras_until_one_is_chosen(replay: Flight) -> None:
    names = "[...document.querySelectorAll('.picture .name b')].map((name) => name.textContent).join()"
    replay.until(f"{names} === 'C,WR'")
    replay.press("End")
    replay.until(f"{names} === 'A,B,ELB'")
    replay.press("Home")
    replay.until(f"{names} === 'C,WR'")
    replay.press("2", "End")
    replay.until("frame.tick === 600")
    assert replay.script(names) == "B,WR"
    replay.press("c")
    replay.page.locator(".tile").first.wait_for()
    replay.page.locator(".tile .words").filter(has_text="tip").first.wait_for()
    replay.press("c")
