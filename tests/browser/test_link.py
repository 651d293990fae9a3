"""The connection of page and station: lost and restored, and a page that is blocked."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page, WebSocketRoute

from tests.browser.flight import FLIES, WAIT_MS, Flight

pytestmark = [pytest.mark.browser, pytest.mark.slow]


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    """An empty page."""
    page = browser.new_page(viewport={"width": 1280, "height": 720})
    page.set_default_timeout(WAIT_MS)
    yield page
    page.close()


def test_reconnected_page_has_zero_sticks_and_position_hold(page: Page, station: str) -> None:
    connections: list[WebSocketRoute] = []
    cut = False

    def connect(socket: WebSocketRoute) -> None:
        connections.append(socket)
        if cut:
            socket.close()
        else:
            socket.connect_to_server()

    page.route_web_socket("**/ws", connect)
    page.goto(f"{station}?quality=low")
    flight = Flight(page).from_the_start()
    flight.hold("w")
    flight.until("frame.translation[0] === 1")
    flight.press("h")
    flight.until("frame.rate_hold")
    cut = True
    connections[-1].close()
    page.get_by_text("No connection").wait_for()
    flight.until_lit("LINK")
    cut = False
    flight.until(FLIES)
    flight.until("!document.body.classList.contains('stale')")
    flight.until("frame.translation[0] === 0 && frame.position_hold && !frame.rate_hold")


STALL = "() => { const begun = performance.now(); while (performance.now() - begun < 2300); }"
"""Blocks the page for longer than LOST_MS of `web/src/page/operator.ts`, 2 s."""


def test_key_held_while_the_page_was_blocked_does_not_fly(page: Page, station: str) -> None:
    page.goto(f"{station}?quality=low")
    flight = Flight(page).from_the_start()
    flight.hold("w")
    flight.until("frame.translation[0] === 1")
    flight.script(STALL)
    flight.until("frame.translation[0] === 0 && frame.position_hold")
    blocked_until = flight.frame().time_s
    assert flight.until(f"frame.time_s > {blocked_until + 0.5}").translation[0] == 0.0
    flight.release("w")
    flight.hold("w")
    flight.until("frame.translation[0] === 1")
    flight.release("w")
