"""What is new in a session for one of its pages, as messages."""

from __future__ import annotations

from collections.abc import Iterator

import msgspec

from aftdeck.station.core.core import Core
from aftdeck.station.core.desk import Page
from aftdeck.station.core.recent import Mark
from aftdeck.station.messages import to_page

_encode = msgspec.json.Encoder().encode


class News:
    """What a page has not received yet: welcome, role, log, last minutes, and the newest frame.

    Older frames are left out; log and last minutes are as late as the link makes them. A page that draws strips
    receives a frame only together with a new sample of the strips.
    """

    def __init__(self, page: Page, *, may_fly: bool, strips: bool) -> None:
        """Begin with a page that has received nothing.

        Args:
            page: the page, as its host names it.
            may_fly: whether the page may take control.
            strips: whether it draws strips.
        """
        self._page, self._may_fly, self._strips = page, may_fly, strips
        self._role: to_page.Role | None = None
        self._mark: Mark | None = None
        self._begin(None)

    def _begin(self, core: Core | None) -> None:
        self._core, self._lines, self._sent = core, 0, b""
        self._changed = b""

    def of(self, core: Core) -> Iterator[bytes]:
        """Yield what is new, each message encoded as JSON."""
        yield from self.welcome(core)
        yield from self.role(core)
        yield from self.run(core)

    def welcome(self, core: Core) -> Iterator[bytes]:
        """Yield the welcome, if the page has not received that of this core, and what has changed in it in flight."""
        if core is not self._core:
            self._begin(core)
            yield _encode(core.welcome)
        if core.changed is not self._changed:
            self._changed = core.changed
            yield core.changed

    def role(self, core: Core) -> Iterator[bytes]:
        """Yield the page's role, if it is new."""
        role = core.desk.role(self._page, may_fly=self._may_fly)
        if role != self._role:
            self._role = role
            yield _encode(role)

    def run(self, core: Core) -> Iterator[bytes]:
        """Yield new lines of the log, new samples of the strips, and the newest frame."""
        if events := core.log.since(self._lines):
            self._lines += len(events)
            yield _encode(to_page.Events(events))
        recent = core.telemetry.recent.news(self._mark) if self._strips else None
        if recent:
            message, self._mark = recent
            yield _encode(message)
        if (frame := core.newest) is not self._sent and (recent or not self._strips):
            self._sent = frame
            yield frame
