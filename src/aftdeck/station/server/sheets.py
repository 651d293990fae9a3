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


class SheetRoutes:
    """Web route that draws the sheet of any camera in the newest frame."""

    def __init__(self, session: Callable[[], Session | None]) -> None:
        """Draw sheets of the session that `session` returns; None: no run is ready yet."""
        self._session = session
        self._turn = asyncio.Lock()

    def routes(self) -> list[BaseRoute]:
        """Return the route."""
        return [Route("/planes/{camera}.svg", self._sheet)]

    async def _sheet(self, request: Request) -> Response:
        """Return a sheet, as late as the pictures of the cameras are; a request waits for those before it."""
        session = self._session()
        if session is None or session.painter.newest is None:
            return _later(NO_FRAME)
        if not session.painter.prepare():
            return _later(PREPARING)
        async with self._turn:
            frame, light = session.painter.newest
            try:
                svg = await run_in_threadpool(session.sheets.of, frame, request.path_params["camera"], light)
            except InputError as error:
                return PlainTextResponse(f"{error}\n", 404)
            except SimulationError as error:
                return PlainTextResponse(f"No picture: {error}.\n", 409)
        await asyncio.sleep(session.welcome.camera_delay_s)
        return Response(svg, media_type="image/svg+xml", headers={"Cache-Control": "no-store"})


def _later(text: str) -> Response:
    """Return an answer to a request that has to be repeated: 202, since the station is at work on it."""
    return PlainTextResponse(f"{text}\n", 202, headers={"Retry-After": "1"})
