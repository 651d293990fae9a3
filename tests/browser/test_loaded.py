"""A captured payload: its motion, its point of resolution and its axes."""

from __future__ import annotations

import pytest

from tests.browser.flight import Flight

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.long]

SCENARIO = "loaded"
ABOUT = "document.querySelector('.resolution .about').textContent"
PAYLOAD_Z = "frame.display.poses.at(-5)"
"""Height of the payload, the last body of a frame, in the scene."""


def test_orb_ld_lifts_the_payload(flight: Flight) -> None:
    flight.enter("ORB LD")
    flight.until(f"{ABOUT} === 'payload, orbiter axes'")
    start = flight.script("window.__aftdeck.lastFrame.display.poses.at(-5)")
    flight.hold("q")
    flight.until(f"{PAYLOAD_Z} > {start + 0.05} && frame.display.actual.velocity[2] < 0")
    flight.release("q")


def test_payload_axes_switch_selects_law_7(flight: Flight) -> None:
    flight.enter("ORB LD")
    flight.press_key("Rotate in payload axes")
    flight.until("frame.payload_axes && frame.law === 7")
    flight.until(f"{ABOUT} === 'payload; turns in payload axes'")
    flight.press_key("Rotate in payload axes")
    flight.until("!frame.payload_axes && frame.law === 4")


def test_pl_moves_the_payload(flight: Flight) -> None:
    flight.enter("PL")
    flight.until(f"{ABOUT} === 'payload, payload axes'")
    start = flight.frame().display.actual.position
    flight.hold("w")
    flight.until(f"Math.hypot(...frame.display.actual.position.map((x, i) => x - {list(start)}[i])) > 0.02")
    flight.release("w")


def test_present_point_of_the_payload_is_not_a_target_of_the_tip(flight: Flight) -> None:
    flight.enter("ORB LD")
    flight.turn_to("OPR CMD")
    with flight.logs("page"):
        flight.press_key("Present")
    flight.enter("ORB UNL")
    flight.turn_to("OPR CMD")
    flight.press_key("Present")
    shown = flight.page.get_by_label("Target X", exact=True).input_value()
    assert shown == flight.script("document.querySelector('.resolution td.actual').textContent")
