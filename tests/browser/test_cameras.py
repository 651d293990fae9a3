"""Cameras on the page: selection, drives, split monitors, display of all cameras, and secondary windows."""

from __future__ import annotations

import math
import re
from typing import Any

import pytest
from playwright.sync_api import Page

from tests.browser.conftest import NARROW, SIZES, OpenPage
from tests.browser.flight import FLIES, OBSERVES, WAIT_MS, Flight, shows
from tests.browser.layout_checks import assert_readable, assert_tidy

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.long]

SCENARIO = "concept-1972"
CAMERAS = [*"ABCDEFGHI", "P1", "P2", "CAE2", "W", "AFT", "ENG"]
"""The first press of a digit selects one of the cameras 1 to 10, the second press one of the cameras 11 to 20."""


def lens(flight: Flight) -> str:
    """Return the read-out of the camera's drives and lens in MON 1's picture."""
    return str(flight.page.locator(".monitor .lens").first.inner_text())


def figure(flight: Flight, name: str) -> float:
    """Return ``PAN``, ``TILT``, ``ZOOM`` or ``FOV`` from MON 1's picture."""
    found = re.search(rf"{name} ([+−]?[\d.]+)", lens(flight))
    assert found is not None, lens(flight)
    return float(found[1].replace("−", "-"))


def drawn(flight: Flight) -> bytes:
    """Return a screenshot of the centre of MON 1's picture."""
    box = flight.page.locator(".picture").first.bounding_box()
    assert box is not None
    clip: Any = {"x": box["x"] + box["width"] / 4, "y": box["y"] + box["height"] / 4, "width": 120, "height": 80}
    return bytes(flight.page.screenshot(clip=clip))


def steady(flight: Flight, steps: int = 15) -> None:
    """Wait until more than `steps` further control steps have run, and the page has been drawn again."""
    tick, count = flight.frame().tick, flight.script("window.__aftdeck.frames")
    flight.until(f"frame.tick > {tick + steps} && window.__aftdeck.frames > {count + 4}")


def test_monitors_start_with_two_cameras_that_see_the_clearance(flight: Flight) -> None:
    names = [flight.page.locator(".monitor .name b").nth(i).inner_text() for i in (0, 1)]
    assert len(set(names)) == 2
    flight.press("c")
    for name in names:
        flight.page.locator(f".tile[aria-label^='{name},'][aria-label*='gap']").wait_for()


def test_digits_select_every_camera_on_either_monitor(flight: Flight) -> None:
    for monitor in (0, 1):
        for index, name in enumerate(CAMERAS):
            digit = str((index + 1) % 10)
            flight.press(digit)
            if index >= 10:
                flight.press(digit)
            flight.until(shows(monitor, name))
            flight.press(",")  # the next press of the same digit is then a first press
        flight.press("x")


def test_buttons_select_every_camera_on_either_monitor(flight: Flight) -> None:
    for monitor in (0, 1):
        keys = flight.page.get_by_role("group", name=f"Camera of MON {monitor + 1}").get_by_role("button")
        assert keys.all_inner_texts() == CAMERAS
        for index, name in enumerate(CAMERAS):
            keys.nth(index).click()
            flight.until(shows(monitor, name))
            assert keys.nth(index).get_attribute("aria-pressed") == "true"


def test_arrow_keys_turn_the_camera_until_they_are_released(flight: Flight) -> None:
    flight.press("3")
    steady(flight)
    before, picture = figure(flight, "PAN"), drawn(flight)
    flight.hold("ArrowRight")
    flight.until(f"frame.views[2][0] > {math.radians(before + 5.0)}")
    flight.release("ArrowRight")
    flight.until("frame.sequence === 'idle'")
    steady(flight)
    stopped = flight.frame().views[2]
    assert figure(flight, "PAN") == pytest.approx(math.degrees(stopped[0]), abs=0.06)
    assert drawn(flight) != picture
    steady(flight)
    assert flight.frame().views[2] == stopped
    tilt = figure(flight, "TILT")
    flight.hold("ArrowUp")
    flight.until(f"frame.views[2][1] > {math.radians(tilt + 2.0)}")
    flight.release("ArrowUp")
    assert flight.frame().translation == (0, 0, 0)


def test_zoom_and_tilt_stop_at_their_limits_and_show_it(flight: Flight) -> None:
    flight.press("3")
    flight.hold("PageUp")
    flight.until(f"frame.views[2][2] < {math.radians(25.0) + 1e-5}")
    steady(flight)
    flight.release("PageUp")
    assert figure(flight, "FOV") == 25.0
    assert figure(flight, "ZOOM") == 100
    flight.hold("ArrowDown")
    flight.until(f"frame.views[2][1] < {math.radians(-80.0) + 1e-5}")
    steady(flight)
    flight.release("ArrowDown")
    assert "TILT −80.0 STOP" in lens(flight)


def test_camera_stops_when_the_page_loses_the_focus(flight: Flight) -> None:
    flight.press("3")
    before = flight.frame().views[2][0]
    flight.hold("ArrowLeft")
    flight.until(f"frame.views[2][0] < {before - 0.01}")
    flight.script("window.dispatchEvent(new Event('blur'))")
    steady(flight)
    still = flight.frame().views[2]
    steady(flight)
    assert flight.frame().views[2] == still
    flight.release("ArrowLeft")


def test_z_splits_the_monitor_and_x_selects_its_halves(flight: Flight) -> None:
    flight.press("1", "x", "2", "x", "z")
    flight.press("3")
    flight.until(shows(0, "A", "C"))
    flight.press("x", "4")
    flight.until(shows(1, "D"))
    flight.press("x", "5")
    flight.until(shows(0, "E", "C"))
    assert flight.page.locator(".monitor").first.locator(".lens").count() == 2
    flight.page.locator(".monitor").first.get_by_role("button", name="Split").click()
    flight.until(shows(0, "E"))


def test_c_shows_all_cameras_and_a_click_or_digit_selects_one(flight: Flight) -> None:
    flight.press("1", "x", "2", "x", "c")
    tiles = flight.page.locator(".tile")
    flight.until(f"document.querySelectorAll('.tile').length === {len(CAMERAS)}")
    assert flight.page.locator(".tile .caption > b").all_inner_texts() == CAMERAS
    flight.until("document.querySelectorAll('.tile.used').length === 2")
    flight.page.locator(".pair-words").get_by_text(re.compile(r"both see tip, .*gap, \d+° apart")).wait_for()
    assert flight.page.locator(".strip-below .lamp").count() >= 8
    assert flight.page.locator(".strip-below .gap-value").inner_text() != ""
    tiles.filter(has_text="CAE2").click()
    flight.until(shows(0, "CAE2"))
    assert not flight.page.locator(".matrix").is_visible()
    assert flight.page.locator(".desk > .clearance").is_visible()
    flight.press("c", "8")
    flight.until(shows(0, "H"))
    flight.press("c")
    flight.page.locator(".matrix").wait_for(state="visible")
    flight.press("c")
    flight.page.locator(".desk").wait_for(state="visible")


def test_arm_can_be_flown_while_all_cameras_are_shown(flight: Flight) -> None:
    flight.press("c")
    start = flight.frame().display.actual.position
    flight.hold("w")
    flight.until(f"Math.abs(frame.display.actual.position[0] - {start[0]}) > 0.02")
    flight.release("w")


def test_mouse_and_keys_turn_the_engineering_view_and_no_camera(flight: Flight) -> None:
    flight.page.get_by_role("group", name="Camera of MON 1").get_by_role("button", name="ENG").click()
    steady(flight)
    views, picture = flight.frame().views, drawn(flight)
    box = flight.page.locator(".picture").first.bounding_box()
    assert box is not None
    flight.page.mouse.move(box["x"] + 100, box["y"] + 100)
    flight.page.mouse.down()
    flight.page.mouse.move(box["x"] + 200, box["y"] + 120, steps=4)
    flight.page.mouse.up()
    steady(flight)
    dragged = drawn(flight)
    assert dragged != picture
    flight.hold("ArrowLeft")
    steady(flight)
    flight.release("ArrowLeft")
    assert drawn(flight) != dragged
    assert flight.frame().views == views


def test_engineering_view_turns_about_its_target_and_can_be_shifted(
    flight: Flight,
) -> None:
    flight.page.get_by_role("group", name="Camera of MON 1").get_by_role("button", name="ENG").click()
    steady(flight)
    flight.press("End")  # lock the exposure
    first = flight.page.locator(".monitor").first
    pictures = []
    for target in ("start", "tip", "payload", "gap"):
        round_ = first.get_by_role("button", name=f"Centre: {target}", exact=True)
        steady(flight)
        pictures.append(drawn(flight))
        round_.click()
    assert len(set(pictures[:3])) == 3
    first.get_by_role("button", name="Centre: start", exact=True).wait_for()
    steady(flight)
    before = drawn(flight)
    box = flight.page.locator(".picture").first.bounding_box()
    assert box is not None
    flight.page.mouse.move(box["x"] + 100, box["y"] + 100)
    flight.page.mouse.down(button="right")
    flight.page.mouse.move(box["x"] + 140, box["y"] + 100, steps=4)
    flight.page.mouse.up(button="right")
    steady(flight)
    dragged = drawn(flight)
    assert dragged != before
    first.get_by_role("button", name="Shift", exact=True).click()
    flight.hold("ArrowLeft")
    steady(flight)
    flight.release("ArrowLeft")
    assert drawn(flight) != dragged


def test_monitor_window_shows_the_camera_of_its_monitor(flight: Flight) -> None:
    flight.press("1", "x", "2", "x")
    with flight.page.expect_popup() as opened:
        flight.page.locator(".monitor").nth(1).get_by_role("button", name="Own window").click()
    page: Page = opened.value
    page.set_default_timeout(WAIT_MS)
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    second = Flight(page)
    second.until(shows(0, "B"))
    assert page.locator(".monitor").count() == 1
    assert page.locator(".desk").count() == 0
    tick = flight.frame().tick
    second.until(f"frame.tick > {tick}")
    flight.press("x", "7")
    second.until(shows(0, "G"))
    page.get_by_role("button", name="P1", exact=True).click()
    flight.until(shows(1, "P1"))
    assert flight.script(FLIES)
    assert errors == []
    page.close()


def test_window_of_all_cameras_selects_for_the_page(flight: Flight) -> None:
    flight.press("1", "c")
    with flight.page.expect_popup() as opened:
        flight.page.locator(".views").get_by_role("button", name="Own window").click()
    page: Page = opened.value
    page.set_default_timeout(WAIT_MS)
    second = Flight(page)
    flight.press("c")
    page.locator(".tile").filter(has_text="P2").click()
    flight.until(shows(0, "P2"))
    second.until(f"document.querySelectorAll('.tile').length === {len(CAMERAS)}")
    page.close()


def test_nothing_scrolls_overlaps_or_fades(flight: Flight) -> None:
    for width, height in [*SIZES, *NARROW]:
        flight.page.set_viewport_size({"width": width, "height": height})
        flight.until(f"innerWidth === {width} && innerHeight === {height}")
        for key in ("z", "c"):
            flight.press(key)
            steady(flight, 5)
            assert_tidy(flight)
            assert_readable(flight)
        flight.press("c", "z")


def test_turning_a_fixed_camera_is_rejected_in_the_log(flight: Flight) -> None:
    flight.page.get_by_role("group", name="Camera of MON 1").get_by_role("button", name="AFT", exact=True).click()
    with flight.logs("page"):
        flight.hold("ArrowRight")
    flight.release("ArrowRight")


def test_drag_pans_and_tilts_and_the_wheel_zooms_the_camera(flight: Flight) -> None:
    flight.press("1", "x", "3")
    flight.until(shows(1, "C"))
    flight.press("x")
    page = flight.page
    box = page.locator(".picture").nth(1).bounding_box()
    assert box is not None
    middle = (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    pan, tilt, angle = flight.frame().views[2]
    page.mouse.move(*middle)
    page.locator(".picture").nth(1).locator(".hint").wait_for(state="visible")
    page.mouse.down()
    flight.until("document.querySelectorAll('.monitor')[1].matches('.in-hand')")
    page.mouse.move(middle[0] + 60, middle[1] - 60, steps=3)
    flight.until(f"frame.views[2][0] > {pan + 0.02} && frame.views[2][1] > {tilt + 0.02}")
    page.mouse.up()
    steady(flight)
    stopped = flight.frame().views[2]
    assert stopped[2] == angle
    steady(flight)
    assert flight.frame().views[2] == stopped
    page.mouse.wheel(0, -100)
    flight.until(f"frame.views[2][2] < {angle - 0.002}")
    steady(flight)
    narrow = flight.frame().views[2][2]
    page.mouse.wheel(0, 100)
    flight.until(f"frame.views[2][2] > {narrow + 0.002}")


def test_drag_of_an_observer_turns_no_camera(flight: Flight, open_page: OpenPage) -> None:
    observer = open_page()
    observer.until(OBSERVES)
    observer.press("3")
    picture = observer.page.locator(".picture").first
    picture.hover()
    picture.locator(".barred").wait_for(state="visible")
    before = observer.frame().views
    observer.page.mouse.down()
    box = picture.bounding_box()
    assert box is not None
    with observer.logs("page"):
        observer.page.mouse.move(box["x"] + 30, box["y"] + 30, steps=3)
    observer.page.mouse.up()
    steady(observer)
    assert observer.frame().views == before
