"""A station flown in a real browser: the server as a user starts it, Chromium, and a page."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from queue import Empty, Queue
from threading import Thread
from urllib.request import urlopen

import pytest
from playwright.sync_api import Browser, ConsoleMessage, Page, sync_playwright

from tests.browser.flight import WAIT_MS, Flight
from tests.browser.programs import running

START_S = 120.0
"""The longest that a station may take to say its address, and the browser to start [s]."""

COMPILED_S = 300.0
"""The longest that it may take to answer after that, where the laws are compiled for the first time [s]."""

# As benchmarks.page: the scene by Mesa's GL, the page put together without it.
FLAGS = [
    "--use-angle=gl-egl",
    "--disable-gpu-compositing",
    "--ignore-gpu-blocklist",
    "--no-sandbox",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]

PAD = """
    window.testPad = {
        id: 'Test pad', index: 0, connected: true, mapping: 'standard', timestamp: 0, axes: [0, 0, 0, 0],
        buttons: Array.from({ length: 17 }, () => ({ pressed: false, touched: false, value: 0 })),
    };
    navigator.getGamepads = () => [window.testPad];
"""
"""A pad whose axes a test sets; null takes it away."""

SIZES = [(1280, 720), (1440, 900), (1920, 1080)]
"""Windows that the page shall fit [px]."""
NARROW = [(960, 900), (1024, 768), (768, 1024)]
"""Narrow ones that are flown from: half a laptop's, an old screen, a tablet upright [px]."""

OpenPage = Callable[..., Flight]


@pytest.fixture(scope="module")
def station(request: pytest.FixtureRequest) -> Iterator[str]:
    """Address of a running `aftdeck fly`; a module of tests names its scenario in SCENARIO."""
    with flown(getattr(request.module, "SCENARIO", "first-flight")) as address:
        yield address


@contextmanager
def flown(*options: str) -> Iterator[str]:
    """Address of an `aftdeck fly` with these options, which runs until this is left."""
    command = [sys.executable, "-m", "aftdeck.cli", "fly", *options, "--no-browser", "--port", "0"]
    with running(command, stdout=subprocess.PIPE, text=True) as process:
        address = _address(process)
        with urlopen(f"{address}health", timeout=COMPILED_S) as answer:  # the socket listens before the server runs
            assert answer.status == 200
        yield address


def _address(process: subprocess.Popen[str]) -> str:
    lines: Queue[str] = Queue()
    output = process.stdout
    assert output is not None

    def read() -> None:
        for line in output:
            lines.put(line)

    Thread(target=read, daemon=True).start()
    try:
        first = lines.get(timeout=START_S)
    except Empty:
        pytest.fail(f"`aftdeck fly` said nothing within {START_S:g} s.")
    assert first.startswith("Aftdeck station: http://127.0.0.1:"), first
    return first.removeprefix("Aftdeck station: ").strip()


@pytest.fixture(scope="session")
def browser(chromium: Path) -> Iterator[Browser]:
    """A Chromium that draws with the processor."""
    with sync_playwright() as playwright:
        running = playwright.chromium.launch(executable_path=chromium, args=FLAGS, timeout=START_S * 1000.0)
        yield running
        running.close()


@pytest.fixture
def open_page(station: str, browser: Browser) -> Iterator[OpenPage]:
    """Opens pages of the station, in the low profile; none may write an error to its console."""
    errors: list[str] = []
    pages: list[Page] = []

    def note(message: ConsoleMessage) -> None:
        if message.type in ("error", "warning") and "GPU stall" not in message.text:
            errors.append(message.text)

    def open_one(
        width: int = 1280, height: int = 720, pad: bool = False, prepare: Callable[[Page], None] | None = None
    ) -> Flight:
        page = browser.new_page(viewport={"width": width, "height": height})
        pages.append(page)
        page.set_default_timeout(WAIT_MS)
        page.on("console", note)
        page.on("pageerror", lambda error: errors.append(str(error)))
        if pad:
            page.add_init_script(PAD)
        if prepare:
            prepare(page)
        page.goto(f"{station}?quality=low")
        return Flight(page)

    yield open_one
    for page in pages:
        page.close()
    assert errors == []


@pytest.fixture
def flight(open_page: OpenPage) -> Flight:
    """A page that flies, from the scenario's first instant."""
    return open_page().from_the_start()
