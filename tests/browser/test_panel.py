"""The operator's panel with a captured payload: every text is readable, and Tab reaches every control."""

from __future__ import annotations

import pytest

from tests.browser.conftest import SIZES
from tests.browser.flight import Flight
from tests.browser.layout_checks import assert_readable, assert_tidy, collisions

pytestmark = [pytest.mark.browser, pytest.mark.slow]

SCENARIO = "srms-berth"

SHEETS = {"Key map": "?", "PDRS control": "\\", "Controllers": ""}
"""Key that opens each sheet; empty if a button opens the sheet."""

UNREACHED = """() => {
    const visited = new Set(window.visited);
    const within = document.querySelector('dialog:modal') ?? document.body;
    return [...within.querySelectorAll('button, a[href], input, select, [role=slider]')]
        .filter((each) => each.tabIndex >= 0) // arrow keys reach the other keys of a row
        .filter((each) => each.checkVisibility({ visibilityProperty: true }) && !each.disabled && !visited.has(each))
        .map((each) => each.getAttribute('aria-label') || each.textContent || each.title);
}"""
"""Names of the controls that Tab has not reached."""


def resized(flight: Flight, width: int, height: int) -> None:
    """Set the size of the page and wait until it is drawn."""
    flight.resize(width, height)
    until_redrawn(flight)


def until_redrawn(flight: Flight) -> None:
    """Wait until read-outs and legends have been updated."""
    tick, count = flight.frame().tick, flight.script("window.__aftdeck.frames")
    flight.until(f"frame.tick > {tick + 10} && window.__aftdeck.frames > {count + 3}")


def assert_all_in_reach(flight: Flight) -> None:
    """Assert that Tab reaches every control."""
    flight.script(
        "(() => { document.activeElement?.blur(); window.watching?.abort(); window.watching = new AbortController();"
        "const visited = window.visited = [], { signal } = window.watching;"
        "document.addEventListener('focusin', ({ target }) => visited.push(target), { signal }); })()"
    )
    for _ in range(20):
        flight.press(*["Tab"] * 20)
        if flight.script("new Set(window.visited).size < window.visited.length"):
            break  # Tab has reached the first control again
    assert flight.script(UNREACHED) == []


def test_loaded_desk_is_tidy_and_readable_in_every_mode_and_size(flight: Flight) -> None:
    for mode in ("ORB LD", "SINGLE", "OPR CMD", "TEST"):
        flight.enter(mode)
        for width, height in SIZES:
            resized(flight, width, height)
            assert_tidy(flight)
            assert_readable(flight)


def test_every_sheet_fits_and_is_readable_at_every_size(flight: Flight) -> None:
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


def test_tab_reaches_every_control_of_the_desk(flight: Flight) -> None:
    for mode in ("SINGLE", "OPR CMD", "ORB LD"):
        flight.enter(mode)
        until_redrawn(flight)
        assert_all_in_reach(flight)


def test_tab_reaches_every_control_of_the_sheets(flight: Flight) -> None:
    flight.press("\\")
    assert_all_in_reach(flight)
    flight.press("Escape", "?")
    assert_all_in_reach(flight)
    flight.press("Escape")
    flight.page.get_by_role("button", name="Controllers", exact=True).click()
    assert_all_in_reach(flight)


def test_rejection_and_task_are_not_cut_off_in_the_log(flight: Flight) -> None:
    cut_off = """[...document.querySelectorAll('LINES')]
        .filter((line) => line.scrollWidth > line.clientWidth + 1 || line.scrollHeight > line.clientHeight + 1)
        .map((line) => line.textContent)"""
    covered = """[...document.querySelectorAll('.desk button:not(:disabled)')].filter((key) => {
        const { left, right, top, bottom } = key.getBoundingClientRect();
        const at = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
        return right > left && !key.contains(at);
    }).map((key) => key.textContent)"""
    flight.hold("g")
    flight.until("document.querySelector('.log li.whole').dataset.kind === 'refused'")
    flight.release("g")
    for width, height in SIZES:
        resized(flight, width, height)
        assert flight.script(cut_off.replace("LINES", ".events > .log li.whole")) == []
        flight.press_key("more")
        flight.until("document.querySelector('.log.wrapped .hint')")
        assert flight.script(cut_off.replace("LINES", ".log.wrapped span")) == []
        assert flight.script(covered) == []
        flight.press_key("less")
