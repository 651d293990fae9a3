"""The opening shot at a browser's first start: one picture and few words, until a key is pressed."""

from __future__ import annotations

import pytest

from tests.browser.conftest import OpenPage
from tests.browser.flight import Flight

pytestmark = [pytest.mark.browser, pytest.mark.slow]

CALM = True
FIRST = True
SHOT = "document.body.classList.contains('opening')"
"""JavaScript condition: the page shows the opening shot."""
SECOND = "(document.querySelectorAll('.monitors > .monitor').length === 2)"
KEYS = """[...document.querySelectorAll('.monitor .cameras')]
    .map((keys) => [...keys.children].filter((key) => key.checkVisibility()).length)"""
"""JavaScript: number of visible keys of cameras of each monitor."""
DESK = "document.querySelector('.desk').checkVisibility()"
SIZES = [(1440, 900), (1280, 720), (1024, 768), (1920, 1080), (844, 390), (390, 844), (720, 450)]
"""Window sizes [px]."""
FITS = """() => {
    const box = (name) => document.querySelector(name).getBoundingClientRect();
    const [picture, words, rail] = [box('.monitor .picture'), box('.opening-words'), box('.rail')];
    const parts = [...document.querySelectorAll('.opening-words :is(h2, p, button)')];
    const inside = ({ left, right, top, bottom }) =>
        left >= 0 && right <= innerWidth && top >= rail.bottom && bottom <= innerHeight;
    return inside(words) && parts.every((part) => inside(part.getBoundingClientRect()))
        && picture.width > 0.9 * innerWidth && picture.height > 0.85 * (innerHeight - rail.height)
        && document.documentElement.scrollHeight <= innerHeight;
}"""
"""Whether the picture fills the window below the rail, and the words are inside it."""


def test_opening_shot_fills_windows_of_all_sizes(open_page: OpenPage) -> None:
    flight = open_page()
    flight.until(SHOT)
    for width, height in SIZES:
        flight.page.set_viewport_size({"width": width, "height": height})
        flight.until(f"innerWidth === {width} && innerHeight === {height} && {SHOT} && ({FITS})()")


def test_key_that_flies_moves_the_arm_and_shows_the_whole_page_for_good(open_page: OpenPage) -> None:
    flight = open_page()
    flight.until(f"{SHOT} && !{SECOND} && !{DESK} && document.querySelector('.rail .who').matches('.flying')")
    flight.hold("q")
    flight.until(f"!{SHOT} && {SECOND} && {DESK} && frame.translation[2] < -0.9")
    flight.release("q")
    flight.until(f"{KEYS}[0] <= 3 && {KEYS}[1] <= 3")  # the second monitor is as calm as the first
    flight.page.reload()
    again = Flight(flight.page)
    assert not again.script(SHOT)
    assert again.script(SECOND)


def test_button_shows_the_desk(open_page: OpenPage) -> None:
    flight = open_page()
    flight.until(SHOT)
    flight.page.get_by_role("button", name="Show the desk").click()
    flight.until(f"!{SHOT} && {SECOND} && {DESK}")
