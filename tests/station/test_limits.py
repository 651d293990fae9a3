"""Limits of the server: garbled requests, connections, times, and rates of messages."""

from __future__ import annotations

import base64
import logging
import re
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
from websockets.exceptions import ConnectionClosed

from aftdeck.station.messages import from_page, to_page
from aftdeck.station.messages.frame import Frame
from aftdeck.station.server import guard
from aftdeck.station.server import page as station_page
from aftdeck.station.server.allowance import Allowance
from aftdeck.station.server.terse_log import TerseHandler
from aftdeck.station.session.session import Session
from tests.loaded import scenario
from tests.station.pages import Page, Station, closing, served, until
from tests.station.recordings import record_run
from tests.waits import WAIT_S

KEY = base64.b64encode(bytes(16)).decode()
UPGRADE = "Host: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
GARBLED = {
    "binary": bytes(range(256)) * 8,
    "HTTP/0.9": b"GET /\r\n\r\n",
    "HTTP/2 preface": b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n",
    "TLS hello": b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03" + bytes(200),
    "no host": b"GET / HTTP/1.1\r\n\r\n",
    "long path": b"GET /" + b"a" * 12_000 + b" HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
    "longer path": b"GET /" + b"a" * 100_000 + b" HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
    "long header": b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nX: " + b"b" * 100_000 + b"\r\n\r\n",
    "many headers": b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n"
    + b"".join(b"X%d: 1\r\n" % k for k in range(300))
    + b"\r\n",
    "many pages' headers": b"GET /ws HTTP/1.1\r\n"
    + UPGRADE.encode()
    + f"Sec-WebSocket-Key: {KEY}\r\n".encode()
    + b"".join(b"X%d: 1\r\n" % k for k in range(300))
    + b"\r\n",
    "long page's path": b"GET /ws?"
    + b"a" * 12_000
    + f" HTTP/1.1\r\n{UPGRADE}Sec-WebSocket-Key: {KEY}\r\n\r\n".encode(),
    "zero byte in a path": b"GET /%00 HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
    "zero byte in a recording": b"GET /replay/%00.mcap/ HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
    "long recording": b"GET /replay/" + b"r" * 3000 + b".mcap/ HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
    "invalid UTF-8 in a path": b"GET /%ff%fe/replay/%ff.mcap/ HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
    "invalid UTF-8 in a recording": b"GET /replay/%ff.mcap/ HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
    "star": b"OPTIONS * HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
    "whole address": b"GET http://127.0.0.1/ HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
    "unknown method": b"BREW / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
    "connect": b"CONNECT 127.0.0.1:1 HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
    "post": b"POST /health HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 99999999999999999999\r\n\r\nx",
    "bad length": b"POST / HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: -1\r\n\r\n",
    "bad chunks": b"POST / HTTP/1.1\r\nHost: 127.0.0.1\r\nTransfer-Encoding: chunked\r\n\r\nzz\r\n",
    "garbage after a request": b"GET /health HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n\x00\x01\x02\r\n\r\n",
    "latin-1 in a header": b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nOrigin: http://\xe9\r\n\r\n",
    "host that is no host": b"GET / HTTP/1.1\r\nHost: [::1\r\n\r\n",
    "upgrade without a key": f"GET /ws HTTP/1.1\r\n{UPGRADE}\r\n".encode(),
    "upgrade with a bad key": f"GET /ws HTTP/1.1\r\n{UPGRADE}Sec-WebSocket-Key: ?\r\n\r\n".encode(),
    "upgrade of another version": f"GET /ws HTTP/1.1\r\n{UPGRADE}Sec-WebSocket-Key: {KEY}\r\n\r\n".replace(
        "13", "99"
    ).encode(),
    "upgrade by POST": f"POST /ws HTTP/1.1\r\n{UPGRADE}Sec-WebSocket-Key: {KEY}\r\n\r\n".encode(),
    "upgrade by HTTP/1.0": f"GET /ws HTTP/1.0\r\n{UPGRADE}Sec-WebSocket-Key: {KEY}\r\n\r\n".encode(),
    "upgrade of the page": f"GET / HTTP/1.1\r\n{UPGRADE}Sec-WebSocket-Key: {KEY}\r\n\r\n".encode(),
    "upgrade of a recording": f"GET /replay/a.mcap/ HTTP/1.1\r\n{UPGRADE}Sec-WebSocket-Key: {KEY}\r\n\r\n".encode(),
    "upgrade to another protocol": b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: h2c\r\nConnection: Upgrade\r\n\r\n",
}


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Station]:
    """Station that records, shared by the tests."""
    folder = tmp_path_factory.mktemp("flights")
    record_run(folder / "before.mcap", 60)
    with served(Session(scenario(), record=folder)) as station:
        yield station


@pytest.fixture
def tracebacks() -> Iterator[list[str]]:
    """Collect the log lines of the server that have a traceback."""

    class Collector(logging.Handler):
        def emit(self, record: logging.LogRecord) -> None:
            if record.exc_info:
                found.append(self.format(record))

    found: list[str] = []
    collector = Collector()
    loggers = [logging.getLogger(name) for name in ("uvicorn.error", "asyncio", "aftdeck.station")]
    for logger in loggers:
        logger.addHandler(collector)
    yield found
    for logger in loggers:
        logger.removeHandler(collector)


def send_raw(port: int, data: bytes) -> bytes:
    """Send bytes and the end of the stream; return the answer."""
    answer = b""
    with socket.create_connection(("127.0.0.1", port), WAIT_S) as link:
        try:
            link.sendall(data)
            link.shutdown(socket.SHUT_WR)
            while part := link.recv(65536):
                answer += part
                if b"\r\n\r\n" in answer:
                    break
        except ConnectionError:
            pass  # the server has closed the connection before it has read everything
    return answer


@pytest.mark.parametrize("kind", GARBLED)
def test_garbled_request_gets_no_500_and_no_traceback(
    recording: Station, kind: str, tracebacks: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(guard, "REQUEST_WITHIN", 0.3)
    answer = send_raw(recording.port, GARBLED[kind])
    assert not answer or re.match(rb"HTTP/1\.1 [1234]", answer), answer[:200]
    assert not tracebacks


def test_answer_in_preparation_is_dropped_if_the_body_is_invalid(recording: Station, tracebacks: list[str]) -> None:
    for _ in range(5):
        with socket.create_connection(("127.0.0.1", recording.port), WAIT_S) as link:
            link.sendall(GARBLED["bad chunks"])  # request and body arrive at once, before the answer is prepared
            assert link.recv(65536).startswith(b"HTTP/1.1 400")
        time.sleep(0.05)
    assert not tracebacks


@pytest.mark.parametrize("number", ["9" * 5000, "-1", "1e3", "%D9%A1", "99"])
def test_number_of_a_block_that_does_not_exist_is_not_found(
    recording: Station, number: str, tracebacks: list[str]
) -> None:
    assert recording.get(f"/replay/before.mcap/recording/blocks/{number}")[0] == 404
    assert not tracebacks


def test_invalid_utf_8_closes_the_connection_without_a_traceback(shared: Station, tracebacks: list[str]) -> None:
    with shared.page() as page:
        page.socket.send(b"\xff\xfe", text=True)
        assert closing(page).rcvd.code == 1007  # type: ignore[union-attr]
    assert not tracebacks
    shared.check_running()


def test_half_sent_request_is_closed_in_time(shared: Station, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(guard, "REQUEST_WITHIN", 0.5)
    with socket.create_connection(("127.0.0.1", shared.port), WAIT_S) as link:

        def closed() -> bool:
            try:
                link.sendall(b"X: 1\r\n")  # each part alone comes in time
                return False
            except ConnectionError:
                return True

        link.sendall(b"GET / HTTP/1.1\r\n")
        until(closed, "the connection is closed")
    shared.check_running()


def test_page_can_be_loaded_while_others_only_connect(station: Station, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(guard, "MAX_CONNECTIONS", 12)
    with ExitStack() as opened, station.page() as operator:
        idle = [opened.enter_context(socket.create_connection(("127.0.0.1", station.port), WAIT_S)) for _ in range(40)]
        for link in idle:
            link.settimeout(0.01)
        until(lambda: sum(map(is_closed, idle)) >= len(idle) - guard.MAX_CONNECTIONS, "the oldest are closed")
        assert station.get("/health") == (200, "flying\n")
        station.check_running()
        operator.flown(operator.push())


def is_closed(link: socket.socket) -> bool:
    try:
        return link.recv(1) == b""
    except TimeoutError:
        return False
    except OSError:
        return True


@pytest.mark.parametrize(
    "message",
    [
        lambda seq: from_page.Sticks(seq, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0),
        lambda seq: (from_page.LeaveSeat if seq % 2 else from_page.TakeSeat)(seq),
        from_page.AskSticks,
        lambda seq: from_page.SetName(seq, f"N {seq}"),
    ],
    ids=["sticks", "seats", "asks", "names"],
)
def test_observer_that_repeats_a_message_is_refused_and_closed(
    station: Station, message: Callable[[int], from_page.FromPage], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(station_page, "ROLES_AT_ONCE", 5.0)
    monkeypatch.setattr(station_page, "REJECTIONS_AT_ONCE", 30.0)
    with station.page() as operator, station.page() as observer:
        try:
            for seq in range(450):  # fewer than a page may send at once
                observer.send(message(seq))
        except ConnectionClosed:
            pass
        assert closing(observer).rcvd.code == 1008  # type: ignore[union-attr]
        roles = 0
        operator.push()
        while not isinstance(received := operator.receive(), Frame) or received.display.stick_seq < 0:
            roles += isinstance(received, to_page.Role)
        assert roles < 20, "each message about roles is reported to all pages"


def test_page_is_not_read_before_its_flood_is_closed(shared: Station, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(guard, "PENALTY", 0.5)
    with shared.page() as page:
        begun = time.monotonic()
        refused = flood(page)
        assert time.monotonic() - begun > 0.5
    assert guard.TOO_FAST in refused
    shared.check_running()


def flood(page: Page) -> list[str]:
    """Send too many messages until the connection is closed; return the reasons that the page receives until then."""
    reasons = []
    for _ in range(600):
        page.push()
    try:
        for _ in range(2000):
            if isinstance(message := page.receive(), to_page.Refused):
                reasons.append(message.text)
            for _ in range(50):  # a pause of the machine while the first ones were sent would make them few enough
                page.push()
    except ConnectionClosed:
        return reasons
    pytest.fail("the station did not close the connection of a page that sends too much")


@pytest.mark.slow
def test_half_sent_requests_at_256_files_neither_end_nor_flood_the_station(tmp_path: Path) -> None:
    errors = tmp_path / "errors.txt"
    command = [
        "sh",
        "-c",
        'ulimit -n 256; exec "$@"',
        "sh",
        sys.executable,
        "-m",
        "aftdeck",
        "fly",
        "first-flight",
        "--no-browser",
        "--port",
        "0",
    ]
    with (
        errors.open("wb") as log,
        subprocess.Popen(
            command,
            stdout=subprocess.PIPE,
            stderr=log,
            text=True,
        ) as process,
        ExitStack() as opened,
    ):
        assert process.stdout is not None
        try:
            port = int(process.stdout.readline().rstrip("/\n").rpartition(":")[2])
            while not process.stdout.readline().startswith("Flying"):
                pass
            station = Station(Session(scenario()), port)
            with station.page() as operator:
                for _ in range(300):
                    link = opened.enter_context(socket.create_connection(("127.0.0.1", port), WAIT_S))
                    link.sendall(b"GET / HTTP/1.1\r\nX: ")
                assert station.get("/health") == (200, "flying\n")
                operator.flown(operator.push())
                operator.wait_for(Frame)
            assert process.poll() is None
        finally:
            process.terminate()
            process.wait(WAIT_S)
    assert errors.stat().st_size < 5000


def test_allowance_follows_its_rate_and_its_number_at_once() -> None:
    now = 0.0
    allowance = Allowance(10.0, 5.0, lambda: now)
    assert [allowance.take() for _ in range(7)] == [True] * 5 + [False] * 2
    now = 0.2
    assert [allowance.take() for _ in range(3)] == [True, True, False]
    now = 100.0
    assert sum(allowance.take() for _ in range(100)) == 5
    assert [round(allowance.turn(0.25), 9) for _ in range(4)] == [0.1, 0.2, 0.25, 0.25]


def test_equal_lines_are_printed_once_and_counted(capsys: pytest.CaptureFixture[str]) -> None:
    handler = TerseHandler()
    for k in range(1000):
        handler.handle(logging.makeLogRecord({"msg": "page %d", "args": (k,), "levelno": logging.WARNING}))
    assert capsys.readouterr().err == "aftdeck: page 0\n"
    handler._report("page %d")
    assert capsys.readouterr().err == "aftdeck: 999 more like this in 60 s: page 999\n"
    handler._report("page %d")
    assert capsys.readouterr().err == ""


def test_counted_lines_are_printed_when_the_server_ends(capsys: pytest.CaptureFixture[str]) -> None:
    handler = TerseHandler()
    for text, count in (("page %d", 3), ("once %d", 1)):
        for k in range(count):
            handler.handle(logging.makeLogRecord({"msg": text, "args": (k,), "levelno": logging.WARNING}))
    timers = list(handler._timers.values())
    capsys.readouterr()
    handler.flush()
    assert capsys.readouterr().err == "aftdeck: 2 more like this: page 2\n"
    for timer in timers:
        timer.join(10.0)
        assert not timer.is_alive(), "nothing is printed later"
    handler.flush()
    assert capsys.readouterr().err == ""
