"""The station in Firefox: it loads without a complaint, draws, flies, turns a camera, and its sheets open."""

from __future__ import annotations

import os
from collections.abc import Iterator

import pytest

from tests.browser.conftest import SIZES
from tests.browser.firefox import ESCAPE, Firefox, find_programs, started
from tests.browser.looks import assert_readable, assert_tidy

pytestmark = [pytest.mark.browser, pytest.mark.slow]

SCENARIO = "tutorial"
TUTORIAL = "document.querySelector('.tutorial').checkVisibility()"
STILL = "frame.translation.every((value) => value === 0)"

COLOURS = """() => {
    const [scene, small] = [document.querySelector('canvas.scene'), document.createElement('canvas')];
    const [first, second] = [...document.querySelectorAll('.picture')].map((each) => each.getBoundingClientRect());
    const over = scene.getBoundingClientRect(), scale = scene.width / over.width;
    small.width = small.height = 64;
    const context = small.getContext('2d');
    return [first, second].map(({ left, top, width, height }) => {
        const place = [left - over.left, top - over.top, width, height].map((length) => length * scale);
        context.drawImage(scene, ...place, 0, 0, 64, 64);
        const pixels = new Uint32Array(context.getImageData(0, 0, 64, 64).data.buffer);
        return new Set(pixels).size;
    });
}"""
"""How many colours each monitor's picture has."""


@pytest.fixture(scope="module")
def firefox(station: str, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Firefox]:
    """A Firefox at the station, which it flies; at the end nothing is on its console."""
    programs = find_programs()
    if programs is None:
        missing = "no Firefox, or no Xvfb to draw on, was found: install firefox-esr and xvfb"
        if os.environ.get("AFTDECK_REQUIRE_BROWSER") == "1":
            pytest.fail(missing)
        pytest.skip(missing)
    with started(programs, tmp_path_factory.mktemp("profile")) as browser:
        browser.go(f"{station}?quality=low")
        browser.resize(1280, 720)
        browser.until("frame?.time_s > 1 && document.querySelector('.who').textContent.startsWith('You fly')")
        browser.until(TUTORIAL)  # it opens by itself for who has not seen it
        press_rail(browser, "Guide")
        browser.until(f"!{TUTORIAL}")
        yield browser
        assert browser.errors == []


def test_both_pictures_are_drawn(firefox: Firefox) -> None:
    firefox.until("window.__aftdeck.frames > 10")
    assert min(firefox.script(COLOURS)) > 50


def test_a_key_moves_the_arm_and_space_stops_it(firefox: Firefox) -> None:
    start = firefox.script("window.__aftdeck.lastFrame.display.actual.position")
    firefox.hold("w")
    firefox.until(f"frame.display.actual.position.some((at, axis) => Math.abs(at - {start}[axis]) > 0.01)")
    firefox.press(" ")
    firefox.until(STILL)
    firefox.release("w")


def test_a_drag_turns_the_camera_and_letting_go_stops_it(firefox: Firefox) -> None:
    driven = "frame.views.map(([pan]) => pan)"
    before = firefox.script(f"(() => {{ const frame = window.__aftdeck.lastFrame; return {driven}; }})()")
    firefox.point(
        {"type": "pointerMove", "x": 200, "y": 200},
        {"type": "pointerDown", "button": 0},
        {"type": "pointerMove", "x": 260, "y": 200, "duration": 100},
    )
    firefox.until(f"{driven}.some((pan, i) => pan > {before}[i] + 0.01)")
    firefox.point({"type": "pointerUp", "button": 0})
    firefox.until(f"(window.was?.join() === {driven}.join()) || ((window.was = {driven}) && false)")


@pytest.mark.parametrize(("name", "key"), [("Key map", "?"), ("PDRS control", "\\"), ("Controllers", "")])
def test_a_sheet_opens_can_be_read_and_closes(firefox: Firefox, name: str, key: str) -> None:
    sheet = f"document.querySelector('dialog[aria-label=\"{name}\"]').open"
    if key:
        firefox.press(key)
    else:
        press_rail(firefox, name)
    firefox.until(sheet)
    drawn_anew(firefox)
    assert_readable(firefox, "dialog[open]", least=30)
    firefox.press(ESCAPE)
    firefox.until(f"!{sheet}")


def test_the_tutorial_opens_and_closes(firefox: Firefox) -> None:
    press_rail(firefox, "Guide")
    firefox.until(TUTORIAL)
    assert_readable(firefox, ".tutorial", least=5)
    press_rail(firefox, "Guide")
    firefox.until(f"!{TUTORIAL}")


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_the_page_is_tidy_and_readable(firefox: Firefox, width: int, height: int) -> None:
    firefox.resize(width, height)
    drawn_anew(firefox)
    assert_tidy(firefox)
    assert_readable(firefox)


def press_rail(firefox: Firefox, name: str) -> None:
    """Presses a key of the top rail."""
    keys = "[...document.querySelectorAll('.rail-keys button')]"
    firefox.script(f"{keys}.find((key) => key.textContent === '{name}').click() ?? null")


def drawn_anew(firefox: Firefox) -> None:
    """Waits until pictures and figures have been drawn some times more."""
    drawn = firefox.script("window.__aftdeck.frames")
    firefox.until(f"window.__aftdeck.frames > {drawn + 5}")
