"""Near all three singularities: the gauges, their lamp, and the escape directions that the page shows."""

from __future__ import annotations

import pytest

from tests.browser.conftest import SIZES, OpenPage
from tests.browser.flight import LOGGED, Flight
from tests.browser.layout_checks import assert_readable, assert_tidy

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.long]

SCENARIO = "singular"
KEYS = {
    ("translation", 0, 1): "w", ("translation", 0, -1): "s",
    ("translation", 1, 1): "d", ("translation", 1, -1): "a",
    ("translation", 2, 1): "e", ("translation", 2, -1): "q",
    ("rotation", 0, 1): "o", ("rotation", 0, -1): "u",
    ("rotation", 1, 1): "i", ("rotation", 1, -1): "k",
    ("rotation", 2, 1): "l", ("rotation", 2, -1): "j",
}  # fmt: skip
"""Key for each stick, axis and sign."""


def test_each_singularity_gauge_names_its_escape(flight: Flight) -> None:
    flight.until_lit("SINGULAR")
    flight.until("document.querySelectorAll('.distance.caution').length === 3")
    flight.until("frame.ways_out.length === 3")
    labels = "[...document.querySelectorAll('.distance .label')].map((label) => label.textContent)"
    for name, label in zip(("Shoulder", "Elbow", "Wrist"), flight.script(labels), strict=True):
        assert label.startswith((f"{name}: THC ", f"{name}: RHC ", f"{name}: SINGLE "))


def test_start_near_singularities_raises_no_alarm(flight: Flight) -> None:
    """The lamps are lit, but MASTER ALARM waits for a change."""
    flight.until_lit("SINGULAR")
    master = flight.page.locator(".master")
    flight.until("/2 cautions/.test(document.querySelector('.master').textContent)")
    assert "press" not in master.inner_text()
    assert not flight.script("document.querySelector('.master').matches('.caution, .warning')")


def test_named_escape_leads_away_from_the_singularity(flight: Flight) -> None:
    start = flight.until("frame.ways_out.some((way) => way.cause === 'elbow')")
    way = next(way for way in start.ways_out if way.cause == "elbow")
    key = KEYS[way.stick, way.axis, way.sign]
    flight.hold(key)
    flight.until(f"Math.abs(frame.singularity[1]) > {abs(start.singularity[1]) + 0.01}")
    flight.release(key)


def test_singular_lamp_filters_the_log(flight: Flight) -> None:
    flight.until_lit("SINGULAR")
    outlined = "document.querySelectorAll('.distance.concerned').length === 3"
    named = "document.querySelector('.events .about').textContent.startsWith('SINGULAR')"
    filtered = f"{LOGGED}.join() === 'singular,singular,singular'"
    with flight.shows(f"{outlined} && {named} && {filtered}"):
        flight.page.locator(".lamp", has_text="SINGULAR").click()


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_escapes_are_tidy_and_readable(open_page: OpenPage, width: int, height: int) -> None:
    flight = open_page(width, height).from_the_start()
    flight.enter("SINGLE")
    flight.until("frame.ways_out.every((way) => way.stick === 'joint')")
    flight.until_lit("SINGULAR")
    assert_tidy(flight)
    assert_readable(flight)
