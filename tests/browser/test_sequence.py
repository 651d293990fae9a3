"""AUTO 1 flown from the page: PROCEED, its points, its pause, and STOP."""

from __future__ import annotations

import pytest

from tests.browser.conftest import SIZES, OpenPage
from tests.browser.flight import Flight
from tests.browser.looks import assert_readable, assert_tidy

pytestmark = [pytest.mark.browser, pytest.mark.slow]

SCENARIO = "sequence"
POINT = "document.querySelector('.route .point').textContent"
TOUR_MS = 240_000
"""The longest that the way to the pause point may take [ms]; it is flown in some 35 s."""


def test_proceed_flies_the_tour_to_its_pause_point(flight: Flight) -> None:
    flight.until(f"{POINT} === 'Point 1 of 4'")
    flight.press("p")
    flight.until("frame.sequence === 'in progress'")
    flight.until("document.querySelectorAll('.sequence small')[1].matches('.lit')")
    flight.until("Number(document.querySelectorAll('.route dd')[2].textContent) > 0")
    flight.until(f"frame.point > 1 && {POINT} === `Point ${{frame.point}} of 4`", TOUR_MS)
    flight.until("frame.sequence === 'ready' && frame.point === 4", TOUR_MS)
    flight.until("/PROCEED continues/.test(document.querySelector('.route .to-go').textContent)")
    flight.until("/GOOD/.test(document.querySelector('.check.good')?.textContent ?? '')")
    flight.until_logged("pause point: PROCEED continues the sequence")


def test_stop_halts_the_tour_and_proceed_goes_on(flight: Flight) -> None:
    flight.press("p")
    flight.until("frame.sequence === 'in progress' && Math.hypot(...frame.display.actual.velocity) > 0.01")
    flight.page.locator("button.stop").click()
    flight.until("frame.sequence === 'ready' && Math.hypot(...frame.display.actual.velocity) < 1e-4")
    flight.page.locator("button.proceed").click()
    flight.until("frame.sequence === 'in progress'")


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_the_tour_under_way_is_tidy_and_readable(open_page: OpenPage, width: int, height: int) -> None:
    flight = open_page(width, height).from_the_start()
    flight.press("p")
    flight.until("frame.sequence === 'in progress' && Math.hypot(...frame.display.actual.velocity) > 0.01")
    assert_tidy(flight)
    assert_readable(flight)
