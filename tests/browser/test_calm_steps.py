"""On the calm page, each step of the built-in scenarios has the parts of the desk that its text names."""

from __future__ import annotations

import re

import pytest

from aftdeck.scenario.load import built_in, load_scenario
from tests.browser.conftest import OpenPage
from tests.browser.flight import FLIES
from tests.browser.layout_checks import assert_tidy

pytestmark = [pytest.mark.browser, pytest.mark.slow]

SCENARIO = "flight-test"
CALM = True
FEWEST = 10
"""Fewest names that the texts of all steps quote from the desk."""

NAMED = """(name) => {
    const named = [...document.querySelectorAll('body *')].filter((node) => !node.closest('.words')
        && node.childElementCount === 0 && node.textContent.trim().toLowerCase() === name.toLowerCase());
    return [named.length, named.some((node) => node.checkVisibility({ visibilityProperty: true }))];
}"""
"""Number of the elements with this text, and whether one of them is visible."""
FITS = """(() => {
    const [words, mode, ways, numbers, caps] = ['.words', '.elsewhere', '.ways', '.to-go', '.caps'].map((part) =>
        document.querySelector(`.task ${part}`).getBoundingClientRect());
    const fits = (part) => part.height === 0 || (part.top >= numbers.bottom - 1 && part.bottom <= ways.top + 1);
    return words.height > 0 && Math.max(words.bottom, mode.bottom) <= ways.top + 1 && fits(caps);
})()"""
"""JavaScript condition: the text of the step and the keys are within their parts of the card."""
STEP = "document.querySelector('.task .steps span').textContent"


def test_parts_that_a_text_names_are_visible(open_page: OpenPage) -> None:
    flight = open_page(1440, 900)
    flight.until(f"{FLIES} && window.__aftdeck.frames > 2")
    found = 0
    for scenario in (load_scenario(name) for name in built_in()):
        if not scenario.steps:
            continue
        flight.choose(scenario.title)
        flight.until("document.querySelector('.task').checkVisibility() || document.querySelector('.task-line button')")
        if flight.page.get_by_role("button", name="Open the guide").is_visible():
            flight.press_key("Open the guide")
        while present := re.fullmatch(r"(\d+) of \d+", flight.script(STEP)):
            step = scenario.steps[int(present[1]) - 1]
            for name in re.findall(r"\*([^*]+)\*", step.text):
                count, visible = flight.page.evaluate(NAMED, name)
                assert visible or count == 0, f"{scenario.name}, {step.title}: {name} is hidden"
                found += visible
            assert flight.script(FITS), f"{scenario.name}, {step.title}: the card has no room for its text"
            flight.press_key("Skip step")
            flight.until(f"{STEP} !== '{present[0]}'")
        assert_tidy(flight)
        flight.resize(1024, 768)
        assert_tidy(flight)
        flight.resize(1440, 900)
    assert found >= FEWEST
