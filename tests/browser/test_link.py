"""The connection: refused, lost, and found again."""

from __future__ import annotations

import json
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page, WebSocketRoute

from aftdeck.station.messages.kinds import PROTOCOL
from tests.browser.flight import WAIT_MS, Flight

pytestmark = pytest.mark.browser


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    """An empty page."""
    page = browser.new_page(viewport={"width": 1280, "height": 720})
    page.set_default_timeout(WAIT_MS)
    yield page
    page.close()


def test_a_station_that_refuses_the_page_is_quoted(page: Page, station: str) -> None:
    sentence = "This station speaks protocol 2; the page speaks 1. Reload the page."
    answer(page, {"type": "refused", "seq": -1, "text": sentence})
    page.goto(station)
    page.get_by_role("alert").get_by_text(sentence).wait_for()


def test_a_station_of_another_protocol_is_not_flown(page: Page, station: str) -> None:
    answer(page, {"type": "welcome", "protocol": 99})
    page.goto(station)
    page.get_by_text(f"This page speaks protocol {PROTOCOL}, the station speaks 99: reload the page.").wait_for()


def test_a_message_that_the_page_does_not_know_is_not_passed_over(page: Page, station: str) -> None:
    answer(page, {"type": "rumour"})
    page.goto(station)
    page.get_by_role("alert").get_by_text("rumour").wait_for()


def test_a_lost_connection_shows_and_comes_back_with_the_sticks_at_zero(page: Page, station: str) -> None:
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
    flight.until("document.querySelector('.who').textContent.startsWith('You fly')")
    flight.until("!document.body.classList.contains('stale')")
    flight.until("frame.translation[0] === 0 && frame.position_hold && !frame.rate_hold")


STALL = "() => { const begun = performance.now(); while (performance.now() - begun < 3000); }"


@pytest.mark.slow
def test_a_page_that_stood_still_flies_no_key_that_was_held_meanwhile(page: Page, station: str) -> None:
    page.goto(f"{station}?quality=low")
    flight = Flight(page).from_the_start()
    flight.hold("w")
    flight.until("frame.translation[0] === 1")
    flight.script(STALL)
    flight.until("frame.translation[0] === 0 && frame.position_hold")
    stood = flight.frame().time_s
    assert flight.until(f"frame.time_s > {stood + 2.0}").translation[0] == 0.0
    flight.release("w")
    flight.hold("w")
    flight.until("frame.translation[0] === 1")
    flight.release("w")


def answer(page: Page, message: dict[str, object]) -> None:
    """Lets the page's socket answer every message with this one."""

    def connect(socket: WebSocketRoute) -> None:
        socket.on_message(lambda _: socket.send(json.dumps(message)))

    page.route_web_socket("**/ws", connect)
