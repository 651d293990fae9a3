"""Pages of the direct host, used as those of a server: a page that waits lets the session make its next step."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TypeVar

import pytest

from aftdeck.scenario.model import Scenario
from aftdeck.station.core.direct import Direct
from aftdeck.station.messages import from_page, to_page
from aftdeck.station.messages.frame import Frame
from aftdeck.tuples import Vec3
from tests.loaded import scenario

MAX_STEPS = 5000
"""Most steps for which a page waits: a hundred seconds of a run."""
STILL = (0.0, 0.0, 0.0)

_M = TypeVar("_M", bound=to_page.FromServer)


class DirectStation:
    """Session in the direct host, with its pages."""

    def __init__(self, made: Scenario | None = None) -> None:
        self.host = Direct(scenario() if made is None else made)
        self.session = self.host.core

    @contextmanager
    def page(self, *, may_fly: bool = True) -> Iterator[DirectTestPage]:
        """Yield a page that has joined."""
        page = DirectTestPage(self.host, may_fly=may_fly)
        try:
            yield page
        finally:
            self.host.leave(page.page)


class DirectTestPage:
    """Page whose methods are those of `pages.Page`."""

    def __init__(self, host: Direct, *, may_fly: bool) -> None:
        self.host, self.seq = host, -1
        self.page = host.join(may_fly=may_fly)
        self._received: deque[to_page.FromServer] = deque()

    def next_seq(self) -> int:
        self.seq += 1
        return self.seq

    def send(self, message: from_page.FromPage) -> None:
        """Send a message, and note its number."""
        self.seq = max(self.seq, message.seq)
        self.page.send(message)

    def push(self, translation: Vec3 = STILL, rotation: Vec3 = STILL, drive: float = 0.0) -> int:
        """Send stick deflections, and return the number of the message."""
        seq = self.next_seq()
        self.send(from_page.Sticks(seq, translation, rotation, drive))
        return seq

    def wait_for(self, kind: type[_M], condition: Callable[[_M], bool] = lambda _: True) -> _M:
        """Return the next message of type `kind` that `condition` accepts."""
        for _ in range(MAX_STEPS):
            while self._received:
                message = self._received.popleft()
                if isinstance(message, kind) and condition(message):
                    return message
            self._received += self.page.receive()
            if not self._received:
                self.host.step()
        pytest.fail(f"no such {kind.__name__} within {MAX_STEPS} steps")

    def flown(self, seq: int) -> Frame:
        """Return the first frame whose `stick_seq` has reached this number."""
        return self.wait_for(Frame, lambda frame: frame.display.stick_seq >= seq)

    def rejection(self) -> str:
        return self.wait_for(to_page.Refused).text
