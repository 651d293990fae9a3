"""The page with an arm whose first joint slides."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.browser.conftest import NARROW, SIZES
from tests.browser.flight import WAIT_MS, Flight
from tests.browser.test_joints import OVERFULL

pytestmark = [pytest.mark.browser, pytest.mark.slow]
expect.set_options(timeout=WAIT_MS)

SCENARIO = str(Path(__file__).parents[2] / "examples" / "arms" / "fly-rail.toml")


def test_joint_that_slides_has_lengths_and_its_slider_moves_it_by_centimetres(flight: Flight) -> None:
    page = flight.page
    rail = page.locator(".joints tbody tr").first
    expect(rail.locator("th")).to_have_text("Rail m")
    expect(rail.locator(".angle")).to_have_text("+0.500")
    page.get_by_role("button", name="SI", exact=True).click()
    expect(rail.locator("th")).to_have_text("Rail in")
    expect(rail.locator(".angle")).to_have_text("+19.7")
    for width, height in [*SIZES, *NARROW]:
        flight.resize(width, height)
        assert flight.script(f"({OVERFULL})()") == [], (width, height)
    flight.resize(*SIZES[0])
    flight.enter("MASTER")
    slider = page.get_by_role("slider", name="Master Rail")
    slider.focus()
    slider.press("PageUp")
    slider.press("ArrowRight")
    flight.until("Math.abs(frame.work.master[0] - 0.61) < 1e-9 && Math.abs(frame.angles[0] - 0.61) < 1e-3")
    expect(slider).to_have_attribute("aria-valuetext", "+24.0 inches, joint at +24.0")
