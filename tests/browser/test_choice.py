"""Change of scenario in the page: from the list, and by the Tutorial key."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from aftdeck.scenario.load import built_in
from tests.browser.conftest import SIZES, OpenPage, running_station
from tests.browser.flight import FLIES, TITLE, Flight
from tests.browser.layout_checks import assert_readable

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.long]

LEAVING = "document.querySelector('.leaving').checkVisibility()"
GUIDED = "document.querySelector('.task')?.checkVisibility() === true"
FITS = """() => {
    const { left, right, top, bottom } = document.querySelector('.choices.scenarios').getBoundingClientRect();
    return left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight;
}"""

PICTURED = """[...document.querySelectorAll('.scenarios section .choice img')]
    .filter((picture) => picture.complete && picture.naturalWidth > 0).length"""
"""JavaScript: number of scenarios in the groups of the list whose picture is loaded."""
OFFERED = "document.querySelector('.task-line button').checkVisibility()"
"""JavaScript condition: the line of the task has a button."""


@pytest.fixture(scope="module")
def station() -> Iterator[str]:
    """Address of a station of this module alone, because the tests load other scenarios."""
    with running_station("first-flight") as address:
        yield address


def choose(flight: Flight, title: str) -> None:
    """Open the list and press a scenario's row."""
    flight.page.locator(".rail .scenario > button").click()
    flight.page.locator(".scenarios button").filter(has=flight.page.get_by_text(title, exact=True)).click()


def test_scenario_chosen_from_the_list_opens_on_every_page(flight: Flight, open_page: OpenPage) -> None:
    observer = open_page()
    for page in (flight, observer):  # a new scenario shows the desk, even if the page showed something else before
        page.press("c")
        page.until("document.querySelector('.matrix').checkVisibility()")
    choose(flight, "Three singularities")
    for page in (flight, observer):
        page.until(f"frame && {TITLE} === 'Three singularities' && frame.time_s < 30")
    for page in (flight, observer):
        page.until("document.querySelector('.desk').checkVisibility()")
    flight.until(FLIES)
    observer.until("document.querySelector('.who').textContent === 'Observing · page 1 flies'")
    flight.hold("s")
    flight.until("frame.translation[0] < -0.9")
    flight.release("s")
    choose(flight, "First flight")
    flight.until(LEAVING)  # the arm has moved, so the page asks
    assert "Leave “Three singularities” for “First flight”?" in flight.page.locator(".leaving").inner_text()
    flight.press_key("Stay")
    flight.until(f"!{LEAVING} && {TITLE} === 'Three singularities'")
    choose(flight, "First flight")
    flight.press_key("Leave and fly it")
    flight.until(f"frame && {TITLE} === 'First flight' && frame.mode === 'ORB UNL'")


def test_script_flies_a_scenario_until_a_stick_moves(flight: Flight) -> None:
    flight.page.locator(".rail .scenario > button").click()
    flight.press_key("Fly it for me: Deploy a payload")
    flight.until(f"frame && {TITLE} === 'Deploy a payload' && frame.by === 'script'")
    flight.until("frame.rates.some((rate) => Math.abs(rate) > 1e-4)")
    flight.hold("s")
    flight.until("frame.by === 'hand' && frame.translation[0] < -0.9")
    flight.release("s")


def test_scenario_without_steps_offers_to_let_its_script_fly(flight: Flight) -> None:
    choose(flight, "Flight test: without payload")
    flight.until(f"frame && {TITLE} === 'Flight test: without payload' && frame.by === 'hand' && {OFFERED}")
    flight.page.locator(".task-line button").click()
    flight.until(f"frame && frame.by === 'script' && !{OFFERED}")
    flight.until("frame.rates.some((rate) => Math.abs(rate) > 1e-4)")
    flight.hold("s")
    flight.until(f"frame.by === 'hand' && {OFFERED}")
    flight.release("s")


def test_tutorial_key_opens_the_tutorial_scenario_and_its_guide(flight: Flight) -> None:
    flight.press_key("Tutorial")
    flight.until(f"frame && {TITLE} === 'Tutorial' && {GUIDED}")
    flight.press_key("Guide")
    flight.until(f"!{GUIDED}")
    choose(flight, "Tutorial")
    flight.until(GUIDED)  # the guide also opens if the scenario is chosen from the list
    choose(flight, "First flight")
    flight.until(f"frame && {TITLE} === 'First flight' && frame.mode === 'ORB UNL'")
    flight.press_key("Tutorial")
    flight.until(f"frame && {TITLE} === 'Tutorial' && {GUIDED}")  # the guide opens each time
    choose(flight, "First flight")
    flight.until(f"frame && {TITLE} === 'First flight' && frame.mode === 'ORB UNL'")
    choose(flight, "Tutorial")
    flight.until(f"frame && {TITLE} === 'Tutorial' && {GUIDED}")
    choose(flight, "First flight")
    flight.until(f"frame && {TITLE} === 'First flight'")


def test_scenario_list_fits_and_is_readable(flight: Flight) -> None:
    flight.page.locator(".rail .scenario > button").click()
    for width, height in SIZES:
        flight.page.set_viewport_size({"width": width, "height": height})
        flight.until(f"innerWidth === {width} && innerHeight === {height}")
        assert flight.script(FITS)
        assert flight.script(PICTURED) == len(built_in())
        assert_readable(flight, ".scenarios", least=20)
