"""The page while the station is being prepared."""

from __future__ import annotations

import pytest
from playwright.sync_api import Browser, Page

from aftdeck.errors import ScenarioError
from aftdeck.station.server.app import make_app
from tests.browser.flight import WAIT_MS
from tests.station.pages import serving
from tests.station.slow import Slow

pytestmark = pytest.mark.browser


def opened(browser: Browser, port: int) -> Page:
    page = browser.new_page(viewport={"width": 1280, "height": 720})
    page.set_default_timeout(WAIT_MS)
    page.goto(f"http://127.0.0.1:{port}/?quality=low")
    return page


def test_page_shows_the_progress_and_then_the_station(browser: Browser) -> None:
    slow = Slow()
    with serving(make_app(slow.coming)) as port:
        page = opened(browser, port)
        page.get_by_text("Loading.").wait_for()
        slow.go.set()
        page.locator(".rail .who.flying").wait_for()
        page.close()


def test_page_shows_why_the_station_cannot_start(browser: Browser) -> None:
    slow = Slow(ScenarioError(["deploy.toml:14: phase[1].rate: wrong"]))
    with serving(make_app(slow.coming)) as port:
        page = opened(browser, port)
        page.get_by_text("Loading.").wait_for()
        slow.go.set()
        page.get_by_role("alert").get_by_text("deploy.toml:14: phase[1].rate: wrong").wait_for()
        page.close()
