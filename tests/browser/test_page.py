"""The page: layout, units, key map, Tab order, pictures, and handing over control."""

from __future__ import annotations

import time

import pytest

from tests.browser.conftest import SIZES, OpenPage
from tests.browser.flight import FLIES, OBSERVES, Flight
from tests.browser.layout_checks import assert_readable, assert_tidy

pytestmark = pytest.mark.browser


def test_nothing_scrolls_overlaps_or_is_cut_off_in_either_unit(flight: Flight) -> None:
    for width, height in SIZES:
        flight.resize(width, height)
        assert_tidy(flight)
    unit = "document.querySelector('.resolution tbody th i').textContent"
    before = flight.script(unit)
    flight.page.get_by_title("Change the units of the read-outs").click()
    flight.until(f"{unit} !== '{before}'")
    assert_tidy(flight)


@pytest.mark.slow
def test_every_mode_is_tidy_and_readable(flight: Flight) -> None:
    for mode in ("ORB UNL", "SINGLE", "OPR CMD", "TEST"):
        flight.enter(mode)
        flight.polled()
        assert_tidy(flight)
        assert_readable(flight)


def test_question_mark_opens_the_key_map_and_escape_closes_it(flight: Flight) -> None:
    key_map = flight.page.get_by_role("dialog", name="Key map")
    flight.press("?")
    key_map.wait_for(state="visible")
    flight.hold("w")
    flight.until("document.querySelector('kbd.held')?.textContent.startsWith('W')")
    flight.release("w")
    flight.press("Escape")
    key_map.wait_for(state="hidden")


def test_tab_order_is_monitors_then_spine_then_desk(flight: Flight) -> None:
    flight.script("""window.visited = new Set(); document.addEventListener('focusin', ({ target }) => {
        const place = target.closest('.monitor, .spine, .group, .rail')?.classList[1]
            ?? target.closest('.monitor, .spine, .standing, .rail')?.classList[0];
        if (place) window.visited.add(place); // a set keeps the order of its first additions
    })""")
    flight.press(*["Tab"] * 90)
    order = ["spine", "thc", "mode", "clearance", "standing", "effector"]
    assert [place for place in flight.script("[...window.visited]") if place in order] == order


def test_page_measures_the_stick_to_picture_time(flight: Flight) -> None:
    before = flight.script("performance.now()")
    flight.hold("w")
    flight.until("frame.translation[0] === 1")
    flight.release("w")
    measured = "window.__aftdeck.latency95"
    # the measured time is shorter than the time since the key was pressed
    flight.until(f"{measured} > 0 && {measured} < performance.now() - {before}")
    assert len(flight.script("window.__aftdeck.renderer")) > 0
    flight.until("window.__aftdeck.fps > 0")


_MASKED = """
    const { getParameter } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.getParameter = function (name) {
        return name === 0x9246 ? 'A card of its own' : getParameter.call(this, name);
    };
"""
"""Replaces the name of the renderer (UNMASKED_RENDERER_WEBGL), so that the page assumes a graphics card."""

_SMALL_PICTURE = """() => {
    const scene = document.querySelector('canvas.scene');
    const small = new OffscreenCanvas(48, 16).getContext('2d');
    small.drawImage(scene, 0, 0, 48, 16);
    return [...small.getImageData(0, 0, 48, 16).data];
}"""
"""All pictures, reduced to 48 x 16 pixels."""


def _still_picture(page: Flight) -> list[int]:
    """Return the picture when it changes no more: exposures have settled, and pictures at rest are finer."""
    before, now = [], page.script(_SMALL_PICTURE)
    for _ in range(30):
        before = now
        time.sleep(1.0)
        if (now := page.script(_SMALL_PICTURE)) == before:
            break
    return list(now)


def test_pictures_are_equal_on_a_graphics_card_and_when_read_back(open_page: OpenPage) -> None:
    pictures = []
    for mask in (False, True):
        page = open_page(prepare=(lambda page: page.add_init_script(_MASKED)) if mask else None)
        page.until("window.__aftdeck.frames > 12")
        by_card = "document.querySelector('canvas.scene').getContext('webgl2') !== null"
        assert page.script(by_card) is mask
        pictures.append(_still_picture(page))
        page.page.close()
    read, shown = pictures
    reds = read[::4]
    assert max(reds) - min(reds) > 100  # the picture is not empty
    apart = [abs(a - b) for a, b in zip(read, shown, strict=True)]
    assert sum(apart) / len(apart) < 2.0


@pytest.mark.slow
def test_observer_asks_for_the_sticks_and_flies_after_they_are_given(flight: Flight, open_page: OpenPage) -> None:
    observer = open_page()
    observer.until(OBSERVES)
    observer.page.get_by_role("button", name="Ask for the sticks").click()
    with observer.logs("page"):
        flight.page.get_by_role("button", name="Keep").click()
    observer.page.get_by_role("button", name="Ask for the sticks").click()
    with observer.logs("hand-over"):
        flight.page.get_by_role("button", name="Give").click()
    observer.until(FLIES)
    flight.until(OBSERVES)
    observer.hold("w")
    observer.until("frame.translation[0] === 1")
    observer.release("w")
