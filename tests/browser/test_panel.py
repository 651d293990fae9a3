"""The operator's panel with a payload in the grasp: every text can be read, and Tab goes to everything."""

from __future__ import annotations

import pytest

from tests.browser.conftest import SIZES, OpenPage
from tests.browser.flight import Flight
from tests.browser.looks import assert_readable, assert_tidy, collisions

pytestmark = [pytest.mark.browser, pytest.mark.slow]

SCENARIO = "srms-berth"

SHEETS = {"Key map": "?", "PDRS control": "\\", "Controllers": ""}
"""Sheets by their names, and the key that opens each; the last has a button."""

UNREACHED = """() => {
    const visited = new Set(window.visited);
    const within = document.querySelector('dialog:modal') ?? document.body;
    return [...within.querySelectorAll('button, a[href], input, select, [role=slider]')]
        .filter((each) => each.checkVisibility({ visibilityProperty: true }) && !each.disabled && !visited.has(each))
        .map((each) => each.getAttribute('aria-label') || each.textContent || each.title);
}"""
"""What can be operated and had not been in focus, by name."""


def resized(flight: Flight, width: int, height: int) -> None:
    """Gives the page another size."""
    flight.page.set_viewport_size({"width": width, "height": height})
    flight.until(f"innerWidth === {width} && innerHeight === {height}")
    drawn_anew(flight)


def drawn_anew(flight: Flight) -> None:
    """Waits until figures and legends have been written again."""
    tick, count = flight.frame().tick, flight.script("window.__aftdeck.frames")
    flight.until(f"frame.tick > {tick + 10} && window.__aftdeck.frames > {count + 3}")


def assert_all_in_reach(flight: Flight) -> None:
    """Tab goes to everything that is there to be operated."""
    flight.script(
        "(() => { document.activeElement?.blur(); window.watching?.abort(); window.watching = new AbortController();"
        "const visited = window.visited = [], { signal } = window.watching;"
        "document.addEventListener('focusin', ({ target }) => visited.push(target), { signal }); })()"
    )
    for _ in range(20):
        flight.press(*["Tab"] * 20)
        if flight.script("new Set(window.visited).size < window.visited.length"):
            break  # it is round
    assert flight.script(UNREACHED) == []


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_the_loaded_desk_is_tidy_and_readable_in_every_mode(flight: Flight, width: int, height: int) -> None:
    resized(flight, width, height)
    for mode in ("ORB LD", "SINGLE", "OPR CMD", "TEST"):
        flight.enter(mode)
        drawn_anew(flight)
        assert_tidy(flight)
        assert_readable(flight)


def test_every_sheet_fits_and_can_be_read_at_every_size(flight: Flight) -> None:
    for name, key in SHEETS.items():
        if key:
            flight.press(key)
        else:
            flight.page.get_by_role("button", name=name, exact=True).click()
        sheet = flight.page.get_by_role("dialog", name=name)
        sheet.wait_for(state="visible")
        for width, height in SIZES:
            resized(flight, width, height)
            fits = (
                "(s) => { const p = s.getBoundingClientRect(); return p.left >= 0 && p.top >= 0"
                " && p.right <= innerWidth && p.bottom <= innerHeight"
                " && s.scrollHeight <= s.clientHeight + 1 && s.scrollWidth <= s.clientWidth + 1; }"
            )
            assert sheet.evaluate(fits), f"{name} at {width}x{height}"
            assert collisions(flight, "dialog[open]") == []
            assert_readable(flight, "dialog[open]", least=40)
        flight.press("Escape")
        sheet.wait_for(state="hidden")


def test_everything_is_in_reach_of_tab(flight: Flight) -> None:
    for mode in ("SINGLE", "OPR CMD", "ORB LD"):
        flight.enter(mode)
        drawn_anew(flight)
        assert_all_in_reach(flight)


def test_everything_in_the_sheets_is_in_reach_of_tab(flight: Flight) -> None:
    flight.press("\\")
    assert_all_in_reach(flight)
    flight.press("Escape", "?")
    assert_all_in_reach(flight)
    flight.press("Escape")
    flight.page.get_by_role("button", name="Controllers", exact=True).click()
    assert_all_in_reach(flight)


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_a_refusal_and_the_task_can_be_read_whole_in_the_log(open_page: OpenPage, width: int, height: int) -> None:
    cut_off = """[...document.querySelectorAll('LINES')]
        .filter((line) => line.scrollWidth > line.clientWidth + 1 || line.scrollHeight > line.clientHeight + 1)
        .map((line) => line.textContent)"""
    flight = open_page(width, height).from_the_start()
    flight.hold("g")
    flight.until("document.querySelector('.log li.whole').textContent.includes('CAPTURE refused: ')")
    flight.release("g")
    assert flight.script(cut_off.replace("LINES", ".events > .log li.whole > span")) == []
    flight.press_key("more")
    flight.until("document.querySelector('.log.wrapped').textContent.includes('draw the arm clear.')")
    assert flight.script(cut_off.replace("LINES", ".log.wrapped span")) == []
    pressed = flight.script("""[...document.querySelectorAll('.desk button:not(:disabled)')].filter((key) => {
        const { left, right, top, bottom } = key.getBoundingClientRect();
        const at = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
        return right > left && !key.contains(at);
    }).map((key) => key.textContent)""")
    assert pressed == []  # nothing lies over a key
