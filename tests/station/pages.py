"""A served session and pages that talk to it over real sockets."""

from __future__ import annotations

import functools
import time
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

from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.station.messages import from_page, kinds, to_page
from aftdeck.station.messages.frame import Frame
from aftdeck.station.messages.welcome import Welcome
from aftdeck.station.server.app import make_app
from aftdeck.station.server.serve import listen, make_server
from aftdeck.station.session.preparation import ready
from aftdeck.station.session.session import Session

WAIT_S = 60.0
"""The longest that anything is waited for [s]; nothing that works takes as long, on a busy machine either."""
LATE_S = 0.5
"""A stretch of frames may come this late [s]."""
STILL = (0.0, 0.0, 0.0)
OBSERVES = "you watch; another page flies"
"""Reason for rejecting a command of a page that is not in control."""

_messages: msgspec.json.Decoder[to_page.FromServer] = msgspec.json.Decoder(to_page.FromServer)
_M = TypeVar("_M", bound=msgspec.Struct)


@functools.cache
def scenario(name: str = "first-flight") -> Scenario:
    """A built-in scenario, loaded once."""
    return load_scenario(name)


def text_of(message: msgspec.Struct) -> str:
    """A message as it goes over the wire."""
    return msgspec.json.encode(message).decode()


def until(met: Callable[[], bool], what: str) -> None:
    """Wait until something is so."""
    end = time.monotonic() + WAIT_S
    while not met():
        assert time.monotonic() < end, f"waited {WAIT_S:g} s in vain: {what}"
        time.sleep(0.002)


def in_time(begun: float, steps: int) -> bool:
    """Whether steps that began at this time [s] took as long as they should.

    A busy machine delays some stretches of a flight, what holds the flight up delays every one: a test waits `until`
    one is in time.
    """
    return time.monotonic() - begun < steps * scenario().control_period + LATE_S


class Page:
    """A page as the server sees one."""

    def __init__(self, socket: ClientConnection) -> None:
        self.socket = socket
        self.seq = -1

    def say(self, message: msgspec.Struct | str | bytes) -> None:
        """Send a message, or anything else."""
        self.socket.send(message if isinstance(message, str | bytes) else text_of(message))

    def next_seq(self) -> int:
        self.seq += 1
        return self.seq

    def push(self, translation: kinds.Vec3 = STILL, rotation: kinds.Vec3 = STILL, drive: float = 0.0) -> int:
        """Move the sticks; returns the message's number."""
        seq = self.next_seq()
        self.say(from_page.Sticks(seq, translation, rotation, drive))
        return seq

    def hear(self) -> to_page.FromServer:
        """The next message."""
        return _messages.decode(self.socket.recv(timeout=WAIT_S))

    def wait_for(self, kind: type[_M], met: Callable[[_M], bool] = lambda _: True) -> _M:
        """The next message of a kind that is as wanted."""
        end = time.monotonic() + WAIT_S
        while True:
            message = self.hear()
            if isinstance(message, kind) and met(message):
                return message
            assert time.monotonic() < end, f"no {kind.__name__} as wanted came within {WAIT_S:g} s"

    def flown(self, seq: int) -> Frame:
        """The first frame that has flown sticks of this number."""
        return self.wait_for(Frame, lambda frame: frame.display.stick_seq >= seq)

    def is_answered(self, steps: int) -> bool:
        """Whether so many steps come at the control period, told by sticks that each frame answers."""
        first, begun = self.flown(self.push()), time.monotonic()
        last = first
        while last.tick < first.tick + steps:
            last = self.flown(self.push())
        return in_time(begun, steps)

    def refusal(self) -> str:
        return self.wait_for(to_page.Refused).text

    def greet(self) -> Welcome:
        self.say(from_page.Hello(kinds.PROTOCOL))
        return self.wait_for(Welcome)


def closing(page: Page) -> ConnectionClosed:
    """How the server ends a connection."""
    end = time.monotonic() + WAIT_S
    while time.monotonic() < end:
        try:
            page.hear()
        except ConnectionClosed as closed:
            return closed
    pytest.fail("the server does not close the connection")


class Server:
    """A station's server on a free port of this machine."""

    def __init__(self, port: int) -> None:
        self.port = port
        self.address = f"127.0.0.1:{port}"

    def get(self, path: str, headers: dict[str, str] | None = None) -> tuple[int, str]:
        """Status and text of an HTTP request, whose path is sent as it is."""
        link = HTTPConnection("127.0.0.1", self.port, timeout=WAIT_S)
        try:
            link.request("GET", path, headers=headers or {})
            answer = link.getresponse()
            return answer.status, answer.read().decode()
        finally:
            link.close()

    @contextmanager
    def stranger(self, *, buffered: int | None = None, origin: str | None = None) -> Iterator[Page]:
        """A connection that has not said hello; `buffered`: messages that it takes unread, None: all."""
        url = f"ws://{self.address}/ws"
        own = None if origin is None else Origin(origin)
        with connect(
            url, compression=None, max_queue=buffered, origin=own, open_timeout=WAIT_S, close_timeout=0.2
        ) as socket:
            yield Page(socket)

    @contextmanager
    def page(self) -> Iterator[Page]:
        """A page that has been welcomed."""
        with self.stranger() as page:
            page.greet()
            yield page


class Station(Server):
    """A session served on a free port of this machine."""

    def __init__(self, session: Session, port: int) -> None:
        super().__init__(port)
        self.session = session

    def is_unhurt(self, *, at_start: bool = True) -> None:
        """Check that frames come at the control period, and that the arm stands where it started.

        Each try is a page of its own, to which nothing old is under way.
        """

        def frames_come(steps: int = 6) -> bool:
            with self.page() as page:
                first, begun = page.wait_for(Frame), time.monotonic()
                last = page.wait_for(Frame, lambda frame: frame.tick >= first.tick + steps)
                if at_start:
                    assert last.angles == tuple(scenario().initial_angles.tolist())
                return in_time(begun, steps)

        until(frames_come, "frames at the control period")


@contextmanager
def served(session: Session, host: str = "127.0.0.1") -> Iterator[Station]:
    """Serve a session as `aftdeck fly` does, in a thread."""
    with serving(make_app(ready(session), host, session.folder), host) as port:
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
