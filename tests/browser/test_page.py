"""The page itself: nothing scrolls, overlaps or fades, and everything is within reach of the keys."""

from __future__ import annotations

import pytest

from tests.browser.conftest import SIZES, OpenPage
from tests.browser.flight import Flight
from tests.browser.looks import assert_readable, assert_tidy

pytestmark = pytest.mark.browser


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_nothing_scrolls_overlaps_or_is_cut_off(open_page: OpenPage, width: int, height: int) -> None:
    flight = open_page(width, height).from_the_start()
    assert_tidy(flight)


@pytest.mark.parametrize("mode", ["ORB UNL", "SINGLE", "OPR CMD", "TEST"])
def test_every_mode_is_tidy_and_readable(flight: Flight, mode: str) -> None:
    flight.enter(mode)
    assert_tidy(flight)
    assert_readable(flight)


def test_the_question_mark_shows_the_key_map_and_escape_closes_it(flight: Flight) -> None:
    key_map = flight.page.get_by_role("dialog", name="Key map")
    flight.press("?")
    key_map.wait_for(state="visible")
    flight.hold("w")
    flight.until("document.querySelector('kbd.held')?.textContent.startsWith('W')")
    flight.release("w")
    flight.press("Escape")
    key_map.wait_for(state="hidden")


def test_camera_keys_act_on_the_monitor_in_hand(flight: Flight) -> None:
    names = "[...document.querySelectorAll('.picture .name b')].map((name) => name.textContent)"
    first, second = flight.script(names)
    flight.press(".")
    flight.until(f"{names}[0] !== '{first}'")
    changed, kept = flight.script(names)
    assert kept == second
    flight.press("x", "1")
    flight.until(f"document.querySelector('.cameras').textContent.startsWith({names}[1])")
    assert flight.script(names)[0] == changed


def test_the_focus_goes_from_the_monitors_over_the_spine_to_the_desk(flight: Flight) -> None:
    visited: list[str] = []
    place = (
        "document.activeElement.closest('.monitor, .spine, .group, .rail')?.classList[1] ?? "
        "document.activeElement.closest('.monitor, .spine, .rail')?.classList[0] ?? ''"
    )
    for _ in range(80):
        flight.press("Tab")
        where = flight.script(place)
        if where and where not in visited:
            visited.append(where)
    order = ("spine", "thc", "mode", "clearance", "rhc", "effector")
    assert [where for where in visited if where in order] == list(order)


def test_a_second_page_watches(flight: Flight, open_page: OpenPage) -> None:
    watcher = open_page()
    watcher.until("document.querySelector('.who').textContent === 'You watch'")
    watcher.hold("w")
    tick = watcher.frame().tick
    watcher.until(f"frame.tick > {tick + 25}")
    assert watcher.frame().translation == (0, 0, 0)
    flight.until("document.querySelector('.who').textContent.includes('1 watches')")


def test_units_change_on_demand(flight: Flight) -> None:
    unit = "document.querySelector('.resolution tbody th i').textContent"
    before = flight.script(unit)
    flight.page.get_by_title("Units of the read-outs").click()
    flight.until(f"{unit} !== '{before}'")


def test_the_hook_measures_stick_to_picture(flight: Flight) -> None:
    before = flight.script("performance.now()")
    flight.hold("w")
    flight.until("frame.translation[0] === 1")
    flight.release("w")
    measured = "window.__aftdeck.latency95"
    flight.until(f"{measured} > 0 && {measured} < performance.now() - {before}")  # no longer than the key is known
    assert "llvmpipe" in flight.script("window.__aftdeck.renderer") or flight.script("window.__aftdeck.renderer")
    flight.until("window.__aftdeck.fps > 0")
