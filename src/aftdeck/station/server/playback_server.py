"""Server that plays one recording in the page."""

from __future__ import annotations

import contextlib
from collections.abc import AsyncIterator
from pathlib import Path

from starlette.applications import Starlette

from aftdeck.lines import print_line
from aftdeck.station.built import built_page
from aftdeck.station.playback.answers import Answers
from aftdeck.station.playback.store import PlaybackStore
from aftdeck.station.server.access import LOCAL, Access, access_of
from aftdeck.station.server.own import keep_to_own
from aftdeck.station.server.player import PlayedHere, Player
from aftdeck.station.server.replay_painter import ReplayPainter
from aftdeck.station.server.serve import addresses_of, listen, make_server, run_server

LARGE = 10_000_000
"""Size above which a recording takes more than a few seconds to read [bytes]."""


def serve_recording(path: Path, *, host: str, port: int, names: tuple[str, ...] = (), open_browser: bool) -> None:
    """Serve a recording to the page until interrupted; print the page's address when the recording is ready.

    Raises:
        RecordingError: the recording cannot be read.
        StationError: the page was not built, or the server cannot listen on the address.
    """
    built_page()
    if path.is_file() and path.stat().st_size > LARGE:
        print_line(f"Reading {path.name}.")
    with listen(host, port) as listener, PlaybackStore(path) as store:
        access = access_of(listener, host, names, fly=False)
        ((_, address),) = addresses_of(listener, access, host, names)
        print_line(f"Aftdeck replay: {address}")
        print_line(f"Playing {path.name}. End with Ctrl+C.")
        server = make_server(replay_app(store, path, access))
        run_server(server, listener, address if open_browser else None)


def replay_app(store: PlaybackStore, path: Path, access: Access = LOCAL) -> Starlette:
    """Return the web app that serves a recording."""
    answers = Answers(store, path)
    painter = ReplayPainter(path)
    player = Player(PlayedHere(answers), painter)

    @contextlib.asynccontextmanager
    async def lifespan(_: Starlette) -> AsyncIterator[None]:
        answers.check()
        yield
        painter.close()

    return keep_to_own(Starlette(routes=player.routes(), lifespan=lifespan), access)
