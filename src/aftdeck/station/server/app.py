"""Web server of the station: the page's files, and one WebSocket for each page."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator, Callable
from pathlib import Path

from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import BaseRoute, Mount, Route, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from aftdeck.station.built import STATIC
from aftdeck.station.server.access import LOCAL, Access
from aftdeck.station.server.allowance import Allowance
from aftdeck.station.server.files import PageFiles
from aftdeck.station.server.own import MAY_FLY, keep_to_own
from aftdeck.station.server.page import Page, receive_hello
from aftdeck.station.server.recorded import Recordings
from aftdeck.station.server.sheets import SheetRoutes
from aftdeck.station.server.terse_log import log
from aftdeck.station.server.waiting import Waiting
from aftdeck.station.session.preparation import Preparation
from aftdeck.station.session.session import Session

CONNECTIONS_PER_SECOND, CONNECTIONS_AT_ONCE = 20.0, 64.0
"""Pages that connect per second over a long time, and at once; others wait, at most `LONGEST_WAIT`.

A page that connects again as soon as it is closed would otherwise keep the server busy with welcomes.
"""
LONGEST_WAIT = 2.0
"""Longest time for which a page waits before it is connected [s]."""


def make_app(
    preparation: Preparation,
    access: Access = LOCAL,
    record: Path | None = None,
    failed: Callable[[], None] = lambda: None,
    *,
    for_page: bool = False,
) -> Starlette:
    """Return the station's web app.

    At startup the app starts the preparation. When the preparation has made the first session, the app starts this
    session. At shutdown the app closes the present session.

    `app.state.session` is a function that returns the present session, or None before there is one.

    Args:
        preparation: preparation of the first session.
        access: names under which pages may address the server, and the keys that they need.
        record: folder into which the runs are recorded; None: runs are not recorded.
        failed: called in the server's event loop if the preparation fails.
        for_page: whether the first run waits until the page in control has drawn it.
    """
    waiting = Waiting(preparation, failed, for_page=for_page)

    def session() -> Session | None:
        return waiting.pages.session if waiting.pages else None

    recordings = Recordings(record, lambda: waiting.pages.session.file if waiting.pages else None) if record else None

    @contextlib.asynccontextmanager
    async def lifespan(_: Starlette) -> AsyncIterator[None]:
        waiting.start()
        try:
            yield
        finally:
            if waiting.pages:
                await waiting.pages.close()
            if recordings:
                await recordings.close()

    connections = Allowance(CONNECTIONS_PER_SECOND, CONNECTIONS_AT_ONCE)

    async def connect(socket: WebSocket) -> None:
        if wait := connections.turn(LONGEST_WAIT):
            log.warning("more than %g pages a second connect: they wait", CONNECTIONS_PER_SECOND)
            await asyncio.sleep(wait)
        await socket.accept()
        with contextlib.suppress(WebSocketDisconnect, asyncio.CancelledError):  # cancelled: the server ends
            if (hello := await receive_hello(socket)) and (pages := await waiting.until_ready(socket)):
                await Page(pages, socket, hello, may_fly=socket.scope[MAY_FLY]).serve()

    async def health(_: Request) -> Response:
        return PlainTextResponse(f"{waiting.phase}\n")

    sheets = SheetRoutes(lambda: waiting.pages.session if waiting.pages else None)
    routes: list[BaseRoute] = [WebSocketRoute("/ws", connect), Route("/health", health), *sheets.routes()]
    if recordings:
        routes += recordings.routes()
    if (STATIC / "index.html").is_file():
        routes.append(Mount("/", PageFiles(directory=STATIC, html=True)))
    app = Starlette(routes=routes, lifespan=lifespan)
    app.state.session = session
    return keep_to_own(app, access)
