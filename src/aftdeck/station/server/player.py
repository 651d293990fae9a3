"""Web routes of a playback: the built page, the recording's index, its frames block by block, and the verdict."""

from __future__ import annotations

from pathlib import Path
from threading import Thread

import msgspec
from starlette.requests import Request
from starlette.responses import HTMLResponse, PlainTextResponse, Response
from starlette.routing import BaseRoute, Mount, Route
from starlette.staticfiles import StaticFiles

from aftdeck.station.built import STATIC, built_page
from aftdeck.station.playback.reel import PlaybackStore
from aftdeck.station.playback.verdict import CHECKING, verdict

WHERE = '<meta name="recording" content="recording/" />'
"""HTML element that makes the page play a recording, with the path to load it from."""
FLYING = '<meta name="flying" content="../../" />'
"""HTML element that gives the page the path back to the live station."""


class Player:
    """Server side of one recording that a page plays."""

    def __init__(self, reel: PlaybackStore, path: Path, head: str = WHERE) -> None:
        """Serve `reel`, read from `path`; `head` is the HTML elements to add to the page's head."""
        self._reel, self._path, self._head = reel, path, head
        self._found = CHECKING
        self._encode = msgspec.json.Encoder().encode

    def check(self) -> None:
        """Start to re-simulate and compare the frames in a daemon thread; the server ends without waiting for it."""
        Thread(target=self._check, name="recomputing", daemon=True).start()

    def close(self) -> None:
        """Close the recording."""
        self._reel.close()

    def routes(self) -> list[BaseRoute]:
        """Return the routes of the built page, the recording's index, its blocks, and the verdict."""
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
        return HTMLResponse(built_page().replace("</head>", f"{self._head}\n</head>", 1))

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
