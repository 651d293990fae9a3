from __future__ import annotations

import signal
import socket
import subprocess
import sys
import webbrowser
from collections.abc import Iterator
from pathlib import Path

import pytest
from websockets.sync.client import connect

from aftdeck.station import built as station_built
from aftdeck.station.built import StationError
from aftdeck.station.server import serve as station_serve
from aftdeck.station.server.app import make_app
from aftdeck.station.server.serve import listen, make_server, serve
from aftdeck.station.session.preparation import ready
from aftdeck.station.session.session import Session
from tests.station.pages import WAIT_S, Page, scenario, served

START_S = 300.0
"""The longest that `aftdeck fly` may take until it answers, or ends [s]; the first start compiles the laws."""


@pytest.fixture
def running() -> Iterator[subprocess.Popen[str]]:
    """`aftdeck fly` in a process of its own, that takes SIGINT as one in a terminal does."""
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


def test_control_c_ends_a_flight_with_a_page_without_a_traceback(running: subprocess.Popen[str]) -> None:
    place = address(running)
    url = f"ws://{place}/ws"
    with connect(url, compression=None, max_queue=None, open_timeout=START_S, close_timeout=0.2) as link:
        Page(link).greet()
        assert running.stdout is not None
        assert next(line for line in running.stdout if "Flying" in line) == "Flying 'First flight'. End with Ctrl+C.\n"
        running.send_signal(signal.SIGINT)
        assert running.wait(START_S) in (0, 130)
    assert running.stderr is not None
    assert running.stderr.read() == ""


def test_control_c_during_the_start_ends_it_without_a_traceback(running: subprocess.Popen[str]) -> None:
    address(running)
    running.send_signal(signal.SIGINT)
    assert running.wait(START_S) in (0, 130)
    assert running.stderr is not None
    assert "Traceback" not in running.stderr.read()


def test_a_station_listens_on_this_machine_alone() -> None:
    listener = listen("127.0.0.1", 0)
    with listener:
        assert listener.getsockname()[0] == "127.0.0.1"
        port = listener.getsockname()[1]
        others = {info[4][0] for info in socket.getaddrinfo(socket.gethostname(), None, socket.AF_INET)}
        for other in others - {"127.0.0.1"}:
            with pytest.raises(OSError, match="refused"):
                socket.create_connection((str(other), port), timeout=WAIT_S)


def test_frames_are_sent_without_waiting_for_more() -> None:
    with listen("127.0.0.1", 0) as listener:
        # asyncio turns Nagle's algorithm off on connections whose listener names TCP, and on no others
        assert listener.proto == socket.IPPROTO_TCP


def test_a_port_in_use_is_named() -> None:
    with listen("127.0.0.1", 0) as taken:
        port = taken.getsockname()[1]
        with pytest.raises(StationError, match=rf"^port {port} on 127\.0\.0\.1 is in use: give another with --port"):
            listen("127.0.0.1", port)


@pytest.mark.parametrize("port", [-1, 65536, 70000, 10**12])
def test_a_port_that_is_none_is_refused(port: int) -> None:
    with pytest.raises(StationError, match=f"^ports are numbered 0 to 65535, got {port}$"):
        listen("127.0.0.1", port)


@pytest.mark.parametrize("host", ["..", "no such host", "a" * 300, "256.256.256.256", "::g"])
def test_a_host_that_is_none_is_refused(host: str) -> None:
    with pytest.raises(StationError, match=r"^the host '.*' is not known: "):
        listen(host, 0)


def test_an_address_of_another_machine_is_refused() -> None:
    with pytest.raises(StationError, match=r"^cannot listen on 192\.0\.2\.1, port 0: "):
        listen("192.0.2.1", 0)


def test_a_missing_page_is_told_with_what_to_do(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(station_built, "STATIC", tmp_path)
    with pytest.raises(StationError, match=r"the station's page is missing \(.*index\.html\): build it with"):
        serve(scenario, None, host="127.0.0.1", port=0, open_browser=False, demo=False)


def test_the_server_bounds_the_length_of_messages() -> None:
    assert make_server(make_app(ready(Session(scenario())))).config.ws_max_size == 16_384


def test_a_name_of_this_machine_serves_pages_too() -> None:
    with served(Session(scenario()), "localhost") as station:
        assert station.get("/health", {"Host": f"localhost:{station.port}"}) == (200, "flying\n")


@pytest.mark.parametrize("wanted", [True, False])
def test_the_browser_is_opened_where_wanted(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str], wanted: bool
) -> None:
    opened: list[str] = []

    class Idle:
        def __init__(self, *_: object) -> None: ...

        def run(self, sockets: list[socket.socket]) -> None:
            sockets[0].close()
            raise KeyboardInterrupt

    (tmp_path / "index.html").write_text("the page", encoding="utf-8")
    monkeypatch.setattr(station_built, "STATIC", tmp_path)
    monkeypatch.setattr(station_serve, "make_server", Idle)
    monkeypatch.setattr(webbrowser, "open", opened.append)
    serve(scenario, None, host="127.0.0.1", port=0, open_browser=wanted, demo=False)
    said = capsys.readouterr().out
    assert opened == ([said.split()[2]] if wanted else [])
