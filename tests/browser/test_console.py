"""The console of the page: prints values, changes them in flight, completes words, and the page shows the changes."""

from __future__ import annotations

import pytest
from playwright.sync_api import Locator, expect

from tests.browser.conftest import OpenPage
from tests.browser.flight import WAIT_MS, Flight

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.long]
expect.set_options(timeout=WAIT_MS)

SCENARIO = "concept-1972"


def opened(flight: Flight) -> Locator:
    """Open the console by its key; return the sheet."""
    flight.press("Numpad0")
    sheet = flight.page.get_by_role("dialog", name="Console")
    sheet.wait_for(state="visible")
    return sheet


def enter(sheet: Locator, line: str) -> None:
    """Type a line and press Enter."""
    field = sheet.get_by_label("Line for the console")
    field.fill(line)
    field.press("Enter")


def test_value_is_printed_and_changed_and_the_page_shows_it(flight: Flight) -> None:
    sheet = opened(flight)
    enter(sheet, "print clearance.caution")
    expect(sheet.locator(".answer").last).to_contain_text("clearance.caution = 0.5")
    enter(sheet, "set clearance.caution = 2 m")
    expect(sheet.locator(".answer").last).to_have_text("clearance.caution = 2 m")
    expect(flight.page.locator(".gap-scale .marks span").nth(2)).to_have_text("79")  # inches
    expect(flight.page.get_by_text("clearance.caution = 2 m").last).to_be_visible()
    enter(sheet, "set clearance.caution = 3 kg")
    expect(sheet.locator(".refused").last).to_contain_text("is not a length")
    flight.press("Escape")
    sheet.wait_for(state="hidden")


def test_camera_is_turned_and_moved(flight: Flight) -> None:
    sheet = opened(flight)
    turned = flight.frame().views
    enter(sheet, "set cameras.A.pan = 10 deg; worksite.camera[0].position = [0.8, -1.2, 2.5]")
    flight.until(f"frame.views[0][0] !== {turned[0][0]}")
    assert flight.frame().views[0][0] == pytest.approx(0.17453293)
    enter(sheet, "changes")
    expect(sheet.locator(".answer").last).to_contain_text("worksite.camera[0].position")


def test_tab_completes_and_arrows_bring_back(flight: Flight) -> None:
    sheet = opened(flight)
    field = sheet.get_by_label("Line for the console")
    field.fill("print limits.por.tr")
    field.press("Tab")
    expect(field).to_have_value("print limits.por.translation")
    field.fill("print limits.por.vernier_")
    field.press("Tab")
    expect(sheet.locator(".words")).to_contain_text("limits.por.vernier_rotation")
    enter(sheet, "help")
    field.press("ArrowUp")
    expect(field).to_have_value("help")


def test_observer_may_print_only(flight: Flight, open_page: OpenPage) -> None:
    observer = open_page()
    sheet = opened(observer)
    enter(sheet, "print clearance.warning")
    expect(sheet.locator(".answer").last).to_contain_text("clearance.warning")
    enter(sheet, "set clearance.warning = 0.2 m")
    expect(sheet.locator(".refused").last).to_contain_text("only the page in control")
    assert flight.frame().work is not None
