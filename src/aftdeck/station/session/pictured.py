"""Frames of a session that pictures show, now or later."""

from __future__ import annotations

import threading
from collections import deque

from aftdeck.station.messages.frame import LinkSteps
from aftdeck.station.session.painting import LitFrame


class Pictured:
    """Frames of the steps that pictures show when the link lets them through. Any thread may ask for them."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._frames: deque[LitFrame] = deque()
        self._link: LinkSteps | None = None

    def add(self, lit: LitFrame, link: LinkSteps) -> None:
        """Add the frame of a new step, and drop those that no picture will show any more."""
        earliest = min(link.pictures, *(shown for _, shown in link.cameras), link.step)
        with self._lock:
            self._link = link
            self._frames.append(lit)
            while len(self._frames) > 1 and self._frames[1].step <= earliest:
                self._frames.popleft()

    def of(self, camera: str) -> LitFrame | None:
        """Return the frame that the picture of a camera shows: the first one until one has arrived; None before it."""
        with self._lock:
            if self._link is None:
                return None
            shown = self._link.of(camera)
            return next((lit for lit in reversed(self._frames) if lit.step <= shown), self._frames[0])
