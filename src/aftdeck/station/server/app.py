"""Web server of the station: the page's files, and one WebSocket for each page."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator

from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import BaseRoute, Mount, Route, WebSocketRoute
from starlette.staticfiles import StaticFiles
from starlette.websockets import WebSocket, WebSocketDisconnect

from aftdeck.station.built import STATIC
from aftdeck.station.server.own import keep_to_own
from aftdeck.station.server.page import Page
from aftdeck.station.server.pages import Pages
from aftdeck.station.server.recorded import Recordings
from aftdeck.station.session.session import Session


def make_app(session: Session, host: str = "127.0.0.1") -> Starlette:
    """Return the station's web app. It starts `session` at startup and closes the current session at shutdown."""
    pages: Pages | None = None
    recordings = (
        Recordings(session.folder, lambda: (pages.session if pages else session).file) if session.folder else None
    )

    @contextlib.asynccontextmanager
    async def lifespan(_: Starlette) -> AsyncIterator[None]:
        nonlocal pages
        loop = asyncio.get_running_loop()

        def told() -> None:
            with contextlib.suppress(RuntimeError):  # the loop is closing
                loop.call_soon_threadsafe(here.wake)

        here = pages = Pages(session, told)
        session.start(told)
        try:
            yield
        finally:
            await here.close()
            if recordings:
                recordings.close()

    async def talk(socket: WebSocket) -> None:
        assert pages is not None, "the lifespan makes it before the first connection"
        await socket.accept()
        with contextlib.suppress(WebSocketDisconnect):
            await Page(pages, socket).serve()

    async def health(_: Request) -> Response:
        return PlainTextResponse(f"{(pages.session if pages else session).phase.value}\n")

    routes: list[BaseRoute] = [WebSocketRoute("/ws", talk), Route("/health", health)]
    if recordings:
        routes += recordings.routes()
    if (STATIC / "index.html").is_file():
        routes.append(Mount("/", StaticFiles(directory=STATIC, html=True)))
    return keep_to_own(Starlette(routes=routes, lifespan=lifespan), host)
