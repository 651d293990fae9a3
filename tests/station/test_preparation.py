"""Start of the station: the server answers before the session is made, and reports progress and errors."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from websockets.exceptions import ConnectionClosed

from aftdeck.errors import ScenarioError
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.warm import warm_up
from aftdeck.station.messages import from_page, kinds, to_page
from aftdeck.station.messages.frame import Frame
from aftdeck.station.messages.welcome import Welcome
from aftdeck.station.server.app import make_app
from aftdeck.station.server.page import MAX_PAGES, TOO_MANY_PAGES
from tests.loaded import scenario
from tests.station.pages import Page, Server, serving, until
from tests.station.slow import Slow
from tests.waits import WAIT_S

HELLO = from_page.Hello(kinds.PROTOCOL)


@pytest.fixture
def slow() -> Iterator[Slow]:
    warm_up(scenario())  # compiling the laws may take longer than a page waits in a test
    slow = Slow()
    yield slow
    slow.go.set()


def served(slow: Slow) -> Iterator[Server]:
    with serving(make_app(slow.coming, failed=slow.failed.set)) as port:
        yield Server(port)


@pytest.fixture
def server(slow: Slow) -> Iterator[Server]:
    yield from served(slow)


def wait_for_progress(page: Page) -> None:
    page.send(HELLO)
    page.wait_for(to_page.Preparing, lambda message: message.text == "Loading.")


def test_page_is_served_before_the_session_is_made(server: Server) -> None:
    assert server.get("/health") == (200, "preparing\n")
    status, text = server.get("/")
    assert status == 200
    assert "<title>Aftdeck</title>" in text


def test_waiting_page_gets_progress_and_then_its_welcome_and_frames(slow: Slow, server: Server) -> None:
    with server.unannounced() as page:
        wait_for_progress(page)
        slow.go.set()
        assert page.wait_for(Welcome).scenario == "first-flight"
        assert page.wait_for(to_page.Role).flying
        page.wait_for(Frame)
    assert server.get("/health") == (200, "flying\n")


def test_page_that_leaves_while_it_waits_does_not_take_control(slow: Slow, server: Server) -> None:
    with server.unannounced() as left_page:
        wait_for_progress(left_page)
    slow.go.set()
    until(lambda: server.get("/health") == (200, "flying\n"), "the session starts")
    with server.page() as page:
        page.wait_for(to_page.Role, lambda role: role.flying and role.watchers == 0)


def test_page_of_another_protocol_is_rejected_during_preparation(server: Server) -> None:
    with server.unannounced() as page:
        page.send(from_page.Hello(99))
        assert re.search(rf"\b99\b.*\b{kinds.PROTOCOL}\b", page.rejection())


def test_no_more_pages_may_wait_than_may_be_connected(server: Server) -> None:
    pages = [server.unannounced() for _ in range(MAX_PAGES + 1)]
    try:
        for page in pages[:-1]:
            wait_for_progress(page.__enter__())
        late = pages[-1].__enter__()
        late.send(HELLO)
        assert late.rejection() == TOO_MANY_PAGES
    finally:
        for page in pages:
            page.__exit__(None, None, None)


@pytest.mark.parametrize(
    ("error", "part"),
    [
        (ScenarioError(["deploy.toml:14: phase[1].rate: wrong"]), "deploy.toml:14: phase[1].rate: wrong"),
        (ZeroDivisionError("by zero"), "ZeroDivisionError('by zero')"),
    ],
)
def test_failed_preparation_is_reported_to_every_page(error: Exception, part: str) -> None:
    slow = Slow(error)
    for server in served(slow):
        with server.unannounced() as early, server.unannounced() as late:
            wait_for_progress(early)
            slow.go.set()
            assert slow.failed.wait(WAIT_S)
            late.send(HELLO)
            for page in (early, late):
                assert part in page.rejection()
                with pytest.raises(ConnectionClosed):
                    page.receive()
        assert server.get("/health") == (200, "failed\n")


def test_scenario_that_cannot_be_loaded_ends_the_program_with_its_problems(tmp_path: Path) -> None:
    text = load_scenario("first-flight").text.replace('arm = "srms"', 'arm = "no such arm"')
    (tmp_path / "own.toml").write_text(text, encoding="utf-8")
    command = [sys.executable, "-m", "aftdeck", "fly", str(tmp_path / "own.toml"), "--no-browser", "--port", "0"]
    done = subprocess.run(command, check=False, capture_output=True, text=True, timeout=300)
    assert done.returncode == 2
    assert "'no such arm'" in done.stderr
    assert "Traceback" not in done.stderr
