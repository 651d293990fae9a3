"""Raw connections to a station, and the processes that load it: ``python -m benchmarks.load KIND ADDRESS [PATH]``.

Messages are encoded in advance and sent over plain sockets, so that the load needs little of the processor itself.
"""

from __future__ import annotations

import contextlib
import itertools
import json
import os
import selectors
import socket
import sys
import time
from collections.abc import Callable, Iterator

from aftdeck.station.messages.kinds import PROTOCOL

NICE = 10
"""Difference between the priorities of a loading process and of the station."""
WATCHERS = 8
FLOOD = 20_000
"""Messages that the flooding page sends [1/s]."""
SLICE = 0.02
"""Time between two parts of the flood [s]."""
LIVES = 3
"""Time for which the flooding page has messages [s]; then it disconnects."""
ASKED = 400.0
"""Messages of the page that asks for pictures [1/s]: less than a page may send."""
CAMERAS = (("A", "B", "C", "D"), ("WR", "ELB", "A", "D"))
"""Cameras whose pictures that page asks for, in turn."""
SLOW = 40
"""Pages that read slowly; the station accepts 32."""
SLOW_READS = 2.0
"""Times that each of them reads [1/s]."""
_TEXT, _CLOSE, _PING, _PONG = 1, 8, 9, 10


class Wire:
    """WebSocket connection of a page, without a library."""

    def __init__(self, address: str, timeout: float = 60.0, receive_bytes: int | None = None) -> None:
        """Connect and send `hello`; `receive_bytes` limits the buffer of the socket."""
        host, _, port = address.rpartition(":")
        self.socket = socket.socket()
        self.socket.settimeout(timeout)
        if receive_bytes is not None:
            self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, receive_bytes)
        self.socket.connect((host, int(port)))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._buffer = bytearray()
        try:
            self.socket.sendall(
                f"GET /ws HTTP/1.1\r\nHost: {address}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Version: 13\r\n\r\n".encode()
            )
            while b"\r\n\r\n" not in self._buffer:
                self._receive()
        except OSError:
            self.socket.close()
            raise
        del self._buffer[: self._buffer.index(b"\r\n\r\n") + 4]
        self.socket.sendall(text({"type": "hello", "protocol": PROTOCOL}))

    def _receive(self) -> None:
        if not (data := self.socket.recv(1 << 18)):
            raise ConnectionResetError("the station has closed the connection")
        self._buffer += data

    def messages(self) -> Iterator[bytes]:
        """Wait for data; yield the complete messages, and answer pings.

        Raises:
            ConnectionResetError: the station has closed the connection.
        """
        self._receive()
        while len(self._buffer) >= 2:
            length, start = self._buffer[1] & 127, 2
            if length >= 126:
                start = 4 if length == 126 else 10
                length = int.from_bytes(self._buffer[2:start], "big")
            if len(self._buffer) < start + length:
                return
            kind, body = self._buffer[0] & 15, bytes(self._buffer[start : start + length])
            del self._buffer[: start + length]
            if kind == _PING:
                self.socket.sendall(_frame(_PONG, body))
            elif kind == _CLOSE:
                raise ConnectionResetError(body[2:].decode())
            else:
                yield body


def text(message: dict[str, object]) -> bytes:
    """Return a message as a masked WebSocket frame."""
    return _frame(_TEXT, json.dumps(message, separators=(",", ":")).encode())


def _frame(kind: int, body: bytes) -> bytes:
    size = bytes([128 | len(body)]) if len(body) < 126 else b"\xfe" + len(body).to_bytes(2, "big")
    return bytes([128 | kind]) + size + bytes(4) + body  # a mask of zeros leaves the body unchanged


def watch(address: str) -> None:
    """Receive and drop the frames of `WATCHERS` pages."""
    with selectors.DefaultSelector() as selector:
        for _ in range(WATCHERS):
            wire = Wire(address)
            selector.register(wire.socket, selectors.EVENT_READ, wire)
        while True:
            for key, _ in selector.select():
                for _ in key.data.messages():
                    pass


def flood(address: str) -> None:
    """Send `FLOOD` messages per second; connect again at once whenever the station closes the connection."""
    steps = round(LIVES / SLICE)
    each = round(FLOOD * SLICE)
    still: list[dict[str, object]] = [
        {"type": "sticks", "translation": [0, 0, 0], "rotation": [0, 0, 0], "drive": 0},
        {"type": "ask_sticks"},
        {"type": "leave_seat"},
        {"type": "take_seat"},
    ]
    parts = [
        b"".join(text({**still[k % 4], "seq": k}) for k in range(step * each, (step + 1) * each))
        for step in range(steps)
    ]
    while True:
        with contextlib.suppress(OSError):
            wire = Wire(address)
            with wire.socket:
                _send_at_pace(wire, parts)


def _send_at_pace(wire: Wire, parts: list[bytes]) -> None:
    """Send a part every `SLICE`, and drop what the station sends."""
    wire.socket.setblocking(False)
    due, waiting = time.perf_counter(), memoryview(b"")
    for part in parts:
        due += SLICE
        waiting = memoryview(bytes(waiting) + part) if waiting else memoryview(part)
        while (left := due - time.perf_counter()) > 0.0:
            with contextlib.suppress(BlockingIOError):
                if not wire.socket.recv(1 << 18):
                    raise ConnectionResetError
            if waiting:
                with contextlib.suppress(BlockingIOError):
                    waiting = waiting[wire.socket.send(waiting) :]
            time.sleep(min(0.002, left))
        while len(waiting) > 2 * len(part):  # the station reads no more
            time.sleep(0.01)
            with contextlib.suppress(BlockingIOError):
                if not wire.socket.recv(1 << 18):
                    raise ConnectionResetError
            with contextlib.suppress(BlockingIOError):
                waiting = waiting[wire.socket.send(waiting) :]


def replay(address: str, path: str) -> None:
    """Open a recording's page at `path` again and again: its index, and its first blocks."""
    while True:
        for part in ("index.json", "blocks/0", "blocks/1", "verdict.json"):
            get(address, f"{path}recording/{part}")


def sheets(address: str) -> None:
    """Ask for one sheet after another, as the window of a camera's planes does."""
    while True:
        get(address, "/planes/A.svg")


def polygons(address: str) -> None:
    """As an observer, ask for pictures in the look of 1972 of other cameras `ASKED` times a second."""
    wire = Wire(address)
    wire.socket.setblocking(False)
    due = time.perf_counter()
    for seq in itertools.count():
        due += 1.0 / ASKED
        pictures = [{"camera": name, "aspect": 1.0 + 0.01 * (seq % 90)} for name in CAMERAS[seq % 2]]
        _drop_until(wire, due)
        with contextlib.suppress(BlockingIOError):
            wire.socket.send(text({"type": "show_polygons", "seq": seq, "pictures": pictures}))


def slow(address: str) -> None:
    """Connect `SLOW` pages that read a few bytes now and then."""
    wires = []
    for _ in range(SLOW):
        with contextlib.suppress(OSError):
            wires.append(Wire(address, receive_bytes=4096))
    for wire in itertools.cycle(wires):
        time.sleep(1.0 / (SLOW * SLOW_READS))
        with contextlib.suppress(OSError):
            wire.socket.recv(1024)


def _drop_until(wire: Wire, due: float) -> None:
    """Drop what the station sends until a time."""
    while (left := due - time.perf_counter()) > 0.0:
        with contextlib.suppress(BlockingIOError):
            if not wire.socket.recv(1 << 18):
                raise ConnectionResetError("the station has closed the connection")
        time.sleep(min(0.002, left))


def get(address: str, path: str) -> int:
    """Request a path and drop the answer; return its status, or 0 without an answer."""
    host, _, port = address.rpartition(":")
    head = b""
    with contextlib.suppress(OSError), socket.create_connection((host, int(port)), 600.0) as link:
        link.sendall(f"GET {path} HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\n\r\n".encode())
        while data := link.recv(1 << 18):
            head = head or data
    return int(head.split(None, 2)[1]) if head else 0


KINDS: dict[str, Callable[..., None]] = {
    "watch": watch,
    "flood": flood,
    "replay": replay,
    "sheets": sheets,
    "polygons": polygons,
    "slow": slow,
}


if __name__ == "__main__":
    os.nice(NICE)
    KINDS[sys.argv[1]](*sys.argv[2:])
