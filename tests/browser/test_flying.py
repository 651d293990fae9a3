"""The arm flown from the page: keyboard, pad, target, and STOP."""

from __future__ import annotations

import math

import pytest

from tests.browser.conftest import OpenPage
from tests.browser.flight import Flight

pytestmark = pytest.mark.browser

AT_REST = "Math.hypot(...frame.display.actual.velocity, ...frame.display.actual.turn_rate) < 1e-4"
STICKS_AT_ZERO = "[...frame.translation, ...frame.rotation, frame.drive].every((value) => value === 0)"
INCH = 0.0254


def test_w_flies_the_tip_forward_until_it_is_released(flight: Flight) -> None:
    flight.enter("ORB UNL")
    start = flight.frame().display.actual.position
    flight.hold("w")
    flight.until(f"frame.display.actual.position[0] > {start[0] + 0.10}")
    flight.until("frame.translation[0] === 1")
    flight.release("w")
    flight.until(f"{STICKS_AT_ZERO} && {AT_REST}")
    end = flight.frame().display.actual.position
    assert math.dist(start[1:], end[1:]) < 0.01


def test_slider_in_focus_takes_arrow_keys_while_letters_fly(flight: Flight) -> None:
    flight.enter("ORB UNL")
    before = flight.frame().views
    flight.script("(() => { const v = document.querySelector('.volume'); v.focus(); window.volume = v.value; })()")
    flight.press("ArrowLeft")
    assert flight.script("document.querySelector('.volume').value < window.volume")
    flight.hold("w")
    flight.until("frame.translation[0] === 1 && !document.body.matches('.typing')")
    flight.release("w")
    flight.until(STICKS_AT_ZERO)
    assert flight.frame().views == before


def test_pad_deflects_thc_and_rhc_at_once(open_page: OpenPage) -> None:
    flight = open_page(pad=True).from_the_start()
    flight.enter("ORB UNL")
    start = flight.frame().display.actual.position
    flight.pad_axes(0, -1, 0.5, 0)
    flown = flight.until(f"frame.display.actual.position[0] > {start[0] + 0.05} && frame.translation[0] === 1")
    assert 0 < flown.rotation[2] < 0.5, "with expo, half a deflection commands less than half of the rate"
    flight.pad_axes(0.05, 0.05, 0.05, 0.05)
    flight.until(STICKS_AT_ZERO)


def test_space_stops_a_motion_while_a_button_has_focus(flight: Flight) -> None:
    flight.enter("OPR CMD")
    target = key_in_x(flight, 120 * INCH)  # the motion takes 11 s
    aim = flight.until("frame.sequence === 'ready'").display.aim
    assert aim is not None
    assert aim.position[0] == pytest.approx(target, abs=1e-6)
    flight.page.get_by_role("button", name="Proceed").focus()
    flight.press("Enter")
    flight.until("frame.sequence === 'in progress' && Math.hypot(...frame.display.actual.velocity) > 0.01")
    flight.press("Space")
    flight.until(f"frame.sequence !== 'in progress' && {AT_REST}")
    assert target - flight.frame().display.actual.position[0] > 0.2


def test_keys_in_a_text_field_do_not_fly(flight: Flight) -> None:
    flight.turn_to("OPR CMD")
    field = flight.page.get_by_label("Target X", exact=True)
    field.click()
    flight.hold("w")
    tick = flight.frame().tick
    flight.until(f"frame.tick > {tick + 25}")
    flight.release("w")
    assert "w" in field.input_value()
    assert flight.frame().translation == (0, 0, 0)
    assert flight.script("document.body.classList.contains('typing')")


def key_in_x(flight: Flight, by: float) -> float:
    """Enter a target: the present point, displaced by `by` [m] along X. Return the X of the target [m]."""
    flight.page.get_by_role("button", name="Present").click()
    field = flight.page.get_by_label("Target X", exact=True)
    target = float(field.input_value().replace("−", "-")) + by / INCH
    field.fill(f"{target:.1f}")
    field.press("Enter")
    return round(target, 1) * INCH
