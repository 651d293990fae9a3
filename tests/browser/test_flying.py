"""The arm flown from the page: keyboard, pad, target, and causes that zero the sticks."""

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


def test_i_pitches_the_end_effector_about_the_tip(flight: Flight) -> None:
    flight.enter("END EFF")
    start = flight.frame().display.actual
    flight.hold("i")
    flight.until("frame.rotation[1] === 1 && Math.hypot(...frame.display.actual.turn_rate) > 0.005")
    flight.release("i")
    flight.until(f"{STICKS_AT_ZERO} && {AT_REST}")
    assert math.dist(start.position, flight.frame().display.actual.position) < 0.02
    assert math.dist(start.attitude, flight.frame().display.actual.attitude) > 0.001


def test_pad_deflects_thc_and_rhc_at_once(open_page: OpenPage) -> None:
    flight = open_page(pad=True).from_the_start()
    flight.enter("ORB UNL")
    start = flight.frame().display.actual.position
    flight.pad_axes(0, -1, 0.5, 0)
    flown = flight.until(f"frame.display.actual.position[0] > {start[0] + 0.05} && frame.translation[0] === 1")
    assert 0 < flown.rotation[2] < 0.5, "with expo, half a deflection commands less than half of the rate"
    flight.pad_axes(0.05, 0.05, 0.05, 0.05)
    flight.until(STICKS_AT_ZERO)


@pytest.mark.slow
def test_lost_pad_zeroes_the_sticks_until_it_was_centred(open_page: OpenPage) -> None:
    flight = open_page(pad=True).from_the_start()
    flight.pad_axes(0, -1, 0, 0)
    flight.until("frame.translation[0] === 1")
    flight.script("window.kept = window.testPad; window.testPad = null")
    flight.until(STICKS_AT_ZERO)
    flight.until_lit("CONTROLLER")

    flight.script("window.testPad = window.kept")
    flight.until("/^Centre: /.test(document.querySelector('.device').textContent)")
    assert flight.frame().translation == (0, 0, 0)
    flight.pad_axes(0, 0, 0, 0)
    flight.until("!/^Centre: /.test(document.querySelector('.device').textContent)")
    flight.pad_axes(0, -1, 0, 0)
    flight.until("frame.translation[0] === 1")


@pytest.mark.parametrize(
    "leave",
    [
        "Object.defineProperty(document, 'hidden', { value: true, configurable: true });"
        "document.dispatchEvent(new Event('visibilitychange'))",
        "window.dispatchEvent(new Event('blur'))",
    ],
    ids=["hidden", "blurred"],
)
def test_page_without_focus_zeroes_the_sticks(flight: Flight, leave: str) -> None:
    flight.hold("w")
    flight.until("frame.translation[0] === 1")
    flight.script(leave)
    flight.until(STICKS_AT_ZERO)


def test_proceed_flies_to_the_keyed_in_target(flight: Flight) -> None:
    flight.enter("OPR CMD")
    target = key_in_x(flight, 4 * INCH)
    flight.until("frame.sequence === 'ready'")
    flight.press("p")
    there = f"Math.abs(frame.display.actual.position[0] - {target}) < 0.01"
    flight.until(f"{there} && frame.sequence !== 'in progress' && {AT_REST}")


def test_space_stops_a_motion_while_a_button_has_focus(flight: Flight) -> None:
    flight.enter("OPR CMD")
    target = key_in_x(flight, 120 * INCH)  # the motion takes 11 s
    flight.until("frame.sequence === 'ready'")
    flight.page.get_by_role("button", name="Proceed").focus()
    flight.press("Enter")
    flight.until("frame.sequence === 'in progress' && Math.hypot(...frame.display.actual.velocity) > 0.01")
    flight.press("Space")
    flight.until(f"frame.sequence !== 'in progress' && {AT_REST}")
    assert target - flight.frame().display.actual.position[0] > 0.2


def test_w_drives_only_the_selected_joint(flight: Flight) -> None:
    flight.enter("SINGLE")
    joint = (flight.frame().joint + 1) % 6
    flight.press("=")
    flight.until(f"frame.joint === {joint}")
    start = flight.frame().angles
    flight.hold("w")
    flight.until(f"Math.abs(frame.angles[{joint}] - {start[joint]}) > 0.005")
    flight.release("w")
    flight.until(f"{STICKS_AT_ZERO} && {AT_REST}")
    moved = [abs(now - then) > 1e-6 for now, then in zip(flight.frame().angles, start, strict=True)]
    assert moved == [index == joint for index in range(6)]


def test_v_switches_between_coarse_and_vernier(flight: Flight) -> None:
    before = flight.frame().rate
    flight.press("v")
    flight.until(f"frame.rate !== '{before}'")
    flight.press("v")
    flight.until(f"frame.rate === '{before}'")


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


def test_target_that_is_not_a_number_is_rejected(flight: Flight) -> None:
    flight.turn_to("OPR CMD")
    field = flight.page.get_by_label("Target Y", exact=True)
    field.fill("far")
    with flight.logs("page"):
        field.press("Enter")
    assert flight.frame().display.aim is None


def key_in_x(flight: Flight, by: float) -> float:
    """Enter a target: the present point, displaced by `by` [m] along X. Return the X of the target [m]."""
    flight.page.get_by_role("button", name="Present").click()
    field = flight.page.get_by_label("Target X", exact=True)
    target = float(field.input_value().replace("−", "-")) + by / INCH
    field.fill(f"{target:.1f}")
    field.press("Enter")
    return target * INCH
