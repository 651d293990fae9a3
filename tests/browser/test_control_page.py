"""The sheet PDRS control, and clearance thresholds that a scenario sets."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Locator, expect

from tests.browser.conftest import OpenPage
from tests.browser.flight import OBSERVES, WAIT_MS, Flight

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.long]
expect.set_options(timeout=WAIT_MS)

SCENARIO = str(Path(__file__).parent / "own-thresholds.toml")


def open_control_page(flight: Flight) -> Locator:
    """Open PDRS control by its switch on the desk; return the sheet."""
    flight.page.get_by_role("button", name="SPEC 94").click()
    sheet = flight.page.get_by_role("dialog", name="PDRS control")
    sheet.wait_for(state="visible")
    return sheet


def test_keyed_in_pose_is_the_target_and_is_checked(flight: Flight) -> None:
    sheet = open_control_page(flight)
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


def test_page_and_desk_show_the_present_point_without_a_target(flight: Flight) -> None:
    flight.turn_to("OPR CMD")
    start = flight.frame().display.actual.position[0]
    flight.hold("w")
    flight.until(f"Math.abs(frame.display.actual.position[0] - {start}) > 0.05")
    flight.release("w")
    flight.until("Math.hypot(...frame.display.actual.velocity) < 1e-4")
    sheet = open_control_page(flight)
    expect(sheet.locator(".remaining")).to_have_text("No target keyed in: this is the present point.")
    present = flight.script("document.querySelector('.resolution td.actual').textContent")
    for name in ("End X", "Target X"):
        expect(flight.page.get_by_label(name, exact=True)).to_have_value(present)


def test_control_page_switches_position_hold_and_orb_ld_axes(flight: Flight) -> None:
    sheet = open_control_page(flight)
    sheet.get_by_role("group", name="Position hold").get_by_role("button", name="Ena").click()
    flight.until("frame.position_hold")
    sheet.get_by_role("group", name="Position hold").get_by_role("button", name="Inh").click()
    flight.until("!frame.position_hold")
    reference = sheet.get_by_role("group", name="Command reference of ORB LD")
    reference.get_by_role("button", name="Payload").click()
    flight.until("frame.payload_axes")
    reference.get_by_role("button", name="Norm").click()
    flight.until("!frame.payload_axes")


def test_control_page_lists_stored_points_and_marks_the_next(flight: Flight) -> None:
    sheet = open_control_page(flight)
    rows = sheet.locator(".stored-points tbody tr:not([hidden])")
    expect(rows).to_have_count(2)
    expect(rows.nth(0)).to_have_text("1−942.0−60.0−597.5285.00.00.0fly by")
    expect(rows.nth(1)).to_have_text("2−942.0+0.0−557.5270.00.00.0pause")
    expect(rows.nth(0)).to_have_attribute("aria-current", "true")
    expect(sheet.locator(".stored-points p")).to_contain_text("START PT 1   LAST PT 2")
    sheet.get_by_role("button", name="AUTO 1").click()
    expect(sheet.locator(".stored-points p")).to_contain_text("No points")


def test_arm_can_be_flown_while_the_control_page_is_open(flight: Flight) -> None:
    open_control_page(flight)
    start = flight.frame().display.actual.position[0]
    flight.hold("w")
    flight.until(f"Math.abs(frame.display.actual.position[0] - {start}) > 0.02")
    flight.release("w")


def test_observer_reads_the_control_page_but_cannot_switch(flight: Flight, open_page: OpenPage) -> None:
    observer = open_page()
    observer.until(OBSERVES)
    sheet = open_control_page(observer)
    expect(sheet.locator(".payload-table tr.held")).to_contain_text("no payload")
    with observer.logs("page"):
        sheet.get_by_role("button", name="Key in").click()
    assert flight.frame().display.aim is None


def test_lamp_and_gauge_follow_the_thresholds_of_the_scenario(flight: Flight) -> None:
    flight.until_lit("CLEARANCE")
    flight.until("document.querySelector('.clearance').matches('.caution')")
    marks = "[...document.querySelectorAll('.gap-scale .marks span')].map((mark) => mark.textContent)"
    assert flight.script(marks) == ["2.0 in", "9.8", "79", "118"]
