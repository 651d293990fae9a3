"""AUTO 1 flown from the page: PROCEED, points, pause point, and stop."""

from __future__ import annotations

import pytest

from tests.browser.conftest import SIZES, OpenPage
from tests.browser.flight import Flight
from tests.browser.layout_checks import assert_readable, assert_tidy

pytestmark = [pytest.mark.browser, pytest.mark.slow]

SCENARIO = "sequence"
POINT = "document.querySelector('.route .point').textContent"
SEQUENCE_MS = 240_000
"""Longest wait for the pause point [ms]; the motion takes about 35 s."""


def test_proceed_flies_the_sequence_to_its_pause_point(flight: Flight) -> None:
    flight.until(f"{POINT} === 'Point 1 of 4'")
    with flight.logs("sequence"):
        flight.press("p")
        flight.until("frame.sequence === 'in progress'")
        flight.until("document.querySelectorAll('.sequence small')[1].matches('.lit')")
        flight.until("Number(document.querySelectorAll('.route dd')[2].textContent) > 0")
        flight.until(f"frame.point > 1 && {POINT} === `Point ${{frame.point}} of 4`", SEQUENCE_MS)
        flight.until("frame.sequence === 'ready' && frame.point === 4", SEQUENCE_MS)
    flight.until("/PROCEED continues/.test(document.querySelector('.route .remaining').textContent)")
    flight.until("/GOOD/.test(document.querySelector('.check.good')?.textContent ?? '')")


def test_proceed_continues_a_stopped_sequence(flight: Flight) -> None:
    flight.press("p")
    flight.until("frame.sequence === 'in progress' && Math.hypot(...frame.display.actual.velocity) > 0.01")
    flight.page.locator("button.stop").click()
    flight.until("frame.sequence === 'ready' && Math.hypot(...frame.display.actual.velocity) < 1e-4")
    flight.page.locator("button.proceed").click()
    flight.until("frame.sequence === 'in progress'")


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_page_is_tidy_and_readable_during_a_sequence(open_page: OpenPage, width: int, height: int) -> None:
    flight = open_page(width, height).from_the_start()
    flight.press("p")
    flight.until("frame.sequence === 'in progress' && Math.hypot(...frame.display.actual.velocity) > 0.01")
    assert_tidy(flight)
    assert_readable(flight)
