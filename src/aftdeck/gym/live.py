"""Station that shows the episodes of an environment while they last, to pages on this machine.

The station flies a session of its own, with the scenario and the inputs of the episode. Its numbers are those of the
environment, bit for bit. A page of it is an observer and cannot take control.
"""

from __future__ import annotations

import asyncio
import contextlib
import time
from collections.abc import AsyncIterator, Callable
from threading import Event, Thread

from starlette.applications import Starlette
from starlette.routing import Mount, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from aftdeck.errors import SimulationError
from aftdeck.lines import print_line
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.station.built import STATIC, built_page
from aftdeck.station.core.autopilot import Autopilot
from aftdeck.station.server.access import LOCAL
from aftdeck.station.server.files import PageFiles
from aftdeck.station.server.own import keep_to_own
from aftdeck.station.server.page import Page, receive_hello
from aftdeck.station.server.pages import Pages
from aftdeck.station.server.serve import listen, make_server
from aftdeck.station.session.driver import Driver, Phase
from aftdeck.station.session.pace import Pace
from aftdeck.station.session.session import Session

HOST = "127.0.0.1"
"""Address on which the station listens: only this machine reaches it."""
LONGEST_WAIT = 10.0
"""Longest wait for the server's thread [s]."""


class _Stepped(Driver):
    """Driver without a thread: its caller steps the session."""

    def start(self, notify: Callable[[], None]) -> None:
        """Start the run; `notify` is called after each step."""
        self._notify = self.session.painter.notify = notify
        self.phase = Phase.FLYING
        self.session.begin()

    def step(self) -> None:
        """Make one control step."""
        self.session.step()
        self._notify()


class LiveStation:
    """Station of one environment; it serves pages from the first episode on, on a free port.

    Attributes:
        address: address of the page; empty before the first episode.
    """

    def __init__(self) -> None:
        """Prepare the station.

        Raises:
            StationError: the page was not built.
        """
        built_page()
        self.address = ""
        self._inputs = Inputs()
        self._driver: _Stepped | None = None
        self._pages: Pages | None = None
        self._loop: asyncio.AbstractEventLoop | None = None
        self._pace = Pace(1.0, time.perf_counter)
        self._ready = Event()

    @property
    def session(self) -> Session | None:
        """Session of the present episode; None before the first one."""
        return None if self._driver is None else self._driver.session

    def begin(self, scenario: Scenario) -> None:
        """End the present episode, and begin one that starts at the initial conditions of a scenario.

        Raises:
            StationError: the server cannot listen.
        """
        before = self._driver
        if before is None:
            session = Session(scenario, autopilots=lambda _: Autopilot("policy", lambda: self._pilot))
        else:
            session = before.session.another(scenario)
        self._driver = _Stepped(session)
        if before is None:
            self._serve(self._driver)
        else:
            self._in_loop(self._replace)
            before.close()
        self._driver.start(self._notify)
        self._pace = Pace(scenario.control_period, time.perf_counter)

    def step(self, inputs: Inputs) -> None:
        """Make one control step with these inputs, and wait until it is over in real time.

        Raises:
            SimulationError: the session does not fly these inputs.
        """
        assert self._driver is not None, "`begin` was called"
        self._inputs = inputs
        self._pace.step()
        self._driver.step()
        if self._driver.session.desk.autopilot is None:
            raise SimulationError("the station has stopped to fly the inputs of the environment")
        time.sleep(self._pace.wait())

    def close(self) -> None:
        """End the episode and the server."""
        if self._driver is not None:
            self._server.should_exit = True
            self._thread.join(LONGEST_WAIT)

    def _pilot(self, _: Simulation) -> Inputs:
        return self._inputs

    def _serve(self, driver: _Stepped) -> None:
        """Start the server in a thread, and print the address of its page."""
        listener = listen(HOST, 0)
        pages = self._pages = Pages(driver.session, self._notify)
        pages.driver = driver

        @contextlib.asynccontextmanager
        async def lifespan(_: Starlette) -> AsyncIterator[None]:
            self._loop = asyncio.get_running_loop()
            self._ready.set()
            yield
            await pages.close()

        async def connect(socket: WebSocket) -> None:
            await socket.accept()
            with contextlib.suppress(WebSocketDisconnect, asyncio.CancelledError):  # cancelled: the server ends
                if hello := await receive_hello(socket):
                    await Page(pages, socket, hello, may_fly=False).serve()

        routes = [WebSocketRoute("/ws", connect), Mount("/", PageFiles(directory=STATIC, html=True))]
        self._server = make_server(keep_to_own(Starlette(routes=routes, lifespan=lifespan), LOCAL))
        self._thread = Thread(target=self._server.run, kwargs={"sockets": [listener]}, name="station", daemon=True)
        self._thread.start()
        self._ready.wait(LONGEST_WAIT)
        self.address = f"http://{HOST}:{listener.getsockname()[1]}/"
        print_line(f"Aftdeck station, to observe: {self.address}")

    def _replace(self) -> None:
        """Show the present session to all pages; each page asks again for its pictures after the welcome."""
        assert self._pages is not None and self._driver is not None, "the server runs"
        self._pages.driver = self._driver
        self._pages.polygons.clear()
        self._pages.wake()

    def _notify(self) -> None:
        """Let the server send the newest frame to the pages."""
        if self._loop is not None and self._pages is not None:
            with contextlib.suppress(RuntimeError):  # the loop is closed
                self._loop.call_soon_threadsafe(self._pages.wake)

    def _in_loop(self, call: Callable[[], None]) -> None:
        """Call a function in the server's thread, and wait until it has returned."""
        done = Event()

        def run() -> None:
            call()
            done.set()

        assert self._loop is not None, "the server runs"
        self._loop.call_soon_threadsafe(run)
        done.wait(LONGEST_WAIT)
