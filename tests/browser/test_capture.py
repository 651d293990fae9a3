"""A payload captured by keys, with the snares of the Shuttle's arm."""

from __future__ import annotations

from pathlib import Path

import pytest

from aftdeck.scenario.load import load_scenario
from aftdeck.scene.bodies import bodies_of
from tests.browser.flight import Flight
from tests.browser.layout_checks import assert_readable, assert_tidy

pytestmark = [pytest.mark.browser, pytest.mark.slow]

SCENARIO = str(Path(__file__).parent / "over-the-pin.toml")
"""The end effector starts aligned with the pin, 8 in from it."""

AT_REST = "Math.hypot(...frame.display.actual.velocity) < 1e-4 && frame.translation.every((value) => value === 0)"
DEPTH = "frame.work.conditions.find(({ name }) => name === 'pin depth').value"
TITLE = "document.querySelector('.conditions h2').textContent"
LIT = "[...document.querySelectorAll('.flags .lit')].map((flag) => flag.textContent).join()"
ABOUT = "document.querySelector('.effector .about').textContent"
LOADED = "[...document.querySelectorAll('.rotary :not(.absent)')].some((key) => key.textContent === '{}')"
"""JavaScript condition, with {} for the name of a mode: this mode can be entered."""
INCH = 0.0254
MOST_TRIES = 20


def test_bodies_are_drawn_and_keys_capture_and_unlatch_the_payload(flight: Flight) -> None:
    drawn = {body["name"]: body["triangles"] for body in flight.script("window.__aftdeck.bodies")}
    defined = {body.name: body.shapes for body in bodies_of(load_scenario(SCENARIO))}
    assert set(drawn) == set(defined) >= {"orbiter", "payload"}
    assert [name for name, shapes in defined.items() if shapes and drawn[name] == 0] == []

    flight.until(f"!({LOADED.format('ORB LD')})")
    flight.until("[...document.querySelectorAll('.look-ahead dd')].every((each) => each.checkVisibility())")
    assert_tidy(flight)
    flight.press("v")
    flight.until("frame.rate === 'vernier'")
    flown = -2
    for _ in range(MOST_TRIES):
        frame = flight.until(f"frame.display.stick_seq > {flown} && {AT_REST}")
        (depth,) = [each for each in frame.work.conditions if each.name == "pin depth"]
        if depth.holds:
            break
        flown = frame.display.stick_seq
        key, there = ("e", f"{DEPTH} < {3 * INCH}") if depth.value > 0.0 else ("q", f"{DEPTH} > {0.5 * INCH}")
        flight.hold(key)
        flight.until(f"{there} || frame.work.arm_inhibit")
        flight.release(key)
    flight.until(f"{TITLE}.endsWith('all met: capture, hold G') && {LIT} === 'EXTEND,OPEN,DERIGID'")
    assert_tidy(flight)

    with flight.logs("acquired"):
        flight.hold("g")
        flight.until("frame.work.cargo[0].held")
        flight.release("g")
    flight.until(f"{LIT} === 'CAPTURE,CLOSE,RIGID' && {ABOUT}.startsWith('payload, ')")
    flight.until(f"{LOADED.format('ORB LD')} && {LOADED.format('PL')}")
    flight.until("document.querySelector('.seat .where').textContent === 'Payload bay latches'")

    # The payload is captured and latched: T begins to open the latches.
    with flight.logs("unlatch"):
        flight.hold("t")
        flight.until("document.querySelectorAll('.seat .fill')[1].style.transform === 'scaleX(1)'")
        flight.release("t")
    assert_tidy(flight)
    assert_readable(flight)
