"""A recorded capture played back in a browser: clearance, marks, cameras shown in flight, zoom of the time axis."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.browser.conftest import SIZES, OpenPage
from tests.browser.flight import Flight
from tests.browser.layout_checks import assert_readable, assert_tidy
from tests.station.recordings import playing, record_capture

pytestmark = pytest.mark.browser

NAMES = "[...document.querySelectorAll('.picture .name b')].map((name) => name.textContent).join()"
MARKS = "[...document.querySelectorAll('.marks > b')].map((mark) => mark.textContent).join()"
AXIS = "[...document.querySelectorAll('.timeline .axis span')].map((mark) => mark.textContent).join()"


@pytest.fixture(scope="module")
def station(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Address of the recording's server, for `open_page`."""
    path: Path = tmp_path_factory.mktemp("replay") / "capture.mcap"
    record_capture(path)
    with playing(path) as address:
        yield address


@pytest.fixture
def replay(open_page: OpenPage) -> Flight:
    """A page that shows the first frame of the recording."""
    return open_page()


def figure(replay: Flight, name: str) -> str:
    return replay.page.locator(".measures tr", has_text=name).locator("td").inner_text()


def test_clearance_and_capture_have_strip_alarm_figure_and_mark(replay: Flight) -> None:
    assert replay.script(MARKS) == "captured,released"
    lanes = replay.page.locator(".lane", has_text="Alarms").inner_text()
    assert "CLEARANCE" in lanes
    strip = replay.page.locator(".strip", has_text="Clearance")
    assert strip.locator("path.caution").count() == strip.locator("path.warning").count() == 1
    box = replay.page.locator(".scrub").bounding_box()
    assert box is not None
    replay.page.mouse.click(
        box["x"] + box["width"] * 0.75, box["y"] + box["height"] / 2
    )  # the end effector is close to the payload
    replay.until("document.querySelector('.strip .tag').classList.contains('caution')")
    assert figure(replay, "Capture misalignment").endswith("3.0°")
    assert figure(replay, "Smallest clearance").endswith(" in")
    assert [figure(replay, name) for name in ("Brakes used", "Camera changes")] == ["1", "1"]


def test_key_and_button_restore_the_cameras_as_flown(replay: Flight) -> None:
    button = replay.page.get_by_role("button", name="As flown")
    replay.until(f"{NAMES} === 'C,WR'")
    assert button.get_attribute("aria-pressed") == "true"
    for digit, camera, by_key in (("2", "B", True), ("4", "D", False)):
        replay.press(digit)
        replay.until(f"{NAMES} === '{camera},WR'")
        expect(button).to_have_attribute("aria-pressed", "false")
        if by_key:
            replay.press("a")
        else:
            button.click()
        replay.until(f"{NAMES} === 'C,WR'")
    replay.press("End")
    replay.until(f"{NAMES} === 'A,WR'")
    replay.press("c")
    replay.page.locator(".tile .words").filter(has_text="tip").first.wait_for()
    replay.press("c")


def test_time_axis_zooms_about_the_playhead_and_follows_it(replay: Flight) -> None:
    whole = replay.script(AXIS)
    for _ in range(5):
        replay.press("=")
    replay.until(f"{AXIS} !== '{whole}'")
    assert replay.script(MARKS) == ""
    replay.press("End")
    replay.until("Math.abs(parseFloat(document.querySelector('.playhead').style.left) - 100) < 0.1")
    box = replay.page.locator(".scrub").bounding_box()
    assert box is not None
    end = replay.script("Number(document.querySelector('.scrub').getAttribute('aria-valuemax'))")
    replay.page.mouse.click(box["x"] + box["width"] * 0.5, box["y"] + box["height"] / 2)
    replay.until(f"Math.abs(frame.time_s - ({end} - 1)) < 0.05")
    for _ in range(5):
        replay.press("-")
    replay.until(f"{AXIS} === '{whole}'")
    expect(replay.page.get_by_role("button", name="Wider")).to_be_disabled()


def test_nothing_scrolls_overlaps_or_fades(replay: Flight) -> None:
    replay.press("ArrowRight")
    for width, height in SIZES:
        replay.page.set_viewport_size({"width": width, "height": height})
        replay.until(f"innerWidth === {width} && innerHeight === {height}")
        assert_tidy(replay)
        assert_readable(replay)
        fits = "document.querySelector('.run').scrollHeight <= document.querySelector('.run').clientHeight"
        assert replay.script(fits)
        if replay.page.locator(".run .more").first.is_visible():
            replay.page.get_by_role("button", name="Log").click()
            replay.page.locator(".run .log li").first.wait_for()
            assert_tidy(replay)
            replay.page.get_by_role("button", name="Figures").click()
