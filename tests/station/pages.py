"""A served session and pages that talk to it over real sockets."""

from __future__ import annotations

import time
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from http.client import HTTPConnection
from threading import Thread
from typing import TypeVar

import msgspec
import pytest
from starlette.applications import Starlette
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Origin

from aftdeck.station.messages import from_page, kinds, to_page
from aftdeck.station.messages.frame import Frame
from aftdeck.station.messages.welcome import Welcome
from aftdeck.station.server.access import LOCAL, Access
from aftdeck.station.server.app import make_app
from aftdeck.station.server.serve import listen, make_server
from aftdeck.station.session.preparation import ready
from aftdeck.station.session.session import Session
from aftdeck.tuples import Vec3
from tests.loaded import scenario
from tests.waits import WAIT_S

LATE_S = 0.5
"""Allowed delay of a series of frames [s]."""
STILL = (0.0, 0.0, 0.0)

_messages: msgspec.json.Decoder[to_page.FromServer] = msgspec.json.Decoder(to_page.FromServer)
_M = TypeVar("_M", bound=msgspec.Struct)


def text_of(message: msgspec.Struct) -> str:
    """Return a message as JSON text."""
    return msgspec.json.encode(message).decode()


def until(condition: Callable[[], bool], what: str) -> None:
    """Wait until `condition` returns True; `what` names the condition."""
    end = time.monotonic() + WAIT_S
    while not condition():
        assert time.monotonic() < end, f"not within {WAIT_S:g} s: {what}"
        time.sleep(0.002)


def in_time(start: float, steps: int) -> bool:
    """Return whether `steps` control steps since the time `start` [s] have taken no longer than expected.

    A busy machine delays some series of steps; a fault delays every series. A test therefore repeats the series (see
    `until`) and passes when one series is not delayed.
    """
    return time.monotonic() - start < steps * scenario().control_period + LATE_S


class Flier(ABC):
    """Page of a test that sends sticks and commands, and waits for messages.

    Attributes:
        seq: number of the last message; -1 before the first one.
    """

    def __init__(self) -> None:
        self.seq = -1

    @abstractmethod
    def send(self, message: from_page.FromPage) -> None:
        """Send a message."""

    @abstractmethod
    def receive(self) -> to_page.FromServer:
        """Return the next message."""

    def next_seq(self) -> int:
        self.seq += 1
        return self.seq

    def push(self, translation: Vec3 = STILL, rotation: Vec3 = STILL, drive: float = 0.0) -> int:
        """Send stick deflections, and return the number of the message."""
        seq = self.next_seq()
        self.send(from_page.Sticks(seq, translation, rotation, drive))
        return seq

    def wait_for(self, kind: type[_M], condition: Callable[[_M], bool] = lambda _: True) -> _M:
        """Return the next message of type `kind` that `condition` accepts."""
        end = time.monotonic() + WAIT_S
        while True:
            message = self.receive()
            if isinstance(message, kind) and condition(message):
                return message
            assert time.monotonic() < end, f"no such {kind.__name__} within {WAIT_S:g} s"

    def flown(self, seq: int) -> Frame:
        """Return the first frame whose `stick_seq` has reached this number."""
        return self.wait_for(Frame, lambda frame: frame.display.stick_seq >= seq)

    def rejection(self) -> str:
        return self.wait_for(to_page.Refused).text


class Page(Flier):
    """Page that the server cannot distinguish from a page in a browser."""

    def __init__(self, socket: ClientConnection) -> None:
        super().__init__()
        self.socket = socket

    def send(self, message: msgspec.Struct | str | bytes) -> None:
        """Send a message, or any text or bytes."""
        self.socket.send(message if isinstance(message, str | bytes) else text_of(message))

    def receive(self) -> to_page.FromServer:
        """Return the next message."""
        return _messages.decode(self.socket.recv(timeout=WAIT_S))

    def is_answered(self, steps: int) -> bool:
        """Answer the frames of `steps` control steps with stick messages; return whether the frames arrive in time."""
        first, start = self.flown(self.push()), time.monotonic()
        last = first
        while last.tick < first.tick + steps:
            last = self.flown(self.push())
        return in_time(start, steps)

    def greet(self) -> Welcome:
        self.send(from_page.Hello(kinds.PROTOCOL))
        return self.wait_for(Welcome)


def closing(page: Page) -> ConnectionClosed:
    """Wait until the server closes the connection, and return its close frame."""
    end = time.monotonic() + WAIT_S
    while time.monotonic() < end:
        try:
            page.receive()
        except ConnectionClosed as closed:
            return closed
    pytest.fail("the server does not close the connection")


class Server:
    """Server of a station, on a free port of this machine."""

    def __init__(self, port: int) -> None:
        self.port = port
        self.address = f"127.0.0.1:{port}"

    def get(self, path: str, headers: dict[str, str] | None = None) -> tuple[int, str]:
        """Send an HTTP request with the path unchanged; return the status and text of the answer."""
        link = HTTPConnection("127.0.0.1", self.port, timeout=WAIT_S)
        try:
            link.request("GET", path, headers=headers or {})
            answer = link.getresponse()
            return answer.status, answer.read().decode()
        finally:
            link.close()

    @contextmanager
    def unannounced(self, *, buffered: int | None = None, origin: str | None = None) -> Iterator[Page]:
        """Yield a page that has not sent hello. It buffers up to `buffered` unread messages; None means no limit."""
        url = f"ws://{self.address}/ws"
        own = None if origin is None else Origin(origin)
        with connect(
            url, compression=None, max_queue=buffered, origin=own, open_timeout=WAIT_S, close_timeout=0.2
        ) as socket:
            yield Page(socket)

    @contextmanager
    def page(self) -> Iterator[Page]:
        """Yield a page that has received its welcome."""
        with self.unannounced() as page:
            page.greet()
            yield page


class Station(Server):
    """Session served on a free port of this machine."""

    def __init__(self, session: Session, port: int) -> None:
        super().__init__(port)
        self.session = session

    def check_running(self, *, at_start: bool = True) -> None:
        """Check that frames arrive at the control period, and that the arm has not moved.

        Each try uses a new page, which receives no old messages.
        """

        def frames_arrive(steps: int = 6) -> bool:
            with self.page() as page:
                first, start = page.wait_for(Frame), time.monotonic()
                last = page.wait_for(Frame, lambda frame: frame.tick >= first.tick + steps)
                if at_start:
                    assert last.angles == tuple(scenario().initial_angles.tolist())
                return in_time(start, steps)

        until(frames_arrive, "frames at the control period")


@contextmanager
def served(session: Session, host: str = "127.0.0.1", access: Access = LOCAL) -> Iterator[Station]:
    """Serve a session as `aftdeck fly` does, in a thread."""
    with serving(make_app(ready(session), access, session.folder), host) as port:
        yield Station(session, port)


@contextmanager
def serving(app: Starlette, host: str = "127.0.0.1") -> Iterator[int]:
    """Serve an app in a thread, and yield its port."""
    listener = listen(host, 0)
    server = make_server(app)
    thread = Thread(target=server.run, kwargs={"sockets": [listener]}, daemon=True)
    thread.start()
    try:
        until(lambda: server.started or not thread.is_alive(), "the server starts")
        yield listener.getsockname()[1]
    finally:
        server.should_exit = True
        thread.join(WAIT_S)
        assert not thread.is_alive(), "the server does not end"
