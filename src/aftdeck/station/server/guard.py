"""Limits of the server: number of connections, time for a request, and messages of a page before they are decoded.

The classes extend uvicorn's protocols. They drop what exceeds a limit before it costs time: a flood that is decoded
first delays the frames of all pages.
"""

from __future__ import annotations

import asyncio
from typing import Any

import h11
import msgspec
from uvicorn.protocols.http.h11_impl import H11Protocol
from uvicorn.protocols.websockets.websockets_sansio_impl import WebSocketsSansIOProtocol
from websockets.exceptions import InvalidState
from websockets.frames import Frame

from aftdeck.station.messages import to_page
from aftdeck.station.server.allowance import Allowance
from aftdeck.station.server.terse_log import log

MAX_CONNECTIONS = 96
"""Maximum number of connections. A process may often open only 256 files; the station itself needs about 40."""
BACKLOG = 16
"""Maximum number of connections that are accepted at once, before the first of them is counted."""
MAX_REQUEST = 16_384
"""Maximum length of a request's first line and headers [bytes]."""
REQUEST_WITHIN = 10.0
"""Time within which a request's headers must arrive completely [s]."""
SENT_WITHIN = 60.0
"""Time within which a client must receive the end of an answer [s]."""
MESSAGES_PER_SECOND = 500.0
"""Messages that a page may send over a long time [1/s]. A page sends sticks with each picture: up to 240 a second."""
MESSAGES_AT_ONCE = 500.0
"""Messages that a page may send at once; after a gap of a second in the network, a second's messages arrive at once."""
PENALTY = 5.0
"""Time for which a page that has sent too many messages is not read; then its connection is closed [s].

If the connection were closed at once, the page would connect and flood again at once.
"""
FAREWELL = 2.0
"""Time that a page has to close its side of the connection [s]."""
SLICE = 4096
"""Number of bytes after which the messages are counted; the decoding of more cannot be interrupted."""
TOO_FAST = f"a page may send at most {MESSAGES_PER_SECOND:g} messages a second"

_encode = msgspec.json.Encoder().encode


class GuardedHttp(H11Protocol):
    """HTTP connection with a time limit for each request; the newest connection is never the one that must give way."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self.opened = self.loop.time()
        self.aborted = False
        self._limit: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Close another connection if there are too many, and wait for a request."""
        super().connection_made(transport)
        make_room(self.connections)
        self._begin_limit(REQUEST_WITHIN)

    def connection_lost(self, exc: Exception | None) -> None:
        """End the connection."""
        self._end_limit()
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        """Pass on data; the time limit ends when a request is complete, or when a WebSocket takes over."""
        super().data_received(data)
        if self.busy or self not in self.connections:
            self._end_limit()

    def on_response_complete(self) -> None:
        """Wait for the client to receive the answer and to send the next request."""
        super().on_response_complete()
        if not self.busy:
            self._begin_limit(SENT_WITHIN if self.transport.get_write_buffer_size() else REQUEST_WITHIN)

    def send_400_response(self, msg: str) -> None:
        """Answer an invalid request; while another answer is being sent, only close the connection.

        If the body of the request is invalid, its answer may still be in preparation; this answer is dropped.
        """
        if self.busy:
            self.cycle.disconnected = True
        try:
            super().send_400_response(msg)
        except h11.LocalProtocolError:
            self.transport.close()
        self._begin_limit(FAREWELL)

    @property
    def busy(self) -> bool:
        """Whether a request is being answered."""
        return self.cycle is not None and not self.cycle.response_complete  # type: ignore[redundant-expr]

    @property
    def is_page(self) -> bool:
        """Whether this is the connection of a page."""
        return False

    def _begin_limit(self, seconds: float) -> None:
        self._end_limit()
        self._limit = self.loop.call_later(seconds, self._exceeded)

    def _end_limit(self) -> None:
        if self._limit is not None:
            self._limit.cancel()
            self._limit = None

    def _exceeded(self) -> None:
        if not self.transport.is_closing():
            log.warning("closed a connection: no complete request within %g s", REQUEST_WITHIN)
        abort(self)


class GuardedSocket(WebSocketsSansIOProtocol):
    """WebSocket connection with a limit on the rate of messages, which are counted before they are decoded."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self.opened = self.loop.time()
        self.aborted = self.busy = False
        self._greeted = self._too_fast = False
        self._messages = Allowance(MESSAGES_PER_SECOND, MESSAGES_AT_ONCE)

    @property
    def is_page(self) -> bool:
        """Whether a page has sent its first message, and its connection is not being closed."""
        return self._greeted and not self._too_fast and not self.close_sent

    def data_received(self, data: bytes) -> None:
        """Decode data until its messages exceed their rate."""
        for start in range(0, len(data), SLICE):
            if self._too_fast or self.transport.is_closing():
                return
            super().data_received(data[start : start + SLICE])

    def handle_text(self, event: Frame) -> None:
        """Count and pass on the beginning of a text message."""
        if self._counted():
            super().handle_text(event)

    def handle_bytes(self, event: Frame) -> None:
        """Count and pass on the beginning of a binary message."""
        if self._counted():
            super().handle_bytes(event)

    def handle_cont(self, event: Frame) -> None:
        """Count and pass on a further part of a message."""
        if self._counted():
            super().handle_cont(event)

    def handle_ping(self) -> None:
        """Count and answer a ping."""
        if self._counted():
            super().handle_ping()

    def handle_pong(self, event: Frame) -> None:
        """Count and pass on a pong."""
        if self._counted():
            super().handle_pong(event)

    def send_receive_event_to_app(self) -> None:
        """Pass on a complete message; close the connection if its text is not valid UTF-8."""
        self._greeted = True
        if self.curr_msg_data_type == "text":
            try:
                b"".join(self.frames).decode()
            except UnicodeDecodeError:
                self.conn.send_close(1007, "text must be UTF-8")
                self.handle_parser_exception()
                return
        super().send_receive_event_to_app()

    def handle_parser_exception(self) -> None:
        """Close the connection after data that are not valid; answer a handshake that is not valid."""
        if self.conn.close_sent is not None:
            super().handle_parser_exception()
        else:
            self.transport.write(b"HTTP/1.1 400 Bad Request\r\nConnection: close\r\nContent-Length: 0\r\n\r\n")
            self.handshake_complete = self.close_sent = True
            self.transport.close()

    def keepalive_timeout(self) -> None:
        """Close a connection whose client does not answer, and abort it if the client does not read either."""
        super().keepalive_timeout()
        self.loop.call_later(FAREWELL, abort, self)

    def _counted(self) -> bool:
        """Count a message, and return whether it is allowed; stop to read a page that sends too many."""
        if not self._too_fast and not self._messages.take():
            self._too_fast = True
            log.warning("a page is not read for %g s: %s", PENALTY, TOO_FAST)
            self.transport.pause_reading()
            self.read_paused = False  # so that `receive` does not resume reading
            while not self.queue.empty():
                self.queue.get_nowait()
            self.queue.put_nowait({"type": "websocket.disconnect", "code": 1008})
            # While this timer is set, uvicorn does not close the connection when the page's task ends.
            self.close_timer = self.loop.call_later(PENALTY, self._dismiss)
        return not self._too_fast

    def _dismiss(self) -> None:
        """Tell the page why its connection is closed, and close it."""
        if not self.transport.is_closing() and not self.close_sent:
            try:
                self.conn.send_text(_encode(to_page.Refused(-1, TOO_FAST)))
                self.conn.send_close(1008, TOO_FAST)
            except InvalidState:
                pass  # the page has closed its side
            self.transport.write(b"".join(self.conn.data_to_send()))
            self.close_sent = True
            self.transport.resume_reading()  # `data_received` drops the data; the page can then read the reason
        self.close_timer = self.loop.call_later(FAREWELL, abort, self)


Guarded = GuardedHttp | GuardedSocket


def make_room(connections: set[Any]) -> None:
    """Abort a connection if there are more than `MAX_CONNECTIONS`.

    Connections of pages are kept. Of the others, a connection that is being closed goes first, then the one that has
    waited longest for a request, then the one that has been answered longest. So a page can always be loaded again.
    """
    counted: list[Guarded] = [one for one in connections if not one.aborted]
    others = [one for one in counted if not one.is_page]
    if len(counted) > MAX_CONNECTIONS and others:
        log.warning("closed a connection without a page: more than %d connections", MAX_CONNECTIONS)
        abort(min(others, key=lambda one: (not one.transport.is_closing(), one.busy, one.opened)))


def abort(connection: Guarded) -> None:
    """Close a connection at once; data not yet sent are lost."""
    connection.aborted = True
    connection.transport.abort()
