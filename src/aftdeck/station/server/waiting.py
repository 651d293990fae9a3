"""Pages that wait for a station's first session: they are sent its lines of progress, or the error that ends it."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable

from starlette.websockets import WebSocket

from aftdeck.station.messages import to_page
from aftdeck.station.server.page import MOST_PAGES, goodbye, send
from aftdeck.station.server.pages import Pages
from aftdeck.station.session.preparation import Preparation


class Waiting:
    """Waiting pages, until the session is made.

    Attributes:
        pages: pages of the session; None until it is made.
    """

    def __init__(self, coming: Preparation, failed: Callable[[], None]) -> None:
        self.pages: Pages | None = None
        self._coming, self._failed = coming, failed
        self._number = 0
        self._fresh = asyncio.Event()

    @property
    def phase(self) -> str:
        """Phase of the station: ``preparing``, ``failed``, or that of its session."""
        if self.pages:
            return self.pages.driver.phase.value
        return "failed" if self._coming.error else "preparing"

    def start(self) -> None:
        """Start the preparation, unless the session is made already."""
        loop = asyncio.get_running_loop()

        def notify() -> None:
            with contextlib.suppress(RuntimeError):  # the loop is closing
                loop.call_soon_threadsafe(self._changed)

        if self._coming.session is None:
            self._coming.start(notify)
        else:
            self._changed()

    def _changed(self) -> None:
        """Wake the waiting pages; start the session if it has been made."""
        loop, session = asyncio.get_running_loop(), self._coming.session
        if session is not None and self.pages is None:

            def notify() -> None:
                with contextlib.suppress(RuntimeError):  # the loop is closing
                    loop.call_soon_threadsafe(pages.wake)

            pages = self.pages = Pages(session, notify)
            pages.start()
        self._fresh.set()
        self._fresh = asyncio.Event()
        if self._coming.error is not None:
            self._failed()

    async def until_ready(self, socket: WebSocket) -> Pages | None:
        """Send a page the lines of progress until the session is made; None after a goodbye.

        A page gets a goodbye if the preparation fails or too many pages wait.
        """
        if self.pages is None and self._number >= MOST_PAGES:
            await goodbye(socket, f"{MOST_PAGES} pages are connected already")
            return None
        self._number += 1
        try:
            while self.pages is None:
                fresh = self._fresh  # read before the news, so that no later change is missed
                if self._coming.error is not None:
                    await goodbye(socket, self._coming.failure)
                    return None
                await send(socket, to_page.Preparing(self._coming.text))
                await fresh.wait()
        finally:
            self._number -= 1
        return self.pages
