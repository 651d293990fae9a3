"""The calm page: few parts at the first flight, those that a step needs, and the key *Full panel*."""

from __future__ import annotations

import pytest

from tests.browser.conftest import OpenPage
from tests.browser.flight import TURNED, Flight
from tests.browser.layout_checks import assert_tidy

pytestmark = pytest.mark.browser

CALM = True
MOST = 40
"""Greatest number of controls and read-outs at the first flight."""
FEWEST_OF_FULL = 100
"""The full panel has more parts than this; a count that misses most parts would find fewer."""
SIZES = [(1024, 768), (768, 1024), (1280, 720), (1440, 900), (1920, 1080)]
"""Window sizes [px]."""

PARTS = r"""() => {
    const seen = (node) => node.checkVisibility({ visibilityProperty: true }) && !node.closest('.unseen, .skip');
    const own = (node) => [...node.childNodes].filter((child) => child instanceof Text).map(({ data }) => data).join();
    const controls = [...document.querySelectorAll('button, input, select, a[href]')];
    const values = [...document.querySelectorAll('body *')]
        .filter((node) => (/\d/.test(own(node)) || node.matches('.flag')) && !node.closest('button, kbd'));
    const instruments = [...document.querySelectorAll('svg.frame-axes, .desk svg')]
        .filter((node) => !node.closest('button'));
    // On a slow machine, lamps are lit, the log has lines about it, and the rail shows the delays.
    const slow = [...document.querySelectorAll('.lamp, .log *, .times *')];
    return [...controls, ...values, ...instruments].filter(seen)
        .filter((node) => !slow.includes(node)).map((node) => node.textContent.trim());
}"""
"""Texts of the visible controls, of the elements with a digit or a flag, and of the drawings on the desk."""
JOINTS = "document.querySelector('.desk > .joints').checkVisibility()"
BRAKES = "[...document.querySelectorAll('.standing button')].find((key) => key.textContent.includes('Brakes'))"


def test_first_flight_has_at_most_40_controls_and_read_outs(open_page: OpenPage) -> None:
    flight = open_page(1440, 900).from_the_start()
    for _ in range(2):
        assert len(parts := flight.script(PARTS)) <= MOST, "\n".join(parts)
        flight.press_key("Open the guide")
        assert len(parts := flight.script(PARTS)) <= MOST, "\n".join(parts)
        flight.press_key("Skip step")
        flight.press_key("Close the guide")
    assert not flight.script(JOINTS)
    flight.press_key("Full panel")
    flight.until(JOINTS)
    assert len(flight.script(PARTS)) > FEWEST_OF_FULL


def test_full_panel_is_kept_and_can_be_left(open_page: OpenPage) -> None:
    flight = open_page().from_the_start()
    flight.press_key("Full panel")
    flight.page.reload()
    flight = Flight(flight.page)
    flight.until(JOINTS)
    flight.press_key("Full panel")
    flight.until(f"!{JOINTS}")


def test_key_of_a_function_and_a_mode_show_their_parts(open_page: OpenPage) -> None:
    flight = open_page().from_the_start()
    assert not flight.script(f"{BRAKES}.checkVisibility()")
    flight.press("b")
    flight.until(f"frame.brakes && {BRAKES}.checkVisibility()")
    flight.hold("b")
    flight.until("!frame.brakes")
    flight.release("b")
    # The joints appear when the rotary is turned to SINGLE.
    flight.press("]", "]", "]", "]")
    flight.until(f"{TURNED} === 'SINGLE' && {JOINTS}")
    flight.press("[", "[", "[", "[")
    flight.until(f"!{TURNED}")
    flight.from_the_start()
    flight.until(f"!{JOINTS} && !{BRAKES}.checkVisibility()")


@pytest.mark.slow
def test_calm_page_is_tidy_at_all_sizes(open_page: OpenPage) -> None:
    flight = open_page(1440, 900).from_the_start()
    for width, height in SIZES:
        flight.resize(width, height)
        assert_tidy(flight)
