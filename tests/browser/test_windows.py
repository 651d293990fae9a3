"""Second windows of a flight: their keys are the flier's, strips run with it, and each page has windows of its own."""

from __future__ import annotations

import math

import pytest
from playwright.sync_api import Locator, Page

from tests.browser.conftest import SIZES, OpenPage
from tests.browser.flight import WAIT_MS, Flight, shows
from tests.browser.looks import assert_readable, assert_tidy

pytestmark = [pytest.mark.browser, pytest.mark.slow]

FORWARD = "frame.translation[0] > 0.9"
AT_ZERO = "frame.translation.every((value) => value === 0)"
HANDLES = "document.querySelector('.who').textContent === 'Keys act here too'"


@pytest.fixture
def second(flight: Flight) -> Flight:
    """A window of MON 2, opened from the page that flies, once its keys are taken."""
    second = torn_off(flight, own_window(flight, 1))
    second.until(HANDLES)
    return second


@pytest.fixture
def strips(flight: Flight) -> Flight:
    """A window of the strips, opened from the page that flies, once its keys are taken."""
    strips = torn_off(flight, flight.page.get_by_role("button", name="Strips ↗"))
    strips.until(HANDLES)
    return strips


def torn_off(flight: Flight, key: Locator) -> Flight:
    """The window that a key opens."""
    with flight.page.expect_popup() as opened:
        key.click()
    page: Page = opened.value
    page.set_default_timeout(WAIT_MS)
    return Flight(page)


def own_window(flight: Flight, monitor: int) -> Locator:
    """The key under a monitor that opens a window of it."""
    return flight.page.locator(".monitor").nth(monitor).get_by_role("button", name="Own window")


def who(words: str) -> str:
    """What the window says of its page, as a condition."""
    return f"document.querySelector('.who').textContent === '{words}'"


def row(name: str) -> str:
    """A lane's or a strip's row, in JavaScript."""
    return f"[...document.querySelectorAll('.timeline .row')].find((row) => row.textContent.startsWith('{name}'))"


def tag(strip: str) -> str:
    """A strip's value at the playhead, in JavaScript."""
    return f"{row(strip)}?.querySelector('.tag')?.textContent"


def test_sticks_stop_and_brakes_answer_to_keys_of_the_second_window(flight: Flight, second: Flight) -> None:
    second.hold("w")
    flight.until(FORWARD)
    second.page.get_by_role("button", name="Split").focus()
    split = second.page.locator(".picture").count()
    second.press("Space")  # stops, and presses no button
    flight.until(f"{AT_ZERO} && !document.querySelector('.monitor .split')")
    assert second.page.locator(".picture").count() == split
    second.release("w")
    second.press("b")
    flight.until("frame.brakes")
    second.hold("b")
    flight.until("!frame.brakes")
    second.release("b")


def test_sticks_go_to_zero_as_the_second_window_loses_the_focus_or_closes(flight: Flight, second: Flight) -> None:
    second.hold("w")
    flight.until(FORWARD)
    second.script("window.dispatchEvent(new Event('blur'))")
    flight.until(AT_ZERO)
    second.release("w")
    second.hold("w")
    flight.until(FORWARD)
    second.page.close()
    flight.until(AT_ZERO)
    flight.hold("w")
    flight.until(FORWARD)
    flight.release("w")
    flight.until(AT_ZERO)


def test_camera_keys_of_the_second_window_act_on_its_monitor(flight: Flight, second: Flight) -> None:
    flight.page.locator(".monitor").nth(0).locator(".picture").click()
    second.press("4")
    flight.until(shows(1, "D"))
    second.until(shows(0, "D"))
    before = flight.frame().views
    second.hold("ArrowLeft")
    flight.until(f"frame.views[3][0] !== {before[3][0]!r}")
    second.release("ArrowLeft")
    after = flight.frame().views
    assert [i for i, view in enumerate(after) if view != before[i]] == [3]


def test_a_window_whose_page_is_gone_chooses_cameras_by_itself_until_it_is_back(flight: Flight, second: Flight) -> None:
    flight.page.goto("about:blank")
    second.until(who("Its page is closed"))
    second.press("1")
    second.until(shows(0, "A"))
    flight.page.go_back()
    flight.until("frame && document.querySelector('.who').textContent.startsWith('You fly')")
    second.until(HANDLES)
    second.hold("w")
    flight.until(FORWARD)
    second.release("w")


def test_strips_run_with_the_flight_and_end_at_the_page_s_own_values(flight: Flight, strips: Flight) -> None:
    strips.hold("w")
    moving = flight.until(FORWARD)
    flight.until(f"frame.time_s > {moving.time_s + 2}")
    strips.release("w")
    still = flight.until("frame.rates.every((rate) => rate === 0)")
    assert still.work.nearest is not None
    clearance = f"{still.work.nearest.clearance / 0.0254:.1f} in"
    strips.until(f"frame.tick > {still.tick} && {tag('Clearance')} === '{clearance}' && {tag('Joint rate')} === '0.00'")
    assert flight.page.locator(".gap-value").inner_text() == f"{still.work.nearest.clearance / 0.0254:.0f}"
    places = strips.script(f"""(() => {{
        const right = (node) => node.getBoundingClientRect().right;
        const strip = {row("Clearance")};
        const [plot, curve] = [strip.querySelector('.plot'), strip.querySelector('path.actual')];
        return [right(plot), right(curve), strip.querySelectorAll('path.caution, path.warning').length];
    }})()""")
    assert places[1] == pytest.approx(places[0], abs=3.0)
    assert places[2] == 2
    moved = strips.script(f"{row('POR rate')}.querySelector('path.actual').getAttribute('d')")
    assert moved.count("L") > 20
    clock = "document.querySelector('.position').textContent"
    before = strips.script(clock)
    strips.until(f"{clock} > '{before}'")


def test_lanes_of_the_strips_tell_mode_and_cameras(flight: Flight, strips: Flight) -> None:
    flight.press("x", "4")
    strips.until(f"{row('MON 2')}?.querySelector('.plot').textContent.endsWith('D')")
    flight.enter("END EFF")
    strips.until(f"{row('Mode')}.querySelector('.plot').textContent.endsWith('END EFF')")


def test_strips_are_chosen_and_stand_in_the_page_s_units_over_as_much_time_as_asked(
    flight: Flight, strips: Flight
) -> None:
    page = strips.page
    page.get_by_role("button", name="Strips", exact=True).click()
    page.get_by_role("group", name="Strips").get_by_role("button", name="Elbow", exact=True).click()
    page.get_by_role("button", name="Strips", exact=True).click()
    elbow = math.degrees(flight.frame().angles[2])
    strips.until(f"{tag('Elbow')} === '−{abs(elbow):.1f}°'")
    flight.page.get_by_role("button", name="ft · in").click()
    strips.until(f"{tag('Clearance')}.endsWith(' cm')")
    page.get_by_role("button", name="Closer").click()
    strips.until("document.querySelector('.clock').textContent.endsWith('last 1 min')")
    for width, height in SIZES:
        page.set_viewport_size({"width": width, "height": height})
        strips.until(f"innerWidth === {width} && innerHeight === {height}")
        assert_tidy(strips)
        assert_readable(strips, least=20)


def test_a_restart_begins_the_strips_anew(flight: Flight, strips: Flight) -> None:
    flight.until("frame.time_s > 4")
    flight.from_the_start()
    strips.until("document.querySelector('.position').textContent < '00:04'")
    strips.until(f"frame.time_s < 4 && {row('Clearance')}.querySelector('path.actual').getAttribute('d')")


def test_two_pages_of_one_browser_have_each_its_own_windows(flight: Flight) -> None:
    with flight.page.expect_popup() as opened:  # a copy of the tab, with what the browser keeps for it
        flight.script("void open(location.href)")
    opened.value.set_default_timeout(WAIT_MS)
    other = Flight(opened.value)
    flight.press("1")
    other.until("document.querySelector('.who').textContent.startsWith('You watch')")
    other.page.get_by_role("group", name="Camera of MON 1").get_by_role("button", name="C", exact=True).click()
    first, second = torn_off(flight, own_window(flight, 0)), torn_off(other, own_window(other, 0))
    first.until(f"{shows(0, 'A')} && {HANDLES}")
    second.until(f"{shows(0, 'C')} && {who('Observing')}")
    other.page.reload()
    other.until("document.querySelector('.who').textContent.startsWith('You watch')")
    other.page.get_by_role("group", name="Camera of MON 1").get_by_role("button", name="D", exact=True).click()
    second.until(shows(0, "D"))
    flight.press("2")
    first.until(shows(0, "B"))
    second.press("4")  # nobody's keys: they choose cameras of the page that watches
    assert second.script(shows(0, "D"))
    other.page.close()
    second.until(who("Its page is closed"))
    first.until(HANDLES)
    assert first.script(shows(0, "B"))


def test_a_page_says_that_the_browser_opens_no_window(open_page: OpenPage) -> None:
    flight = open_page(prepare=lambda page: page.add_init_script("window.open = () => null"))
    flight.until("document.querySelector('.who').textContent.startsWith('You fly')")
    own_window(flight, 0).click()
    flight.until_logged("Pop-ups are blocked")
