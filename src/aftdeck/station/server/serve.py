"""Start of the station: socket, address for the user, browser and web server."""

from __future__ import annotations

import asyncio
import errno
import signal
import socket
import sys
import webbrowser
from collections.abc import Callable
from pathlib import Path

import uvicorn
from starlette.applications import Starlette

from aftdeck.law import run_plain
from aftdeck.law_change import Laws
from aftdeck.lines import print_line
from aftdeck.recording.live import Live
from aftdeck.recording.trial import NO_TRIAL, Trial
from aftdeck.scenario.model import Scenario
from aftdeck.station.built import StationError, built_page
from aftdeck.station.core.autopilot import Autopilots
from aftdeck.station.messages.kinds import MAX_MESSAGE_BYTES
from aftdeck.station.server.access import Access, access_of, shown_host
from aftdeck.station.server.app import make_app
from aftdeck.station.server.console import TerminalConsole
from aftdeck.station.server.guard import BACKLOG, MAX_REQUEST, GuardedHttp, GuardedSocket
from aftdeck.station.server.terse_log import flush, install
from aftdeck.station.session.preparation import Preparation
from aftdeck.station.session.session import Session

LAST_PORT = 65535
SWITCH_S = 0.0005
"""Time after which a busy thread gives way to a waiting one [s]; Python's 5 ms would delay the control steps."""
SEND_BUFFER = 65_536
"""Data that the system keeps for a client that has not received them yet [bytes]; a message with a frame has 8 kB.

Without a limit it keeps seconds of frames: a slow page would fall behind by them, and each page costs time for them.
"""
_PURPOSE = {"fly": ", to fly", "watch": ", to observe"}
FAREWELL = 3.0
"""Time for which the server runs after a failed preparation, so that the opened page can receive the reason [s]."""


def serve(
    load: Callable[[], Scenario],
    seed: int | None,
    *,
    host: str,
    port: int,
    names: tuple[str, ...] = (),
    open_browser: bool,
    demo: bool,
    autopilots: Autopilots | None = None,
    record: Path | None = None,
    trial: Trial = NO_TRIAL,
    viewers: int | None = None,
    console: bool = False,
) -> None:
    """Serve a scenario until interrupted; print the page's address first.

    The page is served at once. Meanwhile a thread loads the scenario and the laws, and the page shows the progress.

    Args:
        load: returns the scenario to run.
        seed: random seed; None selects the scenario's seed.
        host: address to listen on.
        port: port to listen on; 0 selects any free port.
        names: further host names under which pages may address the station.
        open_browser: whether to open the page in a browser.
        demo: whether the script runs until the operator moves a stick or sends a command.
        autopilots: returns the autopilot that flies a scenario in this way, if the script does not; None: none.
        record: folder into which each run is recorded; None: runs are not recorded.
        trial: participant and condition, stored in each recording and in the list of recordings.
        viewers: port to which Foxglove can attach; None: no port is opened.
        console: whether lines of standard input go to the console.

    Raises:
        StationError: the page was not built, or the server cannot listen on the address.
        RecordingError: the viewers' port cannot be opened.
        AftdeckError: `load` or the session failed; the waiting pages have received the reason.
    """
    built_page()
    listener = listen(host, port)
    access = access_of(listener, host, names)
    addresses = addresses_of(listener, access, host, names)
    for purpose, address in addresses:
        print_line(f"Aftdeck station{purpose}: {address}")
    live = None if viewers is None else Live(viewers)
    if live is not None:
        print_line(f"Foxglove can attach at {live.address}")

    def make(report: Callable[[str], None]) -> Session:
        report("Loading the scenario.")
        scenario = load()
        report(f"Preparing {scenario.title!r}.")
        session = Session(
            scenario, seed, demo=demo, autopilots=autopilots, record=record, trial=trial, live=live, laws=laws
        )
        print_line(f"Flying {scenario.title!r}. End with Ctrl+C.")
        return session

    def failed() -> None:
        def stop() -> None:
            server.should_exit = True

        asyncio.get_running_loop().call_later(FAREWELL if open_browser else 0.0, stop)

    laws = Laws()
    run_plain()
    preparation = Preparation(make)
    sys.setswitchinterval(SWITCH_S)
    app = make_app(preparation, access, record, failed, for_page=open_browser)
    server = make_server(app)
    terminal = TerminalConsole(app.state.session) if console else None
    run_server(server, listener, addresses[0][1] if open_browser else None)
    if terminal is not None:
        terminal.close()
    laws.close()
    if live is not None:
        live.close()
    if preparation.error is not None:
        raise preparation.error


def addresses_of(listener: socket.socket, access: Access, host: str, names: tuple[str, ...]) -> list[tuple[str, str]]:
    """Return the page's addresses for the user, one for each key; before each, words that state its purpose."""
    base = f"http://{shown_host(listener, host, names)}:{listener.getsockname()[1]}/"
    return [(_PURPOSE[role], f"{base}{key}/") for role, key in access.keys] or [("", base)]


def run_server(server: uvicorn.Server, listener: socket.socket, opened: str | None) -> None:
    """Open a browser at the address `opened`, if it is not None, and run a server until interrupted."""
    if opened is not None:
        webbrowser.open(opened)
    # Ctrl+C ends the server also while it starts: an exception within the start of asyncio leaves a traceback
    before = signal.signal(signal.SIGINT, server.handle_exit)
    try:
        server.run(sockets=[listener])
    finally:
        signal.signal(signal.SIGINT, before)


class Server(uvicorn.Server):
    """Web server; when it ends, no line of its log is left to be printed."""

    def run(self, sockets: list[socket.socket] | None = None) -> None:
        """Serve until the server is to end."""
        try:
            super().run(sockets)
        finally:
            flush()


def make_server(app: Starlette) -> Server:
    """Return the web server of an app, with the limits of `guard.py`."""
    install()
    return Server(
        uvicorn.Config(
            app,
            log_config=None,
            access_log=False,
            http=GuardedHttp,
            h11_max_incomplete_event_size=MAX_REQUEST,
            backlog=BACKLOG,
            ws=GuardedSocket,
            ws_max_size=MAX_MESSAGE_BYTES,
            ws_per_message_deflate=False,
            timeout_graceful_shutdown=2,
        )
    )


def listen(host: str, port: int) -> socket.socket:
    """Return a listening socket; port 0 selects a free port.

    Raises:
        StationError: the port or host is not valid, or the socket cannot listen there.
    """
    if not 0 <= port <= LAST_PORT:
        raise StationError(f"ports are numbered 0 to {LAST_PORT}, got {port}")
    try:
        family, kind, protocol, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
    except (OSError, UnicodeError) as error:
        raise StationError(f"the host {host!r} is not known: {error}") from None
    # The protocol is passed because asyncio disables Nagle's algorithm only if it is TCP; the default is 0.
    listener = socket.socket(family, kind, protocol)
    try:
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, SEND_BUFFER)
        listener.bind(address)
        listener.listen(64)
    except OSError as error:
        listener.close()
        if error.errno == errno.EADDRINUSE:
            raise StationError(
                f"port {port} on {host} is in use: choose another with --port, or 0 for any free port"
            ) from None
        raise StationError(f"cannot listen on {host}, port {port}: {error.strerror}") from None
    return listener
