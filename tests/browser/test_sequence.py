"""AUTO 1 flown from the page: PROCEED, points, pause point, and stop."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.browser.conftest import SIZES, running_station
from tests.browser.flight import Flight
from tests.browser.layout_checks import assert_readable, assert_tidy

pytestmark = [pytest.mark.browser, pytest.mark.slow]

SHORT, LONG = str(Path(__file__).parent / "short-sequence.toml"), "sequence"
"""Scenarios whose motion to the pause point takes some 10 s, and some 35 s."""

POINT = "document.querySelector('.route .point').textContent"
MOVES = "frame.sequence === 'in progress' && Math.hypot(...frame.display.actual.velocity) > 0.01"
SEQUENCE_MS = 120_000
"""Longest wait for the pause point [ms]."""


@pytest.fixture
def station(request: pytest.FixtureRequest) -> Iterator[str]:
    """Address of a running `aftdeck fly` with the scenario of the test's parameter."""
    with running_station(request.param) as address:
        yield address


@pytest.mark.parametrize("station", [SHORT], indirect=True)
def test_proceed_flies_the_sequence_to_its_pause_point_also_after_stop(flight: Flight) -> None:
    flight.until(f"{POINT} === 'Point 1 of 4'")
    with flight.logs("sequence"):
        flight.press("p")
        flight.until("document.querySelectorAll('.sequence small')[1].matches('.lit')")
        flight.until("Number(document.querySelectorAll('.route dd')[2].textContent) > 0")
        flight.until(MOVES)
        flight.page.locator("button.stop").click()
        flight.until("frame.sequence === 'ready' && Math.hypot(...frame.display.actual.velocity) < 1e-4")
        assert flight.frame().point < 4
        flight.page.locator("button.proceed").click()
        flight.until(f"frame.point > 1 && {POINT} === `Point ${{frame.point}} of 4`", SEQUENCE_MS)
        flight.until("frame.sequence === 'ready' && frame.point === 4", SEQUENCE_MS)
    flight.until("/PROCEED continues/.test(document.querySelector('.route .remaining').textContent)")
    flight.until("/GOOD/.test(document.querySelector('.check.good')?.textContent ?? '')")


@pytest.mark.parametrize("station", [LONG], indirect=True)
def test_page_is_tidy_and_readable_during_a_sequence(flight: Flight) -> None:
    flight.press("p")
    flight.until(MOVES)
    for width, height in SIZES:
        flight.resize(width, height)
        assert_tidy(flight)
        assert_readable(flight)
    assert flight.frame().sequence == "in progress"  # its motion lasts longer than the checks
