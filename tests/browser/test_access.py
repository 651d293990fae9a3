"""The page without a pointer, with forced colours, and by the rules of axe."""

from __future__ import annotations

import pytest

from tests.browser.accessibility import violations
from tests.browser.conftest import OpenPage
from tests.browser.flight import OBSERVES

pytestmark = [pytest.mark.browser, pytest.mark.slow]

SCENARIO = "tutorial"

FOCUSED = "document.activeElement.textContent"
BACKGROUNDS = """['B', 'C'].map((name) => getComputedStyle(
    [...document.querySelectorAll('.cameras button')].find((key) => key.textContent === name)).backgroundColor)"""
"""Backgrounds of the pressed key of camera B and of the key of camera C, which is not pressed."""


def test_axe_finds_nothing(open_page: OpenPage) -> None:
    flight = open_page(1440, 900).from_the_start()
    page = flight.page
    assert violations(page) == [], "with the guide"
    page.get_by_role("button", name="Close the guide").click()
    flight.press("?")
    assert violations(page) == [], "with the key map"
    flight.press("Escape")
    page.locator(".events .more").click()
    page.get_by_role("button", name="Tutorial").first.click()
    page.get_by_role("group", name="Scenarios").wait_for(state="visible")
    assert violations(page) == [], "with the log and the list of scenarios"
    flight.press("Escape")
    page.set_viewport_size({"width": 1024, "height": 768})
    assert violations(page) == [], "at 1024 x 768"


def test_page_is_used_by_keys_and_with_forced_colours(open_page: OpenPage) -> None:
    flight = open_page(1440, 900).from_the_start()
    page = flight.page
    page.evaluate("document.querySelector('a[href], button, input').focus()")
    assert flight.script(FOCUSED) == "Skip to the desk"
    flight.press("Enter")
    assert flight.script("document.activeElement.id") == "desk"
    flight.press("2")  # camera B
    page.evaluate("document.querySelector('.cameras button[aria-pressed=true]').focus()")
    flight.press("ArrowRight")
    assert flight.script(FOCUSED) == "C"
    flight.press("Tab")
    assert flight.script(FOCUSED) == "Slow", "a row is one stop of Tab"
    page.emulate_media(forced_colors="active")
    pressed, other = flight.script(BACKGROUNDS)
    assert pressed != other

    observer = open_page()
    observer.until(OBSERVES)
    observer.press("w")
    observer.page.get_by_text("Observing: Page 1 flies. Press “Ask for the sticks”").first.wait_for()
    assert violations(observer.page) == [], "of an observer"
