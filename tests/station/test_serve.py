"""Start and end of the station: process, socket, address and browser."""

from __future__ import annotations

import re
import signal
import socket
import subprocess
import sys
import webbrowser
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest
from websockets.sync.client import connect

from aftdeck.station import built as station_built
from aftdeck.station.built import StationError
from aftdeck.station.server import serve as station_serve
from aftdeck.station.server.app import make_app
from aftdeck.station.server.serve import SEND_BUFFER, listen, make_server, serve
from aftdeck.station.session.preparation import ready
from aftdeck.station.session.session import Session
from tests.loaded import scenario
from tests.station.pages import Page, served
from tests.waits import WAIT_S


@pytest.fixture
def running() -> Iterator[subprocess.Popen[str]]:
    """Start `aftdeck fly` in a process that handles SIGINT as in a terminal."""
    command = [sys.executable, "-m", "aftdeck", "fly", "--no-browser", "--port", "0"]
    process = subprocess.Popen(
        command,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),  # noqa: PLW1509 (no threads yet)
    )
    try:
        yield process
    finally:
        process.kill()
        process.communicate(timeout=WAIT_S)


def address(process: subprocess.Popen[str]) -> str:
    assert process.stdout is not None
    line = process.stdout.readline()
    assert line.startswith("Aftdeck station: http://127.0.0.1:"), line
    return line.partition("http://")[2].strip().rstrip("/")


def test_control_c_ends_a_station_with_a_page_without_traceback(running: subprocess.Popen[str]) -> None:
    host = address(running)
    url = f"ws://{host}/ws"
    with connect(url, compression=None, max_queue=None, open_timeout=WAIT_S, close_timeout=0.2) as link:
        Page(link).greet()
        assert running.stdout is not None
        assert any("'First flight'" in line and "Ctrl+C" in line for line in running.stdout)
        running.send_signal(signal.SIGINT)
        assert running.wait(WAIT_S) in (0, 130)
    assert running.stderr is not None
    assert running.stderr.read() == ""


def test_control_c_during_the_start_ends_without_traceback(running: subprocess.Popen[str]) -> None:
    address(running)
    running.send_signal(signal.SIGINT)
    assert running.wait(WAIT_S) in (0, 130)
    assert running.stderr is not None
    assert "Traceback" not in running.stderr.read()


def test_station_listens_on_this_machine_only() -> None:
    listener = listen("127.0.0.1", 0)
    with listener:
        assert listener.getsockname()[0] == "127.0.0.1"
        port = listener.getsockname()[1]
        others = {info[4][0] for info in socket.getaddrinfo(socket.gethostname(), None, socket.AF_INET)}
        for other in others - {"127.0.0.1"}:
            with pytest.raises(OSError, match="refused"):
                socket.create_connection((str(other), port), timeout=WAIT_S)


def test_listener_disables_nagles_algorithm() -> None:
    with listen("127.0.0.1", 0) as listener:
        # asyncio disables Nagle's algorithm only for listeners whose protocol is explicitly TCP
        assert listener.proto == socket.IPPROTO_TCP


def test_system_keeps_little_for_a_client_that_does_not_receive() -> None:
    with listen("127.0.0.1", 0) as listener, socket.socket() as client:
        client.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        client.connect(listener.getsockname())
        server, _ = listener.accept()
        with server:
            server.setblocking(False)
            kept = 0
            with suppress(BlockingIOError):
                while True:
                    kept += server.send(bytes(4096))
    assert kept <= 4 * SEND_BUFFER


def test_port_in_use_is_named() -> None:
    with listen("127.0.0.1", 0) as taken:
        port = taken.getsockname()[1]
        with pytest.raises(StationError, match=rf"{port} on 127\.0\.0\.1.* --port"):
            listen("127.0.0.1", port)


@pytest.mark.parametrize("port", [-1, 65536, 70000, 10**12])
def test_invalid_port_is_rejected(port: int) -> None:
    with pytest.raises(StationError, match=f"0 to 65535, got {port}$"):
        listen("127.0.0.1", port)


@pytest.mark.parametrize("host", ["..", "no such host", "a" * 300, "256.256.256.256", "::g"])
def test_unknown_host_is_rejected(host: str) -> None:
    with pytest.raises(StationError, match=re.escape(repr(host))):
        listen(host, 0)


def test_address_of_another_machine_is_rejected() -> None:
    with pytest.raises(StationError, match=r"192\.0\.2\.1, port 0"):
        listen("192.0.2.1", 0)


def test_missing_page_is_reported_with_the_remedy(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(station_built, "STATIC", tmp_path)
    with pytest.raises(StationError, match=r"index\.html.*`make fly`"):
        serve(scenario, None, host="127.0.0.1", port=0, open_browser=False, demo=False)


def test_server_limits_the_length_of_messages() -> None:
    assert make_server(make_app(ready(Session(scenario())))).config.ws_max_size == 16_384


def test_station_on_localhost_serves_pages() -> None:
    with served(Session(scenario()), "localhost") as station:
        assert station.get("/health", {"Host": f"localhost:{station.port}"}) == (200, "flying\n")


@pytest.mark.parametrize("open_browser", [True, False])
def test_browser_is_opened_on_request(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str], open_browser: bool
) -> None:
    opened: list[str] = []

    class Idle:
        def __init__(self, *_: object) -> None: ...

        def run(self, sockets: list[socket.socket]) -> None:
            sockets[0].close()

        def handle_exit(self, *_: object) -> None: ...

    (tmp_path / "index.html").write_text("the page", encoding="utf-8")
    monkeypatch.setattr(station_built, "STATIC", tmp_path)
    monkeypatch.setattr(station_serve, "make_server", Idle)
    monkeypatch.setattr(webbrowser, "open", opened.append)
    serve(scenario, None, host="127.0.0.1", port=0, open_browser=open_browser, demo=False)
    printed = capsys.readouterr().out
    assert opened == ([printed.split()[2]] if open_browser else [])
