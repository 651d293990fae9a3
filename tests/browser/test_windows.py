"""Secondary windows of a flight: their keys act on their page, strips follow the run, each page has its own windows."""

from __future__ import annotations

import math

import pytest
from playwright.sync_api import Locator, Page

from tests.browser.conftest import SIZES, OpenPage
from tests.browser.flight import FLIES, OBSERVES, WAIT_MS, Flight, shows
from tests.browser.layout_checks import assert_readable, assert_tidy

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.long]

FORWARD = "frame.translation[0] > 0.9"
AT_ZERO = "frame.translation.every((value) => value === 0)"
HANDLES = "document.querySelector('.who').textContent === 'Keys act here too'"


@pytest.fixture
def second(flight: Flight) -> Flight:
    """A window of MON 2 whose keys act on the operator's page."""
    second = open_window(flight, own_window(flight, 1))
    second.until(HANDLES)
    return second


@pytest.fixture
def strips(flight: Flight) -> Flight:
    """A window of the strips whose keys act on the operator's page."""
    strips = open_window(flight, flight.page.get_by_role("button", name="Strips ↗"))
    strips.until(HANDLES)
    return strips


def open_window(flight: Flight, key: Locator) -> Flight:
    """Press a button that opens a window; return the window."""
    with flight.page.expect_popup() as opened:
        key.click()
    page: Page = opened.value
    page.set_default_timeout(WAIT_MS)
    return Flight(page)


def own_window(flight: Flight, monitor: int) -> Locator:
    """Return the button that opens a monitor in a secondary window."""
    return flight.page.locator(".monitor").nth(monitor).get_by_role("button", name="Own window")


def who(words: str) -> str:
    """Return a JavaScript condition: the window shows this text about its page."""
    return f"document.querySelector('.who').textContent === '{words}'"


def row(name: str) -> str:
    """Return a JavaScript expression for the row of a lane or strip."""
    return f"[...document.querySelectorAll('.timeline .row')].find((row) => row.textContent.startsWith('{name}'))"


def tag(strip: str) -> str:
    """Return a JavaScript expression for the value of a strip at the playhead."""
    return f"{row(strip)}?.querySelector('.tag')?.textContent"


def test_keys_of_a_secondary_window_fly_stop_and_brake(flight: Flight, second: Flight) -> None:
    second.hold("w")
    flight.until(FORWARD)
    second.page.get_by_role("button", name="Split").focus()
    split = second.page.locator(".picture").count()
    second.press("Space")  # stops the arm, and does not press the button that has the focus
    flight.until(f"{AT_ZERO} && !document.querySelector('.monitor .split')")
    assert second.page.locator(".picture").count() == split
    second.release("w")
    second.press("b")
    flight.until("frame.brakes")
    second.hold("b")
    flight.until("!frame.brakes")
    second.release("b")


def test_secondary_window_without_focus_zeroes_the_sticks(flight: Flight, second: Flight) -> None:
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


def test_camera_keys_of_a_monitor_window_act_on_its_monitor(flight: Flight, second: Flight) -> None:
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


def test_window_of_a_closed_page_selects_cameras_by_itself(flight: Flight, second: Flight) -> None:
    flight.page.goto("about:blank")
    second.until(who("Its page is closed"))
    second.press("1")
    second.until(shows(0, "A"))
    flight.page.go_back()
    flight.until(FLIES)
    second.until(HANDLES)
    second.hold("w")
    flight.until(FORWARD)
    second.release("w")


def test_strips_follow_the_run_and_end_at_the_values_of_the_page(flight: Flight, strips: Flight) -> None:
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


def test_lanes_of_the_strips_show_mode_and_cameras(flight: Flight, strips: Flight) -> None:
    flight.press("x", "4")
    strips.until(f"{row('MON 2')}?.querySelector('.plot').textContent.endsWith('D')")
    flight.enter("END EFF")
    strips.until(f"{row('Mode')}.querySelector('.plot').textContent.endsWith('END EFF')")


def test_strips_can_be_selected_in_page_units_and_zoomed(flight: Flight, strips: Flight) -> None:
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


def test_restart_clears_the_strips(flight: Flight, strips: Flight) -> None:
    flight.until("frame.time_s > 4")
    flight.from_the_start()
    strips.until("document.querySelector('.position').textContent < '00:04'")
    strips.until(f"frame.time_s < 4 && {row('Clearance')}.querySelector('path.actual').getAttribute('d')")


def test_two_pages_of_one_browser_have_separate_windows(flight: Flight) -> None:
    with flight.page.expect_popup() as opened:  # a copy of the tab, with its session storage
        flight.script("void open(location.href)")
    opened.value.set_default_timeout(WAIT_MS)
    other = Flight(opened.value)
    flight.press("1")
    other.until(OBSERVES)
    other.page.get_by_role("group", name="Camera of MON 1").get_by_role("button", name="C", exact=True).click()
    first, second = open_window(flight, own_window(flight, 0)), open_window(other, own_window(other, 0))
    first.until(f"{shows(0, 'A')} && {HANDLES}")
    second.until(f"{shows(0, 'C')} && {who('Observing')}")
    other.page.reload()
    other.until(OBSERVES)
    other.page.get_by_role("group", name="Camera of MON 1").get_by_role("button", name="D", exact=True).click()
    second.until(shows(0, "D"))
    flight.press("2")
    first.until(shows(0, "B"))
    second.press("4")  # camera keys of this window act on the observer's page
    assert second.script(shows(0, "D"))
    other.page.close()
    second.until(who("Its page is closed"))
    first.until(HANDLES)
    assert first.script(shows(0, "B"))


def test_blocked_window_is_reported(open_page: OpenPage) -> None:
    flight = open_page(prepare=lambda page: page.add_init_script("window.open = () => null"))
    flight.until(FLIES)
    with flight.logs("page"):
        own_window(flight, 0).click()
