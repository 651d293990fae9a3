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
from aftdeck.station.playback.store import PlaybackStore
from aftdeck.station.playback.verdict import CHECKING, verdict

RECORDING_META = '<meta name="recording" content="recording/" />'
"""HTML element that makes the page play a recording; its content is the path of the recording."""
STATION_META = '<meta name="flying" content="../../" />'
"""HTML element whose content is the path from a recording's page back to the station."""


class Player:
    """Web routes for the playback of one recording."""

    def __init__(self, store: PlaybackStore, path: Path, head: str = RECORDING_META) -> None:
        """Serve the recording `store` of the file `path`; `head`: HTML elements added to the page's head."""
        self._store, self._path, self._head = store, path, head
        self._result = CHECKING
        self._encode = msgspec.json.Encoder().encode

    def check(self) -> None:
        """Start the verification of the recording in a daemon thread, which does not delay the end of the server."""
        Thread(target=self._check, name="verification", daemon=True).start()

    def close(self) -> None:
        """Close the recording."""
        self._store.close()

    def routes(self) -> list[BaseRoute]:
        """Return the routes that serve the built page, the recording's index and blocks, and the verdict."""
        return [
            Route("/", self._page),
            Route("/index.html", self._page),
            Route("/recording/index.json", self._index),
            Route("/recording/blocks/{number:int}", self._block),
            Route("/recording/verdict.json", self._verdict),
            Mount("/", StaticFiles(directory=STATIC)),
        ]

    def _check(self) -> None:
        self._result = verdict(self._path)

    def _page(self, _: Request) -> Response:
        return HTMLResponse(built_page().replace("</head>", f"{self._head}\n</head>", 1))

    def _index(self, _: Request) -> Response:
        return _json(self._encode(self._store.index(self._result)))

    def _block(self, request: Request) -> Response:
        try:
            return _json(self._encode(self._store.block(request.path_params["number"])))
        except IndexError as error:
            return PlainTextResponse(f"{error}\n", 404)

    def _verdict(self, _: Request) -> Response:
        return _json(self._encode(self._result))


def _json(body: bytes) -> Response:
    return Response(body, media_type="application/json", headers={"Cache-Control": "no-store"})
