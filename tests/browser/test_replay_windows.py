"""Secondary windows of a recording: monitor, cameras and strips follow the playhead of the page."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Locator, Page

from tests.browser.conftest import SIZES, OpenPage
from tests.browser.flight import Flight, shows
from tests.browser.layout_checks import assert_readable, assert_tidy
from tests.browser.test_windows import open_window, tag, who
from tests.station.recordings import playing, record_run

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.long]

STEPS = 600
FOLLOWS = who("Keys act here too")


@pytest.fixture(scope="module")
def station(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Address of a recording's server, for `open_page`."""
    path: Path = tmp_path_factory.mktemp("windows") / "flight.mcap"
    record_run(path, STEPS)
    with playing(path) as address:
        yield address


@pytest.fixture
def replay(open_page: OpenPage) -> Flight:
    return open_page()


@pytest.fixture
def strips(replay: Flight) -> Flight:
    return following(replay, replay.page.get_by_role("button", name="Strips ↗"))


@pytest.fixture
def monitor(replay: Flight) -> Flight:
    return following(replay, replay.page.locator(".monitor").nth(1).get_by_role("button", name="Own window"))


def following(replay: Flight, key: Locator) -> Flight:
    """Open a window by a button; return it after it has received data of its page."""
    window = open_window(replay, key)
    window.until(FOLLOWS)
    return window


def seek(page: Page, part: float) -> None:
    """Click the time axis at a fraction of its length."""
    box = page.locator(".scrub").bounding_box()
    assert box is not None
    page.mouse.click(box["x"] + part * box["width"], box["y"] + box["height"] / 2)


def test_seek_in_the_page_or_the_strips_moves_all_windows(replay: Flight, strips: Flight, monitor: Flight) -> None:
    for page, part in ((replay.page, 0.75), (strips.page, 0.25)):
        seek(page, part)
        tick = replay.until(f"Math.abs(frame.tick - {part * STEPS}) < 5").tick
        strips.until(f"frame.tick === {tick}")
        monitor.until(f"frame.tick === {tick}")
        value = replay.script(tag("POR rate"))
        strips.until(f"{tag('POR rate')} === '{value}'")


def test_keys_of_windows_play_the_replay_in_all_windows(replay: Flight, strips: Flight, monitor: Flight) -> None:
    replay.page.get_by_role("button", name="2×: speed 2", exact=True).click()
    monitor.press(" ")
    replay.until("document.querySelector('.play').textContent === 'Pause' && frame.tick > 20")
    strips.until("frame.tick > 40")
    monitor.until("frame.tick > 60")
    strips.press(" ")
    replay.until("document.querySelector('.play').textContent === 'Play'")
    tick = replay.frame().tick
    strips.press("Shift+ArrowRight")  # one frame
    for window in (replay, strips, monitor):
        window.until(f"Math.abs(frame.tick - {tick}) < 5")
    monitor.press("End")
    for window in (replay, strips, monitor):
        window.until(f"frame.tick === {STEPS}")


def test_monitor_window_shows_and_selects_the_camera_of_its_monitor(replay: Flight, monitor: Flight) -> None:
    monitor.until(shows(0, "WR"))
    replay.press("x", "4")
    monitor.until(shows(0, "D"))
    monitor.page.get_by_role("button", name="KEEL", exact=True).click()
    replay.until(shows(1, "KEEL"))
    monitor.press("3")
    replay.until(shows(1, "C"))
    monitor.until(shows(0, "C"))


def test_window_of_all_cameras_follows_the_playhead(replay: Flight) -> None:
    window = following(replay, replay.page.get_by_role("button", name="Cameras ↗"))
    seek(replay.page, 0.5)
    tick = replay.until(f"Math.abs(frame.tick - {STEPS / 2}) < 5").tick
    window.until(f"frame.tick === {tick}")
    window.page.locator(".tile").filter(has_text="KEEL").click()
    replay.until(shows(0, "KEEL"))


def test_strips_window_has_its_own_time_axis_and_fits(replay: Flight, strips: Flight) -> None:
    strips.press("=")
    strips.until("!document.querySelector('[aria-label=Wider]').disabled")
    assert replay.page.get_by_role("button", name="Wider").is_disabled()
    assert "flight.mcap" in strips.page.locator(".rail").inner_text()
    for width, height in SIZES:
        strips.page.set_viewport_size({"width": width, "height": height})
        strips.until(f"innerWidth === {width} && innerHeight === {height}")
        assert_tidy(strips)
        assert_readable(strips, least=20)


def test_window_of_a_closed_page_says_so_and_still_seeks(replay: Flight, strips: Flight) -> None:
    replay.page.goto("about:blank")
    strips.until(who("Its page is closed"))
    seek(strips.page, 0.5)  # a click moves the playhead also without the page
    strips.until(f"Math.abs(frame.tick - {STEPS / 2}) < 5")


def test_blocked_window_is_reported(open_page: OpenPage) -> None:
    replay = open_page(prepare=lambda page: page.add_init_script("window.open = () => null"))
    replay.page.get_by_role("button", name="Strips ↗").click()
    replay.until("document.querySelector('.said').textContent.startsWith('Pop-ups are blocked')")
