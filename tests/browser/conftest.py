"""Fixtures of the browser tests: a running station, Chromium, and pages of the station."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from queue import Empty, Queue
from threading import Thread
from urllib.request import urlopen

import pytest
from playwright.sync_api import Browser, ConsoleMessage, Page, sync_playwright

from tests.browser.flight import WAIT_MS, Flight
from tests.browser.programs import running
from tests.waits import WAIT_S

# As in benchmarks/page.py: Mesa's GL draws the scene, and Chromium composites the page without GL.
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
"""A gamepad whose axes and buttons a test sets. A test disconnects it by setting `window.testPad` to null."""

FULL_PANEL = """
    try { localStorage.getItem('aftdeck.panel') ?? localStorage.setItem('aftdeck.panel', 'full'); }
    catch { /* about:blank has no storage */ }
"""
"""Choice of the full panel, unless the browser keeps a choice; a test module flies the calm page if CALM is true."""

SIZES = [(1280, 720), (1440, 900), (1920, 1080)]
"""Window sizes that the page must fit [px]."""
NARROW = [(960, 900), (1024, 768), (768, 1024)]
"""Narrow window sizes in which the arm can be flown: half a laptop screen, an old screen, an upright tablet [px]."""

STATE = """() => ({
    body: document.body.className,
    alerts: [...document.querySelectorAll('[role=alert]')].map((each) => each.textContent),
    inert: [...document.querySelectorAll('[inert]')].map((each) => each.className),
    rail: [...document.querySelectorAll('.rail :is(.scenario > button, .who)')].map((each) => each.textContent),
    time: window.__aftdeck?.lastFrame?.time_s,
})"""
"""What a page displays about its state."""

STARTED = """
    try { localStorage.setItem('aftdeck.started', 'yes'); }
    catch { /* about:blank has no storage */ }
"""
"""Mark of an earlier start; a test module begins with the opening shot of a first start if FIRST is true."""

OpenPage = Callable[..., Flight]


@pytest.fixture(scope="package")
def station_of() -> Iterator[Callable[[str], str]]:
    """Function that returns the address of a running `aftdeck fly` with a scenario.

    The station runs until another scenario is wanted: modules in a row with one scenario share its station.
    """
    with ExitStack() as stack:
        last: dict[str, str] = {}

        def address(scenario: str) -> str:
            if scenario not in last:
                last.clear()
                stack.close()
                last[scenario] = stack.enter_context(running_station(scenario))
            return last[scenario]

        yield address


@pytest.fixture(scope="module")
def station(request: pytest.FixtureRequest, station_of: Callable[[str], str]) -> str:
    """Address of a running `aftdeck fly`; a test module names its scenario in SCENARIO.

    The station may have flown the tests of other modules: a test begins with a restart. A module that loads other
    scenarios has a station of its own.
    """
    return station_of(getattr(request.module, "SCENARIO", "first-flight"))


@contextmanager
def running_station(*options: str) -> Iterator[str]:
    """Run `aftdeck fly` with these options inside the `with` block; yield the address of the station."""
    command = [sys.executable, "-m", "aftdeck.cli", "fly", *options, "--no-browser", "--port", "0"]
    with running(command, stdout=subprocess.PIPE, text=True) as process:
        address = _address(process)
        # The socket accepts connections before the server answers.
        with urlopen(f"{address}health", timeout=WAIT_S) as answer:
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
        first = lines.get(timeout=WAIT_S)
    except Empty:
        pytest.fail(f"`aftdeck fly` printed nothing within {WAIT_S:g} s.")
    assert first.startswith("Aftdeck station: http://127.0.0.1:"), first
    return first.removeprefix("Aftdeck station: ").strip()


@pytest.fixture(scope="package")
def browser(chromium: Path) -> Iterator[Browser]:
    """A Chromium that draws in software.

    It ends after the tests of this folder: Playwright's loop would prevent `asyncio.run` in other tests.
    """
    with sync_playwright() as playwright:
        running = playwright.chromium.launch(executable_path=chromium, args=FLAGS, timeout=WAIT_S * 1000.0)
        yield running
        running.close()


@pytest.fixture
def open_page(station: str, browser: Browser, request: pytest.FixtureRequest) -> Iterator[OpenPage]:
    """Function that opens a page of the station with `quality=low`.

    An error or a warning in the page's console fails the test.
    """
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
        if not getattr(request.module, "CALM", False):
            page.add_init_script(FULL_PANEL)
        if not getattr(request.module, "FIRST", False):
            page.add_init_script(STARTED)
        if pad:
            page.add_init_script(PAD)
        if prepare:
            prepare(page)
        page.goto(f"{station}?quality=low")
        return Flight(page)

    yield open_one
    for page in pages:
        if not page.is_closed():
            print("the page at the end of the test:", page.evaluate(STATE))  # is shown if the test has failed
            page.close()
    assert errors == []


@pytest.fixture
def flight(open_page: OpenPage) -> Flight:
    """A page in control, at the start of the scenario."""
    return open_page().from_the_start()
