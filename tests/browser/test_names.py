"""Names of users in place of page numbers: in the rail, at the sticks, and when control is handed over."""

from __future__ import annotations

import pytest
from playwright.sync_api import expect

from tests.browser.conftest import OpenPage
from tests.browser.flight import NAMING, TYPING, WHO, Flight

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.long]

STICK_NAMES = "['thc', 'rhc'].map((hand) => document.querySelector(`.${hand} h2 .about`).textContent).join()"


def test_name_replaces_the_number_of_the_page(flight: Flight, open_page: OpenPage) -> None:
    observer = open_page()
    observer.until(f"{WHO} === 'Observing · page 1 flies'")
    flight.give_name("Wanda Berg")
    observer.until(f"{WHO} === 'Observing · Wanda Berg flies'")
    observer.until(f"{STICK_NAMES} === 'Wanda Berg,Wanda Berg'")
    assert observer.page.locator(".standing .device").inner_text() == "Wanda Berg flies"
    flight.until(f"!({NAMING}) && !{TYPING}")
    assert flight.frame().translation == (0, 0, 0), "typed letters do not fly"
    flight.hold("w")
    flight.until("frame.translation[0] === 1")
    flight.release("w")
    observer.give_name("Ben")
    flight.until(f"{WHO} === 'You fly · Ben observes'")
    observer.page.get_by_role("button", name="Ask for the sticks").click()
    flight.page.get_by_text("Ben asks for the sticks.").wait_for()
    with flight.logs("hand-over"), observer.logs("hand-over"), observer.shows(f"{WHO} === 'Wanda Berg ▸ Ben'"):
        flight.page.get_by_role("button", name="Give").click()
    flight.until(f"{WHO} === 'Observing · Ben flies'")
    for page in (flight, observer):
        line = page.newest("hand-over")
        assert "Wanda Berg" in line and "Ben" in line


def test_browser_stores_the_name_until_it_is_deleted(flight: Flight, open_page: OpenPage) -> None:
    other = open_page()
    flight.give_name("Anna")
    other.until(f"{WHO} === 'Observing · Anna flies'")
    flight.page.reload()
    other.until(f"{WHO} === 'You fly · Anna observes'")
    flight.until(f"{WHO} === 'Observing · page 2 flies'")
    flight.page.locator(".rail .who").click()
    flight.press("Delete", "Enter")  # the field contains the name, selected
    other.until(f"{WHO} === 'You fly · 1 observes'")
    flight.page.reload()
    flight.until(f"{WHO} === 'Observing · page 2 flies'")
    other.until(f"{WHO} === 'You fly · 1 observes'")


def test_invalid_name_is_rejected_and_escape_closes_the_field(flight: Flight) -> None:
    flight.give_name(" Anna")
    wrong = flight.page.locator(".naming .wrong")
    expect(wrong).to_contain_text("' Anna'")
    assert flight.script(NAMING) and flight.script(TYPING)
    flight.press("Escape")
    flight.until(f"!({NAMING}) && !{TYPING} && {WHO} === 'You fly'")
    flight.page.locator(".rail .who").click()
    assert wrong.inner_text() == "" and flight.page.get_by_label("Your name").get_by_role("textbox").input_value() == ""


def test_space_stops_while_a_name_is_typed(flight: Flight) -> None:
    flight.hold("w")
    flight.until("frame.translation[0] === 1")
    flight.press("h")
    flight.until("frame.rate_hold")
    flight.release("w")
    flight.give_name("A B")
    flight.until("!frame.rate_hold")
    flight.until(f"!({NAMING})")
    flight.page.locator(".rail .who").click()
    assert flight.page.get_by_label("Your name").get_by_role("textbox").input_value() == "A B"
