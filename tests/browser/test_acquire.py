"""A payload acquired, lifted and let go from the page, by keys alone, with the concept arm of 1972."""

from __future__ import annotations

from pathlib import Path

import pytest

from aftdeck.scenario.load import load_scenario
from aftdeck.scene.bodies import bodies_of
from tests.browser.flight import Flight
from tests.browser.looks import assert_readable, assert_tidy

pytestmark = pytest.mark.browser

SCENARIO = str(Path(__file__).parent / "over-the-bar.toml")
"""The hand begins open, 3 in over the bar."""

AT_REST = "Math.hypot(...frame.actual.velocity) < 1e-4 && frame.translation.every((value) => value === 0)"
CELL = "[...document.querySelectorAll('.cells li:not([hidden])')].find((cell) => /^{}/.test(cell.textContent))"
HEIGHT_HOLDS = f"{CELL.format('palm height')}?.matches('.holds')"
INHIBITED = "document.querySelector('.inhibits .lit')?.textContent === 'Arm inhibit'"
TITLE = "document.querySelector('.conditions h2').textContent"
HELD = "frame.work.cargo[0].held"
MOST_TAPS = 150
"""A tap lifts the hand by a hundredth of an inch and more; it stands at most half an inch deep."""


def test_every_body_of_the_concepts_worksite_is_drawn(flight: Flight) -> None:
    drawn = {body["name"]: body["triangles"] for body in flight.script("window.__aftdeck.bodies")}
    defined = {body.name: body.shapes for body in bodies_of(load_scenario(SCENARIO))}
    assert set(drawn) == set(defined) >= {"orbiter", "cae", "payload", "arm.prong", "arm.stand"}
    assert [name for name, shapes in defined.items() if shapes and drawn[name] == 0] == []


def test_the_payload_is_acquired_lifted_and_let_go_by_keys_alone(flight: Flight) -> None:
    flight.until(f"{TITLE}.startsWith('acquire Payload') && !({HEIGHT_HOLDS})")

    # Down: the palm meets the bar, the arm is inhibited, and the page says what frees it.
    flight.press("v")
    flight.until("frame.rate === 'vernier'")
    flight.hold("e")
    flight.until(f"frame.work.arm_inhibit && {INHIBITED}")
    flight.release("e")
    flight.until(f"{AT_REST} && /Way out: THC −Z/.test(document.querySelector('.touching').textContent)")
    assert_tidy(flight)

    # Off the bar again, a little at a time, until the page says that the height is right.
    for _ in range(MOST_TAPS):
        flight.press("q")
        if flight.until(AT_REST) and flight.script(HEIGHT_HOLDS):
            break
    flight.until(f"{HEIGHT_HOLDS} && !({INHIBITED})")
    flight.until(f"/fingers .* apart, at most .* allowed/.test({TITLE})")

    # The prong closes about the bar, and there the payload hangs.
    flight.hold("g")
    flight.until("frame.work.hand.switch === 'close'")
    flight.release("g")
    flight.until(f"{HELD} && document.querySelector('.effector .about').textContent === 'payload in the grasp'")
    flight.until_logged("Payload acquired")
    flight.until("document.querySelector('.phases .present').textContent === 'Extract'")
    flight.until(f"{TITLE} === 'insert in the Cargo bayall met: let go, hold R'")

    # Up: it comes along, and is drawn where it is.
    lowest = _payload(flight)[2]
    flight.press("v")
    flight.hold("q")
    flight.until(f"{HELD} && window.__aftdeck.bodies.find(({{ name }}) => name === 'payload').at[2] > {lowest + 1.0}")
    flight.release("q")
    flight.until(AT_REST)
    assert_tidy(flight)
    assert_readable(flight)

    # Let go, it is free where it was left.
    flight.hold("r")
    flight.until(f"!{HELD} && frame.work.cargo[0].seat === ''")
    flight.release("r")
    flight.until_logged("Payload released: it is free")
    assert _payload(flight)[2] > lowest + 0.9


def _payload(flight: Flight) -> list[float]:
    """Where the payload is drawn, in the scene [m]."""
    bodies = flight.script("window.__aftdeck.bodies")
    (place,) = [body["at"] for body in bodies if body["name"] == "payload"]
    return [float(value) for value in place]
