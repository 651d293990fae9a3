"""A recording played back in a browser: from its server, and as one HTML file."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from aftdeck.recording.reader import Recording
from aftdeck.recording.trial import Trial
from aftdeck.station.playback.one_file import write_html
from tests.browser.conftest import NARROW, SIZES, OpenPage
from tests.browser.flight import WAIT_MS, Flight
from tests.browser.layout_checks import assert_readable, assert_tidy, clashes
from tests.station.recordings import playing, record_run
from tests.waits import WAIT_S

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


LAID_OUT = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
"""Waits until the page has the layout of its size and parts. A paused replay may draw no picture then."""


DRAWN_WITHIN = 30
"""Number of waits for the layout until pictures, and the texts in them, are drawn in a window's new size."""


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


def _drawn_last(replay: Flight) -> int:
    """Return the step that a replay shows when it stands still: its last picture is drawn after the key."""
    before, now = -1, replay.frame().tick
    while now != before:
        time.sleep(0.5)
        before, now = now, replay.frame().tick
    return now


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
    tick = _drawn_last(replay)
    press(replay, "8×: speed 8")
    drawn = replay.script("window.__aftdeck.frames")
    assert replay.frame().tick == tick
    replay.press(" ")
    replay.until("frame.tick === 600")
    assert replay.script("window.__aftdeck.frames") > drawn
    replay.until("document.querySelector('.play').textContent === 'Play'")


def test_click_and_keys_seek_to_recorded_values_also_on_the_desk(replay: Flight, recording: Path) -> None:
    box = replay.page.locator(".scrub").bounding_box()
    assert box is not None
    replay.page.mouse.click(box["x"] + box["width"] * 0.3, box["y"] + box["height"] / 2)
    replay.until(f"Math.abs(frame.time_s - {0.3 * DURATION}) < 0.03")
    assert_values_are_those_recorded(replay, recording)
    before = replay.frame().tick
    replay.press("ArrowRight")
    replay.until(f"Math.abs(frame.tick - {before + 50}) <= 1")
    replay.press("d")
    replay.until("document.querySelector('.thc .value').textContent === '+0.50'")
    replay.until("document.querySelector('[aria-label=Rate] [aria-pressed=true]').textContent === 'Vernier'")
    assert replay.script("document.querySelector('.desk').inert")
    replay.press("d")
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


def test_replay_is_tidy_with_and_without_the_desk_at_every_size(replay: Flight) -> None:
    replay.press("End")
    replay.until("frame.tick === 600")
    for width, height in [*SIZES, *NARROW]:
        for change in ("size", "desk", "time"):
            if change == "size":
                replay.page.set_viewport_size({"width": width, "height": height})
            else:
                replay.press("d")
            replay.until(f"innerWidth === {width} && innerHeight === {height}")
            replay.script(LAID_OUT)
            if change != "desk" or (width, height) != (1024, 768):  # here, the desk scrolls
                for _ in range(DRAWN_WITHIN):
                    if not clashes(replay):
                        break
                    replay.script(LAID_OUT)
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


SEVENTIES = "document.querySelector('.monitor .picture > canvas.polygons')"
SECOND = "document.querySelectorAll('.monitor')[1].querySelector('.picture > canvas.polygons')"
BRIGHT = f"""(() => {{
    const canvas = {SEVENTIES};
    const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
    let sum = 0;
    for (let i = 0; i < data.length; i += 4) sum += data[i] * ((i >> 2) % 997);
    return sum;
}})()"""
"""A number that changes with the picture in the look of 1972; 0 if it is black."""


@pytest.mark.slow
def test_replay_has_the_look_of_1972_at_the_playhead(replay: Flight) -> None:
    monitor = replay.page.locator(".monitor").first
    assert monitor.get_by_role("button", name="Planes").count() == 0
    look = monitor.get_by_role("button", name="1972", exact=True)
    look.click()
    replay.until(f"!{SEVENTIES}.hidden && {BRIGHT} > 0", WAIT_S * 1000)
    first = replay.script(BRIGHT)
    press(replay, "Play")
    replay.until(f"{BRIGHT} !== {first}", WAIT_S * 1000)
    look.click()
    replay.until(f"{SEVENTIES}.hidden")
    press(replay, "Pause")
    replay.script(LAID_OUT)
    for shown in ("true", "false"):  # nothing else changes in a paused replay
        replay.page.locator(".monitor").nth(1).get_by_role("button", name="1972", exact=True).click()
        replay.until(f"{SECOND}.hidden !== {shown}")


def test_one_file_has_no_look_of_1972(recording: Path, tmp_path: Path, browser: Browser) -> None:
    """Nothing computes its polygons."""
    path = tmp_path / "flight.html"
    write_html(recording, path)
    page = browser.new_page()
    page.goto(f"{path.as_uri()}?quality=low")
    page.locator(".monitor").first.wait_for()
    assert page.get_by_role("button", name="1972", exact=True).count() == 0
    page.close()
