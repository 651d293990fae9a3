"""A payload acquired, lifted and released by keys, with the concept arm of 1972."""

from __future__ import annotations

from pathlib import Path

import pytest

from aftdeck.scenario.load import load_scenario
from aftdeck.scene.bodies import bodies_of
from tests.browser.conftest import OpenPage
from tests.browser.flight import Flight
from tests.browser.layout_checks import assert_readable, assert_tidy

pytestmark = [pytest.mark.browser, pytest.mark.slow]

SCENARIO = str(Path(__file__).parent / "over-the-bar.toml")
"""The end effector starts open, 3 in above the bar."""

AT_REST = "Math.hypot(...frame.display.actual.velocity) < 1e-4 && frame.translation.every((value) => value === 0)"
CELL = "[...document.querySelectorAll('.cells li:not([hidden])')].find((cell) => /^{}/.test(cell.textContent))"
HEIGHT_HOLDS = f"{CELL.format('palm height')}?.matches('.holds')"
INHIBITED = "document.querySelector('.inhibits .lit')?.textContent === 'Arm inhibit'"
TITLE = "document.querySelector('.conditions h2').textContent"
HELD = "frame.work.cargo[0].held"
NORTH, MENU, CROSS_UP = 3, 9, 12
"""Buttons of the standard mapping."""
MOST_TRIES = 10
"""Greatest number of attempts to stop the palm in its range of 0.75 inches. An attempt may release the key too late."""


def test_bodies_are_drawn_and_keys_acquire_lift_and_release_the_payload(flight: Flight) -> None:
    drawn = {body["name"]: body["triangles"] for body in flight.script("window.__aftdeck.bodies")}
    defined = {body.name: body.shapes for body in bodies_of(load_scenario(SCENARIO))}
    assert set(drawn) == set(defined) >= {"orbiter", "cae", "payload", "arm.prong", "arm.stand"}
    assert [name for name, shapes in defined.items() if shapes and drawn[name] == 0] == []

    flight.until(f"{TITLE}.startsWith('acquire Payload') && !({HEIGHT_HOLDS})")

    # Down to contact: the arm is inhibited, and the page shows the escape direction.
    flight.press("v")
    flight.until("frame.rate === 'vernier'")
    flight.hold("e")
    flight.until(f"frame.work.arm_inhibit && {INHIBITED}")
    flight.release("e")
    flight.until(f"{AT_REST} && /Escape: THC −Z/.test(document.querySelector('.touching').textContent)")
    assert_tidy(flight)

    # Upwards, until the condition `palm height` holds; downwards after too long a press.
    for _ in range(MOST_TRIES):
        frame = flight.until(AT_REST)
        failed = {each.name: each.value for each in frame.work.conditions if not each.holds}
        if not frame.work.arm_inhibit and set(failed) == {"prong closed"}:
            break
        key = "e" if failed.get("palm height", 0.0) > 0.0 and not frame.work.arm_inhibit else "q"
        flight.hold(key)
        flight.until(f"{HEIGHT_HOLDS} && !({INHIBITED})")
        flight.release(key)
    flight.until(f"{HEIGHT_HOLDS} && !({INHIBITED})")
    flight.until(f"/fingers .* apart, at most .* allowed/.test({TITLE})")

    # The prong closes and acquires the payload.
    with flight.logs("acquired"):
        flight.hold("g")
        flight.until("frame.work.hand.switch === 'close'")
        flight.release("g")
    flight.until(f"{HELD} && document.querySelector('.effector .about').textContent.startsWith('payload, ')")
    flight.until("document.querySelector('.phases .present').textContent === 'Extract'")
    flight.until("frame.work.objective === null")  # although the conditions of the berth still hold

    # The payload moves up with the arm, also in the picture.
    lowest = _position(flight, "payload")[2]
    flight.press("v")
    flight.hold("q")
    flight.until(f"{HELD} && window.__aftdeck.bodies.find(({{ name }}) => name === 'payload').at[2] > {lowest + 0.3}")
    flight.release("q")
    flight.until(AT_REST)
    flight.until(f"{TITLE}.startsWith('insert in the Cargo bay') && !{TITLE}.includes('all met')")
    assert_tidy(flight)
    assert_readable(flight)

    # It would float, and no step of a task wants that: the first RELEASE only asks.
    with flight.logs("release"):
        flight.hold("r")
        flight.until("document.querySelectorAll('.effector .fill')[1].style.transform === 'scaleX(1)'")
        flight.release("r")
    flight.until(HELD)

    # The released payload stays at its position.
    with flight.logs("released"):
        flight.hold("r")
        flight.until(f"!{HELD} && frame.work.cargo[0].seat === ''")
        flight.release("r")
    assert _position(flight, "payload")[2] > lowest + 0.2


def test_thc_flies_the_orbiter_and_the_assembly_element_stays(flight: Flight) -> None:
    before = _position(flight, "cae")
    flight.press("`")
    flight.until("document.querySelector('.thc .about').textContent === 'moves the orbiter'")
    flight.hold("w")
    flight.until("frame.display.orbiter[0] > 0.05")
    flight.release("w")
    flight.until("Math.hypot(...frame.display.orbiter_velocity) === 0")
    flight.until("Number(document.querySelector('.orbiter dd').textContent) > 0")
    moved = flight.frame().display.orbiter[0]
    assert _position(flight, "cae")[0] - before[0] == pytest.approx(moved, abs=1e-6), (
        "it moves aft relative to the orbiter"
    )
    assert flight.frame().display.actual.velocity == (0.0, 0.0, 0.0)


def test_pad_moves_the_prong_and_the_telescope(open_page: OpenPage) -> None:
    flight = open_page(pad=True).from_the_start()
    flight.pad_buttons(NORTH)
    flight.until("frame.work.hand.switch === 'close' && frame.work.hand.opening < 1")
    flight.pad_buttons()
    flight.pad_buttons(MENU, NORTH)
    flight.until("frame.work.hand.switch === 'open'")
    flight.pad_buttons()
    stand = flight.frame().work.stand
    flight.pad_buttons(MENU, CROSS_UP)
    flight.until(f"frame.work.stand > {stand} + 0.02")
    flight.pad_buttons()


def _position(flight: Flight, name: str) -> list[float]:
    """Return the position at which a body is drawn, in the scene [m]."""
    (position,) = [body["at"] for body in flight.script("window.__aftdeck.bodies") if body["name"] == name]
    return [float(value) for value in position]
