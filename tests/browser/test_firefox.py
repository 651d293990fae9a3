"""The station in Firefox: it loads without errors, draws, flies, turns a camera and opens its sheets."""

from __future__ import annotations

import os
from collections.abc import Iterator

import pytest

from tests.browser.conftest import SIZES
from tests.browser.firefox import ESCAPE, Firefox, find_programs, started
from tests.browser.flight import FLIES
from tests.browser.layout_checks import assert_readable, assert_tidy

pytestmark = [pytest.mark.browser, pytest.mark.slow]

SCENARIO = "tutorial"
TUTORIAL = "document.querySelector('.task').checkVisibility()"
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
"""Number of colours in each monitor's picture."""


@pytest.fixture(scope="module")
def firefox(station: str, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Firefox]:
    """A Firefox in control of the station. An error or a warning in its console fails the tests."""
    programs = find_programs()
    if programs is None:
        missing = "no Firefox, or no Xvfb to draw on, was found: install firefox-esr and xvfb"
        if os.environ.get("AFTDECK_REQUIRE_BROWSER") == "1":
            pytest.fail(missing)
        pytest.skip(missing)
    with started(programs, tmp_path_factory.mktemp("profile")) as browser:
        browser.go(f"{station}?quality=low")
        browser.resize(1280, 720)
        browser.until(f"frame?.time_s > 1 && {FLIES}")
        browser.script("document.dispatchEvent(new PointerEvent('pointerdown'))")  # ends the opening shot
        browser.until(TUTORIAL)  # the tutorial opens by itself on the first visit
        press_rail(browser, "Guide")
        browser.until(f"!{TUTORIAL}")
        press_rail(browser, "Full panel")
        yield browser
        assert browser.errors == []


def test_both_pictures_are_drawn(firefox: Firefox) -> None:
    until_redrawn(firefox)  # the full panel has another size, which clears the canvas
    assert min(firefox.script(COLOURS)) > 50


def test_key_moves_the_arm_and_space_stops_it(firefox: Firefox) -> None:
    start = firefox.script("window.__aftdeck.lastFrame.display.actual.position")
    firefox.hold("w")
    firefox.until(f"frame.display.actual.position.some((at, axis) => Math.abs(at - {start}[axis]) > 0.01)")
    firefox.press(" ")
    firefox.until(STILL)
    firefox.release("w")


def test_drag_turns_the_camera_until_it_is_released(firefox: Firefox) -> None:
    firefox.press("2")  # a camera with a drive
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
def test_sheet_opens_is_readable_and_closes(firefox: Firefox, name: str, key: str) -> None:
    sheet = f"document.querySelector('dialog[aria-label=\"{name}\"]').open"
    if key:
        firefox.press(key)
    else:
        press_rail(firefox, name)
    firefox.until(sheet)
    until_redrawn(firefox)
    assert_readable(firefox, "dialog[open]", least=30)
    firefox.press(ESCAPE)
    firefox.until(f"!{sheet}")


def test_tutorial_opens_and_closes(firefox: Firefox) -> None:
    press_rail(firefox, "Guide")
    firefox.until(TUTORIAL)
    assert_readable(firefox, ".task", least=5)
    press_rail(firefox, "Guide")
    firefox.until(f"!{TUTORIAL}")


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_page_is_tidy_and_readable(firefox: Firefox, width: int, height: int) -> None:
    firefox.resize(width, height)
    until_redrawn(firefox)
    assert_tidy(firefox)
    assert_readable(firefox)


def press_rail(firefox: Firefox, name: str) -> None:
    """Press a button of the top rail."""
    keys = "[...document.querySelectorAll('.rail-keys button')]"
    firefox.script(f"{keys}.find((key) => key.textContent === '{name}').click() ?? null")


def until_redrawn(firefox: Firefox) -> None:
    """Wait until pictures and read-outs have been drawn again."""
    drawn = firefox.script("window.__aftdeck.frames")
    firefox.until(f"window.__aftdeck.frames > {drawn + 5}")
