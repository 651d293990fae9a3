"""Page of a flight on a plant with masses: the plant's name, and the torques of the joints."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.browser.conftest import SIZES, OpenPage, running_station
from tests.browser.flight import Flight
from tests.browser.layout_checks import assert_readable, assert_tidy

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.long]

WIDEST = (
    "Math.max(...[...document.querySelectorAll('.joints .torque .actual')].map((bar) => bar.getAttribute('width')))"
)
"""JavaScript: greatest torque that the joint table shows; 46 is the greatest torque of the motor."""


@pytest.fixture(scope="module")
def station() -> Iterator[str]:
    """Address of a station that flies the flexible arm with 32,000 lb."""
    with running_station("loaded", "--plant", "flexible") as address:
        yield address


def test_torques_are_shown_while_the_arm_starts_and_stops(flight: Flight) -> None:
    assert flight.page.locator(".rail .plant").inner_text() == "flexible arm"
    flight.hold("q")
    frame = flight.until(f"{WIDEST} > 5 && Math.hypot(...frame.twist.slice(3)) > 0.005")
    assert frame.dynamics is not None
    assert max(map(abs, frame.dynamics.torques)) > 50.0
    flight.release("q")
    flight.until("Math.hypot(...frame.twist.slice(3)) < 0.001")


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_joint_table_with_torques_fits(open_page: OpenPage, width: int, height: int) -> None:
    flight = open_page(width, height)
    flight.page.locator(".joints .torque").first.wait_for()
    assert_tidy(flight)
    assert_readable(flight)


FARTHER = """() => {
    const { bodies, lastFrame } = window.__aftdeck;
    const at = (name) => {
        const i = bodies.findIndex((body) => body.name === name);
        const place = lastFrame.display.poses.slice(7 * i, 7 * i + 3);
        return Math.hypot(...bodies[i].at.map((each, axis) => each - place[axis]));
    };
    return [at('arm.base'), at('arm.wrist_roll'), at('payload')];
}"""
"""Distances of the drawn bodies from their true places [m]."""
PICTURE_M = 0.01
"""Greatest motion of the loaded arm between the last picture and the last frame of the read-outs [m]."""


def test_key_draws_bending_larger(flight: Flight) -> None:
    flight.hold("q")
    flight.until("Math.abs(frame.dynamics.bends[0].rotation[1]) > 1e-4")
    assert max(flight.script(FARTHER)) < PICTURE_M
    flight.press("NumpadMultiply")
    flight.page.locator(".burned.time", has_text="BEND × 50").first.wait_for()
    flight.polled()
    base, wrist, payload = flight.script(FARTHER)
    assert base == 0.0
    assert wrist > 5.0 * PICTURE_M
    assert payload > 5.0 * PICTURE_M
    assert flight.page.locator(".joints h2 button[aria-pressed=true]").inner_text().endswith("× 50")
    flight.press("NumpadMultiply")
    flight.page.locator(".burned.time", has_text="live").first.wait_for()
    flight.polled()
    assert max(flight.script(FARTHER)) < PICTURE_M
    flight.release("q")
