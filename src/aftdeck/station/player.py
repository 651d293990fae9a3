"""A recording as its page asks for it: the page as built, the recording's index, and its frames block by block."""

from __future__ import annotations

from pathlib import Path
from threading import Thread

import msgspec
from starlette.requests import Request
from starlette.responses import HTMLResponse, PlainTextResponse, Response
from starlette.routing import BaseRoute, Mount, Route
from starlette.staticfiles import StaticFiles

from aftdeck.station.built import STATIC, built_page
from aftdeck.station.reel import Reel
from aftdeck.station.verdict import CHECKING, verdict

WHERE = '<meta name="recording" content="recording/" />'
"""Tells the page that it plays, and where from."""
FLYING = '<meta name="flying" content="../../" />'
"""Tells it where the station is flown that plays."""


class Player:
    """A recording as its page asks for it."""

    def __init__(self, reel: Reel, path: Path, told: str = WHERE) -> None:
        """`told`: what the page is told of where it is."""
        self._reel, self._path, self._told = reel, path, told
        self._found = CHECKING
        self._encode = msgspec.json.Encoder().encode

    def check(self) -> None:
        """Begin to check the recomputed frames, in a thread of its own; the end of the server does not wait for it."""
        Thread(target=self._check, name="recomputing", daemon=True).start()

    def close(self) -> None:
        """Let the recording go."""
        self._reel.close()

    def routes(self) -> list[BaseRoute]:
        """The page as built, the recording's index, its blocks, and the verdict."""
        return [
            Route("/", self._page),
            Route("/index.html", self._page),
            Route("/recording/index.json", self._index),
            Route("/recording/blocks/{number:int}", self._block),
            Route("/recording/verdict.json", self._verdict),
            Mount("/", StaticFiles(directory=STATIC)),
        ]

    def _check(self) -> None:
        self._found = verdict(self._path)

    def _page(self, _: Request) -> Response:
        return HTMLResponse(built_page().replace("</head>", f"{self._told}\n</head>", 1))

    def _index(self, _: Request) -> Response:
        return _json(self._encode(self._reel.index(self._found)))

    def _block(self, request: Request) -> Response:
        try:
            return _json(self._encode(self._reel.block(request.path_params["number"])))
        except IndexError as error:
            return PlainTextResponse(f"{error}\n", 404)

    def _verdict(self, _: Request) -> Response:
        return _json(self._encode(self._found))


def _json(body: bytes) -> Response:
    return Response(body, media_type="application/json", headers={"Cache-Control": "no-store"})
