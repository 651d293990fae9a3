"""Pictures that are not drawn are marked as old in the page, in a secondary window and in a replay."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Page

from tests.browser.conftest import OpenPage
from tests.browser.flight import FLIES, Flight
from tests.station.recordings import playing, record_run

pytestmark = [pytest.mark.browser, pytest.mark.slow]

GRAPHICS = """
    const get = HTMLCanvasElement.prototype.getContext;
    const contexts = new Set();
    let withdrawn = false;
    HTMLCanvasElement.prototype.getContext = function (type, ...rest) {
        if (type === 'webgl2' && withdrawn) return null;
        const context = get.call(this, type, ...rest);
        if (context && type === 'webgl2') contexts.add(context);
        return context;
    };
    window.withdraw = () => {
        withdrawn = true;
        for (const each of contexts) if (!each.isContextLost()) each.getExtension('WEBGL_lose_context').loseContext();
    };
    window.giveBack = () => { withdrawn = false; };
"""
"""Lets a test take all WebGL contexts from a page, as a browser does whose graphics have failed."""

PICTURES = "[...document.querySelectorAll('.picture')].filter((each) => each.checkVisibility())"
OLD = f"{PICTURES}.every((each) => each.classList.contains('is-stale') && !/live|recorded/.test(each.innerText))"
FRESH = f"{PICTURES}.every((each) => !each.classList.contains('is-stale') && /live|recorded/.test(each.innerText))"
SMALL = (640, 480)
"""Window [px] in which a busy machine, too, needs less than 2 s for a full picture; the page gives up a slower one."""
PREPARES = "/Preparing the full picture/.test(document.querySelector('.monitors').innerText)"
CURE = f"{PICTURES}.every((each) => /reload the page/.test(each.innerText))"


def loses_its_pictures_and_has_them_again(page: Flight) -> None:
    """Take the graphics from a page, then give them back; check what its pictures say."""
    page.until(FRESH)
    page.script("window.withdraw()")
    page.until(f"{OLD} && {CURE}")
    page.script("window.giveBack()")
    page.until(FRESH)


def with_graphics(page: Page) -> None:
    """Prepare a page so that a test can take its graphics."""
    page.add_init_script(GRAPHICS)


def test_lost_pictures_are_old_in_the_page_and_its_window(open_page: OpenPage) -> None:
    flight = open_page(prepare=with_graphics).from_the_start()
    flight.until(FLIES)
    flight.hold("w")
    flight.until("frame.translation[0] === 1")
    flight.script("window.withdraw()")
    flight.until(f"{OLD} && {CURE} && document.querySelector('.lamp.caution')?.textContent.includes('CAMERA')")
    flight.until("!document.body.classList.contains('stale')")  # the numbers go on
    flight.release("w")
    flight.script("window.giveBack()")
    flight.until(f"{FRESH} && frame.translation[0] === 0")
    window = open_page(prepare=with_graphics)
    window.page.goto(f"{window.page.url}&view=mon1")
    loses_its_pictures_and_has_them_again(window)


def test_full_profile_is_prepared_again_when_its_graphics_are_lost(open_page: OpenPage) -> None:
    flight = open_page(*SMALL, prepare=with_graphics)
    flight.page.goto(flight.page.url.replace("quality=low", "quality=full"))
    flight.until(f"{PREPARES} && {PICTURES}.length > 0")
    flight.script("window.withdraw()")
    flight.until(f"{OLD} && !{PREPARES}")
    flight.script("window.giveBack()")
    flight.until(f"{PREPARES} && (window.low = document.querySelector('canvas.scene'))")
    flight.until(f"document.querySelector('canvas.scene') !== window.low && !{PREPARES} && {FRESH}")


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Address of a recording's server."""
    path: Path = tmp_path_factory.mktemp("lost") / "flight.mcap"
    record_run(path, 100)
    with playing(path) as address:
        yield address


def test_lost_pictures_are_old_in_a_replay_that_stands_still(recorded: str, open_page: OpenPage) -> None:
    replay = open_page(prepare=with_graphics)
    replay.page.goto(f"{recorded}?quality=low")
    replay.until("frame.tick >= 0")
    loses_its_pictures_and_has_them_again(replay)
