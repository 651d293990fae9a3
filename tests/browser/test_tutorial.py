"""The tutorial: its steps with a pad, how it opens (on the first visit and by its button), and its layout."""

from __future__ import annotations

import pytest

from aftdeck.station.messages.frame import Frame
from tests.browser.conftest import NARROW, SIZES, OpenPage
from tests.browser.flight import FLIES, Flight
from tests.browser.layout_checks import assert_readable, assert_tidy

pytestmark = [pytest.mark.browser, pytest.mark.slow]

SCENARIO = "tutorial"
CALM = True
STEP = "document.querySelector('.task .steps span')?.textContent"
OPEN = "document.querySelector('.task')?.checkVisibility() === true"
TITLE = "document.querySelector('.task h2').textContent"
WORDS = "document.querySelector('.task .words').textContent"
DRAWN = "document.querySelector('.task .pad-drawing').checkVisibility()"
AT_REST = "Math.hypot(...frame.display.actual.velocity) < 1e-4 && frame.translation.every((value) => value === 0)"
DEPTH = "frame.work.conditions.find(({ name }) => name === 'pin depth').value"
SOUTH, NORTH, L_TRIGGER, R_TRIGGER, MENU = 0, 3, 6, 7, 9
"""Buttons of the standard mapping."""
INCH = 0.0254
PIN_X = -903.7323 * INCH
"""X of the grapple pin in the panel frame [m]; its Y is 0."""
LATCHES_MS = 120_000
"""Longest wait for the latches [ms], which take 30 s."""
FAR = 20 * INCH
"""Depth of the pin above which the test closes in fast [m]."""
MOST_TRIES = 20
MIDDLE = 1.5 * INCH
"""The test ends the alignment when the pin is off axis by less than this distance [m]; the tutorial allows 2 inches."""

CLASHES = """() => {
    const box = (node) => node.getBoundingClientRect();
    const card = document.querySelector('.task');
    const p = box(card);
    const clashes = [...document.querySelectorAll('.monitor, .spine, .thc, .rhc, .effector, .conditions, .events')]
        .filter((node) => node.checkVisibility())
        .filter((node) => {
            const q = box(node);
            return p.right > q.left + .5 && q.right > p.left + .5 && p.bottom > q.top + .5 && q.bottom > p.top + .5;
        })
        .map((node) => `the card covers ${node.className}`);
    const parts = [...card.querySelectorAll('h2, p, kbd, button, .pad-drawing, .steps')]
        .filter((node) => node.checkVisibility());
    for (const [i, node] of parts.entries()) {
        const q = box(node);
        if (q.left < p.left || q.right > p.right || q.top < p.top || q.bottom > p.bottom)
            clashes.push(`“${node.textContent}” leaves the card`);
        for (const other of parts.slice(i + 1)) {
            const r = box(other);
            const apart = q.right <= r.left + .5 || r.right <= q.left + .5
                || q.bottom <= r.top + .5 || r.bottom <= q.top + .5;
            if (!apart && !node.contains(other)) clashes.push(`“${node.textContent}” meets “${other.textContent}”`);
        }
    }
    return clashes;
}"""
"""Groups that the card covers, and parts of the card that extend beyond its edge or overlap each other."""


def test_pad_completes_all_tutorial_steps(open_page: OpenPage) -> None:
    flight = open_page(pad=True)
    flight.until(OPEN)
    flight.from_the_start()

    # Look: select another camera.
    flight.until(f"{STEP} === '1 of 6' && {AT_REST}")
    flight.pad_buttons(MENU)
    flight.until(f"{DRAWN} && {WORDS}.includes('Menu')")
    flight.pad_buttons()
    flight.until(f"{STEP} === '2 of 6'")

    # Move: towards the pin; the drawing of the pad lights the held control.
    flight.pad_axes(-1.0, 0.0, 0.0, 0.0)
    flight.until("document.querySelector('.task kbd.held')?.textContent === 'L stick ←left'")
    assert flight.script("document.querySelectorAll('.pad-drawing .part.held').length") == 1
    assert_tidy(flight)
    flight.until(f"{STEP} === '3 of 6'")
    flight.pad_axes(0.0, 0.0, 0.0, 0.0)

    _toggle_rate(flight, "vernier")
    _align(flight)
    flight.until(r"/ \([LR].\) /.test(document.querySelector('.task .to-go').title)")
    _close_in(flight)

    # Capture: the button has to be held.
    flight.until(f"{STEP} === '5 of 6' && {WORDS}.includes('Hold North for')")
    flight.until("document.querySelector('.conditions h2').textContent.includes('capture, hold North')")
    flight.pad_buttons(NORTH)
    flight.until("frame.work.cargo[0].held")
    flight.pad_buttons()
    flight.until(f"{STEP} === '6 of 6' && {WORDS}.includes('wait for RIGID')")

    # Lift: the latches open first, then the payload moves with the arm.
    flight.until(f"{WORDS}.includes('Hold Menu + South')")
    with flight.logs("unlatch"):
        flight.pad_buttons(MENU, SOUTH)
    flight.pad_buttons()
    flight.until(f"frame.work.cargo[0].seat === '' && {WORDS}.startsWith('The payload is free.')", LATCHES_MS)
    _toggle_rate(flight, "coarse")
    assert flight.script(STEP) == "6 of 6"
    low = _height(flight)
    flight.pad_axes(0.0, 1.0, 0.0, 0.0)
    lifted = flight.until(f"{STEP} === 'All 6 done'")
    flight.pad_axes(0.0, 0.0, 0.0, 0.0)
    assert lifted.work.cargo[0].held and lifted.work.cargo[0].seat == ""
    assert _height(flight) > low + 0.9
    assert flight.script(TITLE) == "Complete"

    # A restart starts the tutorial again.
    flight.from_the_start()
    flight.until(f"{STEP} === '1 of 6'")


def test_tutorial_opens_once_by_itself_and_by_its_key(open_page: OpenPage) -> None:
    flight = open_page().from_the_start()
    flight.until(f"{OPEN} && {STEP} === '1 of 6'")
    flight.press(".")
    flight.until(f"{STEP} === '2 of 6'")
    flight.page.get_by_role("button", name="Close the guide").press("Enter")
    flight.until(f"!({OPEN}) && !document.body.matches('.guided')")
    assert flight.frame().mode == "END EFF"

    flight.page.reload()
    flight = Flight(flight.page)
    flight.until(f"{FLIES} && window.__aftdeck.frames > 20")
    assert not flight.script(OPEN)
    flight.press_key("Guide")
    flight.until(f"{OPEN} && {STEP} === '2 of 6'")  # the station keeps the progress
    flight.press_key("Guide")
    flight.until(f"!({OPEN})")
    flight.press_key("Open the guide")
    flight.until(OPEN)


def test_tutorial_shows_keys_or_the_drawing_of_the_pad(open_page: OpenPage) -> None:
    flight = open_page(pad=True).from_the_start()
    flight.press_key("Skip step")
    flight.until(f"{STEP} === '2 of 6' && !({DRAWN}) && {WORDS}.includes('W moves')")
    flight.hold("a")
    flight.until("document.querySelector('.task kbd.held')?.textContent === 'Aleft'")
    assert flight.script("getComputedStyle(document.querySelector('.task kbd.held')).visibility") == "visible"
    flight.release("a")
    flight.pad_axes(0.0, 0.0, 0.5, 0.0)
    flight.until(f"{DRAWN} && {WORDS}.includes('L stick ↑ moves')")
    flight.pad_axes(0.0, 0.0, 0.0, 0.0)
    flight.press("a")
    flight.hold("a")
    flight.until(f"!({DRAWN}) && {WORDS}.includes('W moves')")
    flight.release("a")


def test_tutorial_names_another_mode_and_returns_from_it(open_page: OpenPage) -> None:
    flight = open_page().from_the_start()
    flight.until(f"{STEP} === '1 of 6'")
    flight.press("[", "Enter")
    flight.until("frame.mode === 'ORB UNL'")
    flight.until("document.querySelector('.task .elsewhere').textContent.startsWith('The mode is ORB UNL')")
    assert_tidy(flight)
    assert flight.script(CLASHES) == []
    flight.press_key("Enter END EFF")
    flight.until("frame.mode === 'END EFF' && !document.querySelector('.task .elsewhere').checkVisibility()")


@pytest.mark.long
@pytest.mark.parametrize(("width", "height"), [*SIZES, *NARROW])
@pytest.mark.parametrize("pad", [False, True])
def test_tutorial_card_covers_no_needed_group_and_is_readable(
    open_page: OpenPage, width: int, height: int, pad: bool
) -> None:
    flight = open_page(width, height, pad=pad).from_the_start()
    flight.until(OPEN)
    for step in range(1, 7):
        flight.until(f"{STEP} === '{step} of 6'")
        if pad:
            flight.pad_axes(0.0, 0.0, 0.5, 0.0)
            flight.until(DRAWN)
            flight.pad_axes(0.0, 0.0, 0.0, 0.0)
        assert_tidy(flight)
        assert flight.script(CLASHES) == []
        assert_readable(flight, ".task", least=8)
        flight.press_key("Skip step")
    flight.until(f"{STEP} === '0 of 6 done, 6 skipped' && {TITLE} === 'Not complete yet'")
    assert flight.script("document.querySelectorAll('.task .marks .done').length") == 0
    assert flight.script(CLASHES) == []
    flight.press_key("Back")
    flight.until(f"{STEP} === '6 of 6'")


def _toggle_rate(flight: Flight, to: str) -> None:
    flight.pad_buttons(SOUTH)
    flight.until(f"frame.rate === '{to}'")
    flight.pad_buttons()


def _align(flight: Flight) -> None:
    """Align the end effector with the pin. The step ends only with centred sticks."""
    flown, step = -2, "3 of 6"
    for _ in range(MOST_TRIES):
        frame = flight.until(f"frame.display.stick_seq > {flown} && {AT_REST}")
        (aside,) = [each.value for each in frame.work.conditions if each.name == "pin off axis"]
        if _failed_conditions(frame) <= {"pin depth"}:
            step = "4 of 6"  # the sticks are centred
            flight.until(f"{STEP} === '{step}'")
            if aside < MIDDLE:
                break
        flown = frame.display.stick_seq
        aft, starboard = frame.display.actual.position[0] - PIN_X, frame.display.actual.position[1]
        if abs(starboard) > 0.025:
            side = 1 if starboard > 0.0 else -1
            flight.pad_axes(-side, 0.0, 0.0, 0.0)
            flight.until(f"frame.display.actual.position[1] * {side} < 0.02")
            assert flight.script(STEP) == step
            flight.pad_axes(0.0, 0.0, 0.0, 0.0)
        else:
            flight.pad_buttons(L_TRIGGER if aft < 0.0 else R_TRIGGER)
            side = 1 if aft > 0.0 else -1
            flight.until(f"(frame.display.actual.position[0] - {PIN_X}) * {side} < 0.02")
            assert flight.script(STEP) == step
            flight.pad_buttons()
    flight.until(f"{STEP} === '4 of 6'")


def _close_in(flight: Flight) -> None:
    """Move towards the pin, at first fast, until all conditions hold and the arm is at rest."""
    flown = -2
    for _ in range(MOST_TRIES):
        frame = flight.until(f"frame.display.stick_seq > {flown} && {AT_REST}")
        if not _failed_conditions(frame):
            break
        flown = frame.display.stick_seq
        (depth,) = [each.value for each in frame.work.conditions if each.name == "pin depth"]
        assert depth < 0.1 or flight.script(STEP) == "4 of 6"
        if depth > FAR:
            away, there = -1.0, f"{DEPTH} < {FAR}"
            _toggle_rate(flight, "coarse")
        else:
            away, there = (-1.0, f"{DEPTH} < {3 * INCH}") if depth > 0.0 else (1.0, f"{DEPTH} > {0.5 * INCH}")
            if frame.rate != "vernier":
                _toggle_rate(flight, "vernier")
        flight.pad_axes(0.0, away, 0.0, 0.0)
        flight.until(f"{there} || frame.work.arm_inhibit", LATCHES_MS)
        flight.pad_axes(0.0, 0.0, 0.0, 0.0)


def _failed_conditions(frame: Frame) -> set[str]:
    return {each.name for each in frame.work.conditions if not each.holds}


def _height(flight: Flight) -> float:
    """Return the height at which the payload is drawn, in the scene [m]."""
    (place,) = [body["at"] for body in flight.script("window.__aftdeck.bodies") if body["name"] == "payload"]
    return float(place[2])
