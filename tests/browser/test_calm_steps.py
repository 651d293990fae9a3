"""On the calm page, each step of the built-in scenarios has the parts that its text names, in a low desk."""

from __future__ import annotations

import re

import pytest

from aftdeck.scenario.load import built_in, load_scenario
from tests.browser.conftest import OpenPage
from tests.browser.flight import FLIES
from tests.browser.layout_checks import DESK_SHARE, assert_tidy

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
    const box = (part) => document.querySelector(part).getBoundingClientRect();
    const [card, room] = [box('.task'), document.querySelector('.task .instruction')];
    const parts = ['.words', '.elsewhere', '.ways', '.to-go', '.caps'].map((part) => box(`.task ${part}`))
        .filter(({ height }) => height > 0);
    const inside = parts.every((p) => p.top >= card.top - 1 && p.bottom <= card.bottom + 1);
    const apart = parts.every((p, i) => parts.slice(i + 1).every((q) => p.bottom <= q.top + 1 || q.bottom <= p.top + 1
        || p.right <= q.left + 1 || q.right <= p.left + 1));
    return box('.task .words').height > 0 && inside && apart && room.scrollHeight <= room.clientHeight + 1;
})()"""
"""JavaScript condition: the text of the step and the keys are whole, within the card, and apart from each other."""
DESK = "document.querySelector('.desk').getBoundingClientRect().height"
SIZES = ((1920, 1080), (1280, 720), (1440, 900))
STEP = "document.querySelector('.task .steps span').textContent"


def test_parts_that_a_text_names_are_visible(open_page: OpenPage) -> None:
    flight = open_page(*SIZES[-1])
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
            for width, height in SIZES:
                flight.resize(width, height)
                assert flight.script(FITS), f"{scenario.name}, {step.title}: the card has no room for its text"
                share = flight.script(DESK) / height
                assert share <= DESK_SHARE, f"{scenario.name}, {step.title}, {width} x {height}: desk {share:.1%}"
            flight.press_key("Skip step")
            flight.until(f"{STEP} !== '{present[0]}'")
        assert_tidy(flight)
        flight.resize(1024, 768)
        assert_tidy(flight)
        flight.resize(*SIZES[-1])
    assert found >= FEWEST
