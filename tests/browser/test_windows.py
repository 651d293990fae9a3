"""Flying with the focus in a second window: its keys are the flier's, and whoever loses the focus lets go."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page

from tests.browser.flight import WAIT_MS, Flight
from tests.browser.test_cameras import shows

pytestmark = [pytest.mark.browser, pytest.mark.slow]

FORWARD = "frame.translation[0] > 0.9"
AT_ZERO = "frame.translation.every((value) => value === 0)"
HANDLES = "document.querySelector('.who').textContent === 'Keys fly here too'"


@pytest.fixture
def second(flight: Flight) -> Flight:
    """A window of MON 2, opened from the page that flies, once its keys are taken."""
    with flight.page.expect_popup() as opened:
        flight.page.locator(".monitor").nth(1).get_by_role("button", name="Own window").click()
    page: Page = opened.value
    page.set_default_timeout(WAIT_MS)
    second = Flight(page)
    second.until(HANDLES)
    return second


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
    second.until(f"!({HANDLES})")
    second.press("1")
    second.until(shows(0, "A"))
    flight.page.go_back()
    flight.until("frame && document.querySelector('.who').textContent.startsWith('You fly')")
    second.until(HANDLES)
    second.hold("w")
    flight.until(FORWARD)
    second.release("w")
