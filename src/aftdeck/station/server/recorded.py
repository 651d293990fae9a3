"""Web routes that list the recordings of a station and play them."""

from __future__ import annotations

from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path
from threading import Lock

import msgspec
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import BaseRoute, Mount, Route, Router
from starlette.types import ASGIApp, Receive, Scope, Send

from aftdeck.errors import RecordingError
from aftdeck.station.messages.playback import Recorded
from aftdeck.station.playback.store import PlaybackStore
from aftdeck.station.server.player import RECORDING_META, STATION_META, Player

MAX_LISTED = 50
"""Maximum number of recordings in the list; older ones are omitted."""
MAX_OPEN = 3
"""Maximum number of open recordings. Before another one is opened, the one that was opened first is closed."""


class Recordings:
    """Recordings in the folder of a station."""

    def __init__(self, folder: Path, present: Callable[[], Path | None]) -> None:
        """Serve `folder`; `present` returns the file of the present run, or None if this run is not recorded."""
        self._folder, self._present = folder, present
        self._open: dict[tuple[str, int], tuple[Player, Router]] = {}
        self._lock = Lock()

    def routes(self) -> list[BaseRoute]:
        """Return the routes that serve the list of recordings and the playback pages."""
        return [Route("/recordings.json", self._listed), Mount("/replay/{file}", app=self._play)]

    def listed(self) -> tuple[Recorded, ...]:
        """Return the newest recordings, newest first."""
        now = self._present()
        files = []
        for path in self._folder.glob("*.mcap"):
            try:
                files.append((path.stat().st_mtime, path))
            except OSError:
                continue  # the file was deleted after `glob` found it
        files.sort(reverse=True)
        return tuple(
            Recorded(path.name, datetime.fromtimestamp(changed, UTC).isoformat(), path == now)
            for changed, path in files[:MAX_LISTED]
        )

    def close(self) -> None:
        """Close all recordings."""
        with self._lock:
            for player, _ in self._open.values():
                player.close()
            self._open.clear()

    def _listed(self, _: Request) -> Response:
        body = msgspec.json.encode(self.listed())
        return Response(body, media_type="application/json", headers={"Cache-Control": "no-store"})

    async def _play(self, scope: Scope, receive: Receive, send: Send) -> None:
        file = str(scope["path_params"]["file"])
        app: ASGIApp
        try:
            app = await run_in_threadpool(self._router, file, fresh=scope["path"].endswith("/recording/index.json"))
        except (OSError, RecordingError) as error:
            app = PlainTextResponse(f"{file} cannot be played: {error}\n", 404)
        await app(scope, receive, send)

    def _router(self, file: str, *, fresh: bool) -> Router:
        """Return the router that plays a recording.

        Args:
            file: name of the recording's file.
            fresh: true if a page opens the recording now. The file is then read again if its size has changed.

        Raises:
            RecordingError: the recording cannot be played.
            OSError: the file does not exist.
        """
        path = self._folder / file
        if path.name != file or path.suffix != ".mcap":
            raise RecordingError("it is not a recording in this station's folder")
        with self._lock:
            size = path.stat().st_size
            known = [key for key in self._open if key[0] == file]
            if known and (not fresh or known[-1][1] == size):
                return self._open[known[-1]][1]
            player = Player(PlaybackStore(path), path, f"{RECORDING_META}\n{STATION_META}")
            for key in [*known, *list(self._open)[: max(0, len(self._open) + 1 - MAX_OPEN)]]:
                if key in self._open:
                    self._open.pop(key)[0].close()
            self._open[file, size] = player, Router(routes=player.routes())
            player.check()
            return self._open[file, size][1]
