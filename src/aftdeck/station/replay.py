"""Playing a recording in the page: the page as built, the recording's index, and its frames block by block."""

from __future__ import annotations

import contextlib
from collections.abc import AsyncIterator
from pathlib import Path
from threading import Thread

import msgspec
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import HTMLResponse, PlainTextResponse, Response
from starlette.routing import Mount, Route
from starlette.staticfiles import StaticFiles

from aftdeck.station.app import STATIC, keep_to_own
from aftdeck.station.reel import Reel
from aftdeck.station.serve import address_of, built_page, listen, make_server, run_server
from aftdeck.station.verdict import CHECKING, verdict

WHERE = '<meta name="recording" content="recording/" />'
"""Tells the page that it plays, and where from."""
LARGE = 10_000_000
"""A longer recording [bytes] takes more than a few seconds to read."""


def serve_recording(path: Path, *, host: str, port: int, open_browser: bool) -> None:
    """Serve a recording to the page until interrupted; prints the page's address when it can be played.

    Raises:
        RecordingError: what cannot be read.
        StationError: the page was not built, or the address cannot be had.
    """
    built_page()
    if path.is_file() and path.stat().st_size > LARGE:
        print(f"Reading {path.name}.", flush=True)
    with listen(host, port) as listener, Reel(path) as reel:
        address = address_of(listener, host)
        print(f"Aftdeck replay: {address}", flush=True)
        print(f"Playing {path.name}. End with Ctrl+C.", flush=True)
        server = make_server(replay_app(reel, path, host))
        run_server(server, listener, address if open_browser else None)


def replay_app(reel: Reel, path: Path, host: str = "127.0.0.1") -> Starlette:
    """The server of a recording; it checks the recomputed frames beside, in a thread of its own."""
    found = CHECKING
    encode = msgspec.json.Encoder().encode

    def check() -> None:
        nonlocal found
        found = verdict(path)

    @contextlib.asynccontextmanager
    async def lifespan(_: Starlette) -> AsyncIterator[None]:
        Thread(target=check, name="recomputing", daemon=True).start()  # the end of the server does not wait for it
        yield

    def page(_: Request) -> Response:
        return HTMLResponse(built_page().replace("</head>", f"{WHERE}\n</head>", 1))

    def index(_: Request) -> Response:
        return _json(encode(reel.index(found)))

    def block(request: Request) -> Response:
        try:
            return _json(encode(reel.block(request.path_params["number"])))
        except IndexError as error:
            return PlainTextResponse(f"{error}\n", 404)

    def judged(_: Request) -> Response:
        return _json(encode(found))

    routes = [
        Route("/", page),
        Route("/index.html", page),
        Route("/recording/index.json", index),
        Route("/recording/blocks/{number:int}", block),
        Route("/recording/verdict.json", judged),
        Mount("/", StaticFiles(directory=STATIC)),
    ]
    return keep_to_own(Starlette(routes=routes, lifespan=lifespan), host)


def _json(body: bytes) -> Response:
    return Response(body, media_type="application/json", headers={"Cache-Control": "no-store"})
