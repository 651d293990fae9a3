"""The look of 1972 on the monitors: polygons that the station computes, drawn by the page beside WebGL."""

from __future__ import annotations

import re
import time

import numpy as np
import pytest
from playwright.sync_api import Locator

from aftdeck.arrays import Array
from tests.browser.conftest import OpenPage
from tests.browser.flight import Flight
from tests.browser.test_windows import open_window, own_window
from tests.waits import WAIT_S

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.long]

SCENARIO = "concept-1972"

_CANVAS = "[...document.querySelectorAll('.monitor')][{}]?.querySelector('.picture > canvas.polygons')"
_GREY = """(monitor) => {
    const picture = document.querySelectorAll('.monitor')[monitor].querySelector('.picture');
    const own = picture.querySelector('canvas.polygons');
    const canvas = own.hidden ? document.querySelector('canvas.scene') : own;
    const [over, box] = [canvas, picture].map((node) => node.getBoundingClientRect());
    const scale = canvas.width / over.width;
    const small = new OffscreenCanvas(48, 32).getContext('2d');
    const sides = [box.left - over.left, box.top - over.top, box.width, box.height].map((side) => side * scale);
    small.imageSmoothingQuality = 'high';
    small.drawImage(canvas, ...sides, 0, 0, 48, 32);
    const { data } = small.getImageData(0, 0, 48, 32);
    return Array.from({ length: 48 * 32 }, (_, i) => (data[4 * i] + data[4 * i + 1] + data[4 * i + 2]) / 3);
}"""
"""Brightness of a monitor's picture, 0 to 255, in 32 rows of 48 fields."""


def grey(flight: Flight, monitor: int) -> Array:
    """Return the brightness (32, 48) of a monitor's picture, 0 to 255, after some further pictures."""
    count = flight.script("window.__aftdeck.frames")
    flight.until(f"window.__aftdeck.frames > {count + 6}")
    return np.array(flight.page.evaluate(_GREY, monitor)).reshape(32, 48)


def key(flight: Flight, monitor: int) -> Locator:
    """Return the button that switches a monitor to the look of 1972."""
    return flight.page.locator(".monitor").nth(monitor).get_by_role("button", name="1972", exact=True)


def show(flight: Flight, monitor: int, camera: str) -> None:
    """Put a camera on a monitor."""
    cameras = flight.page.locator(".monitor").nth(monitor).locator(".cameras button")
    cameras.filter(has_text=re.compile(f"^{camera}$")).click()


def switch(flight: Flight, monitor: int) -> None:
    """Switch a monitor to the look of 1972, and wait until its first picture is drawn; the first one compiles laws."""
    key(flight, monitor).click()
    flight.until(f"!{_CANVAS.format(monitor)}.hidden")
    end = time.monotonic() + WAIT_S
    while grey(flight, monitor).max() < 30.0:
        assert time.monotonic() < end, "no polygons are drawn"


@pytest.mark.parametrize("camera", ["A", "W"])
def test_polygons_show_the_same_parts_as_webgl_and_follow_the_arm(flight: Flight, camera: str) -> None:
    for monitor in (0, 1):
        show(flight, monitor, camera)
    switch(flight, 0)
    polygons, webgl = grey(flight, 0), grey(flight, 1)
    assert np.mean((polygons > 6.0) == (webgl > 6.0)) > 0.93  # parts and the space beside them
    assert np.corrcoef(polygons.ravel(), webgl.ravel())[0, 1] > 0.8
    flight.hold("q")
    start = flight.frame().position
    flight.until(f"Math.hypot(...frame.position.map((x, i) => x - {list(start)}[i])) > 0.5")
    flight.release("q")
    moved = grey(flight, 0)
    assert np.abs(moved - polygons).max() > 20.0
    assert np.mean((moved > 6.0) == (grey(flight, 1) > 6.0)) > 0.93
    key(flight, 0).click()
    flight.until(f"{_CANVAS.format(0)}.hidden")
    assert np.abs(grey(flight, 0) - grey(flight, 1)).mean() < 8.0  # the arm may still move between the two


def test_the_look_is_stored_for_each_monitor_and_applies_in_secondary_windows(flight: Flight) -> None:
    show(flight, 0, "A")
    show(flight, 1, "F")
    switch(flight, 1)
    flight.page.reload()
    flight.until(f"{_CANVAS.format(0)}?.hidden && !{_CANVAS.format(1)}.hidden")
    window = open_window(flight, own_window(flight, 1))
    window.until(f"{_CANVAS.format(0)} && !{_CANVAS.format(0)}.hidden && {_CANVAS.format(0)}.width > 300")
    assert grey(window, 0).max() > 30.0
    key(window, 0).click()
    flight.until(f"{_CANVAS.format(1)}.hidden")


def test_an_observer_has_the_look(open_page: OpenPage) -> None:
    open_page().until("true")
    observer = open_page()
    show(observer, 0, "F")
    switch(observer, 0)
    assert grey(observer, 0).max() > 30.0


def test_an_engineering_view_has_the_look_and_follows_its_drag(flight: Flight) -> None:
    for monitor in (0, 1):
        show(flight, monitor, "ENG")
    switch(flight, 0)
    assert flight.page.locator(".monitor").first.get_by_role("button", name="Planes").is_hidden()
    first = grey(flight, 0)
    assert (
        np.corrcoef(first.ravel(), grey(flight, 1).ravel())[0, 1] > 0.3
    )  # the scene has Earth and clouds behind the parts
    box = flight.page.locator(".monitor .picture").first.bounding_box()
    assert box is not None
    x, y = box["x"] + 0.5 * box["width"], box["y"] + 0.6 * box["height"]
    flight.page.mouse.move(x, y)
    flight.page.mouse.down()
    flight.page.mouse.move(x + 0.3 * box["width"], y, steps=5)
    flight.page.mouse.up()
    end = time.monotonic() + WAIT_S
    while np.abs(grey(flight, 0) - first).mean() < 5.0:
        assert time.monotonic() < end, "the polygons do not follow the view"


TILES = "[...document.querySelectorAll('.tile-picture > canvas.polygons')]"
_DRAWN = """(tile) => {
    const { width, height } = tile;
    const data = tile.getContext('2d').getImageData(0, 0, width, height).data;
    return width > 60 && data.some((value, i) => i % 4 === 0 && value > 30);
}"""


def test_the_view_of_all_cameras_has_the_look_in_every_tile(flight: Flight) -> None:
    flight.press("c")
    flight.until(f"{TILES}.length > 10 && {TILES}.every((tile) => tile.hidden)")
    look = flight.page.locator(".views").get_by_role("button", name="1972", exact=True)
    look.click()
    flight.until(f"{TILES}.every((tile) => !tile.hidden)")
    flight.until(f"{TILES}.filter({_DRAWN}).length > 10", WAIT_S * 1000)
    look.click()
    flight.until(f"{TILES}.every((tile) => tile.hidden)")


SHEET_TITLE = "(document.querySelector('.sheet svg text')?.textContent ?? '')"


def test_the_planes_of_a_monitor_have_a_window_that_follows_its_camera(flight: Flight) -> None:
    show(flight, 0, "A")
    planes = flight.page.locator(".monitor").first.get_by_role("button", name="Planes")
    assert planes.is_hidden()
    switch(flight, 0)
    window = open_window(flight, planes)
    window.until(f"{SHEET_TITLE}.includes('camera A at')")
    first = window.script(SHEET_TITLE)
    window.until(f"{SHEET_TITLE} !== '{first}' && {SHEET_TITLE}.includes('camera A at')")  # a later time
    show(flight, 0, "C")
    window.until(f"{SHEET_TITLE}.includes('camera C at')")
    window.page.locator(".cameras button").filter(has_text=re.compile("^F$")).click()
    window.until(f"{SHEET_TITLE}.includes('camera F at')")
    on = flight.page.locator(".monitor").first.locator(".cameras button[aria-pressed=true]")
    assert on.inner_text() == "F"
    hold = window.page.get_by_role("button", name="Hold")
    hold.click()
    held = window.script(SHEET_TITLE)
    window.until(f"frame.time_s > {window.frame().time_s + 2.5}")
    assert window.script(SHEET_TITLE) == held
    with window.page.expect_download() as download:
        window.page.get_by_role("button", name="Save").click()
    assert held in download.value.path().read_text()
    hold.click()
    window.until(f"{SHEET_TITLE} !== '{held}'")
