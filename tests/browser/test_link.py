"""The connection of page and station: rejected, lost, and restored."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page, WebSocketRoute

from aftdeck.station.messages.kinds import PROTOCOL
from tests.browser.flight import FLIES, WAIT_MS, Flight

pytestmark = pytest.mark.browser


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    """An empty page."""
    page = browser.new_page(viewport={"width": 1280, "height": 720})
    page.set_default_timeout(WAIT_MS)
    yield page
    page.close()


def test_rejection_by_the_station_is_displayed(page: Page, station: str) -> None:
    sentence = "This station speaks protocol 2; the page speaks 1. Reload the page."
    answer(page, {"type": "refused", "seq": -1, "text": sentence})
    page.goto(station)
    page.get_by_role("alert").get_by_text(sentence).wait_for()


def test_station_of_another_protocol_is_rejected(page: Page, station: str) -> None:
    answer(page, {"type": "welcome", "protocol": 99})
    page.goto(station)
    page.get_by_role("alert").get_by_text(re.compile(rf"\b{PROTOCOL}\b.*\b99\b")).wait_for()


def test_unknown_message_is_reported_by_its_type(page: Page, station: str) -> None:
    answer(page, {"type": "rumour"})
    page.goto(station)
    page.get_by_role("alert").get_by_text("rumour").wait_for()


@pytest.mark.slow
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


STALL = "() => { const begun = performance.now(); while (performance.now() - begun < 3000); }"


@pytest.mark.slow
def test_key_held_while_the_page_was_blocked_does_not_fly(page: Page, station: str) -> None:
    page.goto(f"{station}?quality=low")
    flight = Flight(page).from_the_start()
    flight.hold("w")
    flight.until("frame.translation[0] === 1")
    flight.script(STALL)
    flight.until("frame.translation[0] === 0 && frame.position_hold")
    blocked_until = flight.frame().time_s
    assert flight.until(f"frame.time_s > {blocked_until + 2.0}").translation[0] == 0.0
    flight.release("w")
    flight.hold("w")
    flight.until("frame.translation[0] === 1")
    flight.release("w")


def answer(page: Page, message: dict[str, object]) -> None:
    """Let the page's socket answer every message with `message`."""

    def connect(socket: WebSocketRoute) -> None:
        socket.on_message(lambda _: socket.send(json.dumps(message)))

    page.route_web_socket("**/ws", connect)
