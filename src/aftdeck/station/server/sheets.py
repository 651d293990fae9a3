"""Web route of the sheets that show what decides the order of a camera's picture: ``planes/CAMERA.svg``."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import BaseRoute, Route

from aftdeck.errors import InputError, SimulationError
from aftdeck.station.server.allowance import Allowance
from aftdeck.station.session.session import Session

NO_FRAME = "The run has no frame yet."
BUSY = "Other sheets are drawn first."
CHANGED = "Another scenario has begun; ask again."
SHEETS_PER_SECOND, SHEETS_AT_ONCE = 5.0, 5.0
"""Requests that are answered per second over a long time, and at once; others wait, at most `LONGEST_WAIT`.

A window of the page asks once a second.
"""
LONGEST_WAIT = 2.0
"""Longest time for which a request waits before it is looked at [s]."""
MOST_WAITING = 8
"""Greatest number of requests that wait for a sheet."""


class SheetRoutes:
    """Web route that draws the sheet of any camera in the frame that its picture shows."""

    def __init__(self, session: Callable[[], Session | None]) -> None:
        """Draw sheets of the session that `session` returns; None: no run is ready yet."""
        self._session = session
        self._turn = asyncio.Lock()
        self._allowed = Allowance(SHEETS_PER_SECOND, SHEETS_AT_ONCE)
        self._waiting = 0

    def routes(self) -> list[BaseRoute]:
        """Return the route."""
        return [Route("/planes/{camera}.svg", self._sheet)]

    async def _sheet(self, request: Request) -> Response:
        """Return a sheet; a request waits for those before it."""
        try:
            await asyncio.sleep(self._allowed.turn(LONGEST_WAIT))
            session = self._session()
            if session is None or session.painter.newest is None:
                return _later(NO_FRAME)
            painter = session.painter
            if not painter.prepare():
                return PlainTextResponse(f"{painter.failure}\n", 409) if painter.failure else _later(painter.text)
            if self._waiting == MOST_WAITING:
                return _later(BUSY)
            return await self._in_turn(session, request)
        except asyncio.CancelledError:  # the server ends meanwhile
            return PlainTextResponse("the station has ended\n", 503)

    async def _in_turn(self, session: Session, request: Request) -> Response:
        """Return a sheet after those that were requested before."""
        self._waiting += 1
        try:
            async with self._turn:
                return Response() if await request.is_disconnected() else await _made(session, request)
        finally:
            self._waiting -= 1


async def _made(session: Session, request: Request) -> Response:
    """Return the sheet of a camera, or why there is none."""
    try:
        svg = await run_in_threadpool(session.painter.sheet, request.path_params["camera"])
    except InputError as error:
        return PlainTextResponse(f"{error}\n", 404)
    except SimulationError as error:
        return PlainTextResponse(f"No picture: {error}.\n", 409)
    except EOFError:
        return PlainTextResponse(f"{session.painter.failure or CHANGED}\n", 409)
    return Response(svg, media_type="image/svg+xml", headers={"Cache-Control": "no-store"})


def _later(text: str) -> Response:
    """Return an answer to a request that has to be repeated: 202, since the station is at work on it."""
    return PlainTextResponse(f"{text}\n", 202, headers={"Retry-After": "1"})
