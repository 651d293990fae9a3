"""PDRS control from the page, and the thresholds of a scenario's own: what the file says is what is shown and acts."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Locator, expect

from tests.browser.conftest import OpenPage
from tests.browser.flight import WAIT_MS, Flight

pytestmark = [pytest.mark.browser, pytest.mark.slow]
expect.set_options(timeout=WAIT_MS)

SCENARIO = str(Path(__file__).parent / "own-thresholds.toml")


def opened(flight: Flight) -> Locator:
    """The page PDRS control, opened by its switch on the desk."""
    flight.page.get_by_role("button", name="SPEC 94").click()
    sheet = flight.page.get_by_role("dialog", name="PDRS control")
    sheet.wait_for(state="visible")
    return sheet


def test_a_pose_keyed_in_is_the_target_and_its_check_says_why_not(flight: Flight) -> None:
    sheet = opened(flight)
    x = sheet.get_by_label("End X", exact=True)
    expect(x).to_have_value("−942.0")
    x.fill("-930")
    x.press("Enter")
    flight.until(
        "frame.display.aim && Math.abs(frame.display.aim.position[0] / 0.0254 + 930) < 1e-6 && frame.check?.good"
    )
    expect(sheet.locator(".check.good")).to_contain_text("GOOD")
    x.fill("5000")
    x.press("Enter")
    expect(sheet.locator(".check.caution")).to_contain_text("FAIL")
    flight.press("Escape")
    sheet.wait_for(state="hidden")


def test_until_one_is_keyed_in_page_and_desk_show_the_present_point(flight: Flight) -> None:
    flight.turn_to("OPR CMD")
    start = flight.frame().display.actual.position[0]
    flight.hold("w")
    flight.until(f"Math.abs(frame.display.actual.position[0] - {start}) > 0.05")
    flight.release("w")
    flight.until("Math.hypot(...frame.display.actual.velocity) < 1e-4")
    sheet = opened(flight)
    expect(sheet.locator(".to-go")).to_have_text("No target keyed in: this is the present point.")
    present = flight.script("document.querySelector('.resolution td.actual').textContent")
    for name in ("End X", "Target X"):
        expect(flight.page.get_by_label(name, exact=True)).to_have_value(present)


def test_position_hold_and_the_reference_of_orb_ld_are_switched_there(flight: Flight) -> None:
    sheet = opened(flight)
    sheet.get_by_role("group", name="Position hold").get_by_role("button", name="Ena").click()
    flight.until("frame.position_hold")
    sheet.get_by_role("group", name="Position hold").get_by_role("button", name="Inh").click()
    flight.until("!frame.position_hold")
    reference = sheet.get_by_role("group", name="Command reference of ORB LD")
    reference.get_by_role("button", name="Payload").click()
    flight.until("frame.payload_axes")
    reference.get_by_role("button", name="Norm").click()
    flight.until("!frame.payload_axes")


def test_the_stored_points_are_those_of_the_file_and_the_next_one_is_marked(flight: Flight) -> None:
    sheet = opened(flight)
    rows = sheet.locator(".stored-points tbody tr:not([hidden])")
    expect(rows).to_have_count(2)
    expect(rows.nth(0)).to_have_text("1−942.0−60.0−597.5285.00.00.0fly by")
    expect(rows.nth(1)).to_have_text("2−942.0+0.0−557.5270.00.00.0pause")
    expect(rows.nth(0)).to_have_attribute("aria-current", "true")
    expect(sheet.locator(".stored-points p")).to_contain_text("START PT 1   LAST PT 2")
    sheet.get_by_role("button", name="AUTO 1").click()
    expect(sheet.locator(".stored-points p")).to_contain_text("No points")


def test_the_arm_is_flown_while_the_page_is_open(flight: Flight) -> None:
    opened(flight)
    start = flight.frame().display.actual.position[0]
    flight.hold("w")
    flight.until(f"Math.abs(frame.display.actual.position[0] - {start}) > 0.02")
    flight.release("w")


def test_who_watches_reads_it_and_is_told_that_he_cannot_switch(flight: Flight, open_page: OpenPage) -> None:
    watcher = open_page()
    watcher.until("document.querySelector('.who').textContent.startsWith('You watch')")
    sheet = opened(watcher)
    expect(sheet.locator(".payload-table tr.held")).to_contain_text("no payload")
    sheet.get_by_role("button", name="Key in").click()
    watcher.until_logged("Observing: only the operator can do that.")
    assert flight.frame().display.aim is None


def test_lamp_gauge_and_figure_follow_the_scenarios_thresholds(flight: Flight) -> None:
    flight.until_lit("CLEARANCE")
    flight.until("document.querySelector('.clearance').matches('.caution')")
    marks = "[...document.querySelectorAll('.gap-scale .marks span')].map((mark) => mark.textContent)"
    assert flight.script(marks) == ["2.0 in", "9.8", "79", "118"]
