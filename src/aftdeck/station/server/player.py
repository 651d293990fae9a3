"""Web routes of a playback: the built page, the recording's index, its frames block by block, and the verdict."""

from __future__ import annotations

from typing import Annotated, Protocol

import msgspec
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import HTMLResponse, PlainTextResponse, Response
from starlette.routing import BaseRoute, Mount, Route

from aftdeck.bodies.cameras import Camera
from aftdeck.errors import CommandError, RecordingError
from aftdeck.station.built import STATIC, built_page
from aftdeck.station.conversion.polygons_of import shot_of
from aftdeck.station.core.commands import check_pictures
from aftdeck.station.messages.from_page import MAX_PICTURES, PolygonPicture
from aftdeck.station.playback.answers import INDEX, LIT, VERDICT, Answers
from aftdeck.station.playback.lit import decoded
from aftdeck.station.server.files import PageFiles
from aftdeck.station.server.replay_painter import ReplayPainter, joined

RECORDING_META = '<meta name="recording" content="recording/" />'
"""HTML element that makes the page play a recording; its content is the path of the recording."""
STATION_META = '<meta name="flying" content="../../" />'
"""HTML element whose content is the path from a recording's page back to the station."""
MAX_DIGITS = 9
"""Maximum number of digits in the number of a block."""


_decode = msgspec.json.Decoder(Annotated[tuple[PolygonPicture, ...], msgspec.Meta(max_length=MAX_PICTURES)]).decode


class _Welcome(msgspec.Struct):
    cameras: tuple[Camera, ...]


class _Index(msgspec.Struct):
    """Part of a `PlaybackIndex`."""

    welcome: _Welcome


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

    def __init__(self, played: Played, painter: ReplayPainter, head: str = RECORDING_META) -> None:
        """Serve a recording, whose pictures `painter` draws; `head`: HTML elements added to the page's head."""
        self._played, self._painter, self._head = played, painter, head
        self._known: tuple[Camera, ...] | None = None

    def routes(self) -> list[BaseRoute]:
        """Return the routes that serve the built page, the recording's index and blocks, and the verdict."""
        return [
            Route("/", self._page),
            Route("/index.html", self._page),
            Route("/recording/index.json", self._index),
            Route("/recording/blocks/{number}", self._block),
            Route("/recording/verdict.json", self._verdict),
            Route("/recording/polygons/{tick}", self._polygons),
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
        if not _is_number(number):
            text = f"the number of a block has 1 to {MAX_DIGITS} decimal digits, got {number[:MAX_DIGITS]!r}\n"
            return PlainTextResponse(text, 404)
        return await self._answer(number)

    async def _polygons(self, request: Request) -> Response:
        """Return the pictures of a step in the look of 1972: those that the query ``pictures`` lists, as JSON."""
        tick = request.path_params["tick"]
        try:
            shots = _decode(request.query_params.get("pictures", ""))
            check_pictures(shots, await self._cameras())
            lit = decoded(await self._played.ask(f"{LIT}{int(tick) if _is_number(tick) else 0}"))
        except (msgspec.DecodeError, CommandError, IndexError, RecordingError) as error:
            return PlainTextResponse(f"{error}\n", 404)
        aspects = {shot_of(picture): picture.aspect for picture in shots}
        body = joined(await run_in_threadpool(self._painter.pictures, lit, aspects))
        return Response(body, media_type="application/json", headers={"Cache-Control": "no-store"})

    async def _cameras(self) -> tuple[Camera, ...]:
        """Return the recording's cameras."""
        if self._known is None:
            self._known = msgspec.json.decode(await self._played.ask(INDEX), type=_Index).welcome.cameras
        return self._known

    async def _answer(self, request: str) -> Response:
        try:
            body = await self._played.ask(request)
        except (IndexError, RecordingError) as error:
            return PlainTextResponse(f"{error}\n", 404)
        return Response(body, media_type="application/json", headers={"Cache-Control": "no-store"})


def _is_number(text: str) -> bool:
    return text.isascii() and text.isdecimal() and len(text) <= MAX_DIGITS
