"""Pages of the direct host, used as those of a server: a page that waits lets the session make its next step."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from contextlib import contextmanager

from aftdeck.station.core.direct import Direct
from aftdeck.station.messages import from_page, to_page
from tests.loaded import scenario
from tests.station.pages import Flier


class DirectStation:
    """Session in the direct host, with its pages."""

    def __init__(self) -> None:
        self.host = Direct(scenario())
        self.session = self.host.core

    @contextmanager
    def page(self) -> Iterator[DirectTestPage]:
        """Yield a page that has joined."""
        page = DirectTestPage(self.host)
        try:
            yield page
        finally:
            self.host.leave(page.page)


class DirectTestPage(Flier):
    """Page of the direct host."""

    def __init__(self, host: Direct) -> None:
        super().__init__()
        self.host, self.page = host, host.join()
        self._received: deque[to_page.FromServer] = deque()

    def send(self, message: from_page.FromPage) -> None:
        """Send a message."""
        self.page.send(message)

    def receive(self) -> to_page.FromServer:
        """Return the next message; if there is none, let the session make its next step."""
        while not self._received:
            self._received += self.page.receive()
            if not self._received:
                self.host.step()
        return self._received.popleft()
