"""Web routes that list the recordings of a station and play them."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path
from typing import NamedTuple

import msgspec
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import BaseRoute, Mount, Route, Router
from starlette.types import ASGIApp, Receive, Scope, Send

from aftdeck.encodable import encodable
from aftdeck.errors import RecordingError
from aftdeck.recording.index import Entry, Index
from aftdeck.station.messages.playback import Recorded
from aftdeck.station.server.playback_process import PlaybackProcess
from aftdeck.station.server.player import RECORDING_META, STATION_META, Player
from aftdeck.station.server.replay_painter import ReplayPainter

MAX_LISTED = 50
"""Maximum number of recordings in the list; older ones are omitted."""
MAX_OPEN = 3
"""Maximum number of open recordings. Before another one is opened, the one that was opened first is closed."""


class _Opened(NamedTuple):
    """Recording that a page has opened.

    Attributes:
        size: size of the file when the process began to read it [bytes].
        process: process that reads the recording.
        painter: draws its pictures in the look of 1972.
        router: routes that play it.
        ready: task that ends when the recording is read.
    """

    size: int
    process: PlaybackProcess
    painter: ReplayPainter
    router: Router
    ready: asyncio.Task[None]


class Recordings:
    """Recordings in the folder of a station."""

    def __init__(self, folder: Path, present: Callable[[], Path | None]) -> None:
        """Serve `folder`; `present` returns the file of the present run, or None if this run is not recorded."""
        self._folder, self._present, self._index = folder, present, Index()
        self._open: dict[str, _Opened] = {}
        self._lock = asyncio.Lock()

    def routes(self) -> list[BaseRoute]:
        """Return the routes that serve the list of recordings and the playback pages."""
        return [Route("/recordings.json", self._listed), Mount("/replay/{file}", app=self._play)]

    def listed(self) -> tuple[Recorded, ...]:
        """Return the newest recordings, newest first, with what the list of recordings tells about them."""
        now = self._present()
        files = []
        for path in self._folder.glob("*.mcap"):
            try:
                files.append((path.stat().st_mtime, path))
            except OSError:
                continue  # the file was deleted after `glob` found it
        files.sort(reverse=True)
        entries = self._entries()
        return tuple(
            _recorded(path, changed, entries.get(str(path.absolute())), now=path == now)
            for changed, path in files[:MAX_LISTED]
        )

    def _entries(self) -> dict[str, Entry]:
        """Return the entries of the list of recordings by path; empty if the list cannot be read."""
        try:
            return {entry.path: entry for entry in self._index.entries()}
        except RecordingError:
            return {}

    async def close(self) -> None:
        """Close all recordings."""
        async with self._lock:
            for file in list(self._open):
                await self._close(file)

    async def _close(self, file: str) -> None:
        opened = self._open.pop(file)
        opened.painter.close()
        await opened.process.close()
        await asyncio.gather(opened.ready, return_exceptions=True)

    def _listed(self, _: Request) -> Response:
        body = msgspec.json.encode(self.listed())
        return Response(body, media_type="application/json", headers={"Cache-Control": "no-store"})

    async def _play(self, scope: Scope, receive: Receive, send: Send) -> None:
        file = str(scope["path_params"]["file"])
        app: ASGIApp
        try:
            app = await self._router(file, fresh=scope["path"].endswith("/recording/index.json"))
        except (OSError, ValueError, RecordingError) as error:
            app = PlainTextResponse(f"{file} cannot be played: {error}\n", 404)
        except asyncio.CancelledError:  # the server ends while the recording is read
            app = PlainTextResponse("the station has ended\n", 503)
        await app(scope, receive, send)

    async def _router(self, file: str, *, fresh: bool) -> Router:
        """Return the router that plays a recording, when the recording is read.

        Args:
            file: name of the recording, as the list shows it.
            fresh: true if a page opens the recording now. The file is then read again if its size has changed.

        Raises:
            RecordingError: the recording cannot be played.
            OSError: the file does not exist.
            ValueError: the name contains a character that no file's name can contain.
        """
        path = self._path(file)
        async with self._lock:
            size = path.stat().st_size
            opened = self._open.get(path.name)
            if opened is None or (fresh and (opened.size != size or opened.process.ended)):
                opened = await self._start(path, size)
        await asyncio.shield(opened.ready)
        return opened.router

    def _path(self, file: str) -> Path:
        """Return the path of the recording that the list names `file`.

        Raises:
            RecordingError: the name is not one of a recording in the folder.
        """
        path = self._folder / file
        if path.name != file or path.suffix != ".mcap":
            raise RecordingError("it is not a recording in this station's folder")
        if path.exists():
            return path
        return next((found for found in self._folder.glob("*.mcap") if encodable(found.name) == file), path)

    async def _start(self, path: Path, size: int) -> _Opened:
        """Begin to read a recording; close an older state of it, and the recordings beyond `MAX_OPEN`."""
        others = [file for file in self._open if file != path.name]
        for file in [*others[: max(0, len(others) + 1 - MAX_OPEN)], path.name]:
            if file in self._open:
                await self._close(file)
        process, painter = PlaybackProcess(path), ReplayPainter(path)
        router = Router(routes=Player(process, painter, f"{RECORDING_META}\n{STATION_META}").routes())
        opened = _Opened(size, process, painter, router, asyncio.create_task(process.ready()))
        self._open[path.name] = opened
        return opened


def _recorded(path: Path, changed: float, entry: Entry | None, *, now: bool) -> Recorded:
    """Return a file of the list; `changed` is the time of its last write [s since 1970]."""
    file, when = encodable(path.name), datetime.fromtimestamp(changed, UTC).isoformat()
    if entry is None:
        return Recorded(file, when, now, "", None, "", "")
    over = entry.ended != "recording"
    time_s, ended = (entry.time_s, entry.ended) if over else (None, "")
    return Recorded(file, when, now, entry.title, time_s, ended, entry.grade)
