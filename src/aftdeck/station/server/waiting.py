"""Pages that wait for a station's first session: they receive lines of progress, or the reason for a failure."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable

from starlette.websockets import WebSocket

from aftdeck.station.messages import to_page
from aftdeck.station.server.page import MAX_PAGES, TOO_MANY_PAGES, goodbye, send
from aftdeck.station.server.pages import Pages
from aftdeck.station.session.preparation import Preparation


class Waiting:
    """Pages that wait until the station's first session is made.

    Attributes:
        pages: pages of the session; None until the session is made.
    """

    def __init__(self, preparation: Preparation, failed: Callable[[], None], *, for_page: bool) -> None:
        self.pages: Pages | None = None
        self._preparation, self._failed, self._for_page = preparation, failed, for_page
        self._number = 0
        self._fresh = asyncio.Event()

    @property
    def phase(self) -> str:
        """Phase of the station: ``preparing``, ``failed``, or the phase of the session's driver."""
        if self.pages:
            return self.pages.driver.phase.value
        return "failed" if self._preparation.error else "preparing"

    def start(self) -> None:
        """Start the preparation; if the session exists already, start the session."""
        loop = asyncio.get_running_loop()

        def notify() -> None:
            with contextlib.suppress(RuntimeError):  # the loop is closing
                loop.call_soon_threadsafe(self._changed)

        if self._preparation.session is None:
            self._preparation.start(notify)
        else:
            self._changed()

    def _changed(self) -> None:
        """Start the session if it exists, and wake the waiting pages. Call `failed` if the preparation has failed."""
        loop, session = asyncio.get_running_loop(), self._preparation.session
        if session is not None and self.pages is None:

            def notify() -> None:
                with contextlib.suppress(RuntimeError):  # the loop is closing
                    loop.call_soon_threadsafe(pages.wake)

            pages = self.pages = Pages(session, notify, for_page=self._for_page)
            pages.start()
        self._fresh.set()
        self._fresh = asyncio.Event()
        if self._preparation.error is not None:
            self._failed()

    async def until_ready(self, socket: WebSocket) -> Pages | None:
        """Send a page the lines of progress until the session is made.

        Returns:
            The pages of the session; None if the connection was closed. It is closed if the preparation failed or too
            many pages wait.
        """
        if self.pages is None and self._number >= MAX_PAGES:
            await goodbye(socket, TOO_MANY_PAGES)
            return None
        self._number += 1
        try:
            while self.pages is None:
                fresh = self._fresh  # get the event before the text, so that no later change is missed
                if self._preparation.error is not None:
                    await goodbye(socket, self._preparation.failure)
                    return None
                await send(socket, to_page.Preparing(self._preparation.text))
                await fresh.wait()
        finally:
            self._number -= 1
        return self.pages
