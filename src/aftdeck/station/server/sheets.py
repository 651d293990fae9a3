"""Web route of the sheets that show what decides the order of a camera's picture: ``planes/CAMERA.svg``."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import BaseRoute, Route

from aftdeck.errors import InputError, SimulationError
from aftdeck.station.session.painter import PREPARING
from aftdeck.station.session.session import Session

NO_FRAME = "The run has no frame yet."
BUSY = "Other sheets are drawn first."
MOST_WAITING = 8
"""Greatest number of requests that wait for a sheet."""


class SheetRoutes:
    """Web route that draws the sheet of any camera in the newest frame."""

    def __init__(self, session: Callable[[], Session | None]) -> None:
        """Draw sheets of the session that `session` returns; None: no run is ready yet."""
        self._session = session
        self._turn = asyncio.Lock()
        self._waiting = 0

    def routes(self) -> list[BaseRoute]:
        """Return the route."""
        return [Route("/planes/{camera}.svg", self._sheet)]

    async def _sheet(self, request: Request) -> Response:
        """Return a sheet, as late as the pictures of the cameras are; a request waits for those before it."""
        session = self._session()
        if session is None or session.painter.newest is None:
            return _later(NO_FRAME)
        if not session.painter.prepare():
            failure = session.painter.failure
            return PlainTextResponse(f"{failure}\n", 409) if failure else _later(PREPARING)
        if self._waiting == MOST_WAITING:
            return _later(BUSY)
        self._waiting += 1
        try:
            async with self._turn:
                answer = Response() if await request.is_disconnected() else await _made(session, request)
        finally:
            self._waiting -= 1
        await asyncio.sleep(session.welcome.camera_delay_s)
        return answer


async def _made(session: Session, request: Request) -> Response:
    """Return the sheet of the newest frame, or why there is none."""
    assert session.painter.newest is not None, "the run has a frame"
    frame, light = session.painter.newest
    try:
        svg = await run_in_threadpool(session.sheets.of, frame, request.path_params["camera"], light)
    except InputError as error:
        return PlainTextResponse(f"{error}\n", 404)
    except SimulationError as error:
        return PlainTextResponse(f"No picture: {error}.\n", 409)
    return Response(svg, media_type="image/svg+xml", headers={"Cache-Control": "no-store"})


def _later(text: str) -> Response:
    """Return an answer to a request that has to be repeated: 202, since the station is at work on it."""
    return PlainTextResponse(f"{text}\n", 202, headers={"Retry-After": "1"})
