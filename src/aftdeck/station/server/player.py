"""Web routes of a playback: the built page, the recording's index, its frames block by block, and the verdict."""

from __future__ import annotations

from typing import Protocol

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import HTMLResponse, PlainTextResponse, Response
from starlette.routing import BaseRoute, Mount, Route

from aftdeck.errors import RecordingError
from aftdeck.station.built import STATIC, built_page
from aftdeck.station.playback.answers import INDEX, VERDICT, Answers
from aftdeck.station.server.files import PageFiles

RECORDING_META = '<meta name="recording" content="recording/" />'
"""HTML element that makes the page play a recording; its content is the path of the recording."""
STATION_META = '<meta name="flying" content="../../" />'
"""HTML element whose content is the path from a recording's page back to the station."""
MAX_DIGITS = 9
"""Maximum number of digits in the number of a block."""


class Played(Protocol):
    """Recording that can be asked for its data."""

    async def ask(self, request: str) -> bytes:
        """Return the answer to a request of `playback/answers.py`.

        Raises:
            IndexError: the block does not exist.
            RecordingError: the recording was closed.
        """


class PlayedHere:
    """Recording that was read in this process."""

    def __init__(self, answers: Answers) -> None:
        self._answers = answers

    async def ask(self, request: str) -> bytes:
        """Return the answer to a request; see `Played`."""
        return await run_in_threadpool(self._answers.answer, request)


class Player:
    """Web routes for the playback of one recording."""

    def __init__(self, played: Played, head: str = RECORDING_META) -> None:
        """Serve a recording; `head`: HTML elements added to the page's head."""
        self._played, self._head = played, head

    def routes(self) -> list[BaseRoute]:
        """Return the routes that serve the built page, the recording's index and blocks, and the verdict."""
        return [
            Route("/", self._page),
            Route("/index.html", self._page),
            Route("/recording/index.json", self._index),
            Route("/recording/blocks/{number}", self._block),
            Route("/recording/verdict.json", self._verdict),
            Mount("/", PageFiles(directory=STATIC)),
        ]

    def _page(self, _: Request) -> Response:
        return HTMLResponse(built_page().replace("</head>", f"{self._head}\n</head>", 1))

    async def _index(self, _: Request) -> Response:
        return await self._answer(INDEX)

    async def _verdict(self, _: Request) -> Response:
        return await self._answer(VERDICT)

    async def _block(self, request: Request) -> Response:
        number = request.path_params["number"]
        if not (number.isascii() and number.isdecimal() and len(number) <= MAX_DIGITS):
            text = f"the number of a block has 1 to {MAX_DIGITS} decimal digits, got {number[:MAX_DIGITS]!r}\n"
            return PlainTextResponse(text, 404)
        return await self._answer(number)

    async def _answer(self, request: str) -> Response:
        try:
            body = await self._played.ask(request)
        except (IndexError, RecordingError) as error:
            return PlainTextResponse(f"{error}\n", 404)
        return Response(body, media_type="application/json", headers={"Cache-Control": "no-store"})
