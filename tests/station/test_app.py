"""Web server: access control, served files, shutdown, and a failure of the simulation."""

from __future__ import annotations

import re
import socket
import time
from contextlib import ExitStack
from pathlib import Path

import pytest
from websockets.exceptions import InvalidStatus

from aftdeck.station.messages.frame import Frame
from aftdeck.station.server import app as station_app
from aftdeck.station.session.session import Session
from tests.loaded import scenario
from tests.station.pages import Station, closing, served
from tests.waits import WAIT_S

FOREIGN = {
    "another site": {"Origin": "http://evil.example"},
    "another port": {"Origin": "http://127.0.0.1:1"},
    "a sandboxed page": {"Origin": "null"},
    "a broken origin": {"Origin": "http://["},
    "no origin's text": {"Origin": ""},
    "a rebound name": {"Host": "evil.example"},
    "a rebound name with its origin": {"Host": "evil.example", "Origin": "http://evil.example"},
    "a broken host": {"Host": "["},
    "an empty host": {"Host": ""},
    "another site's picture": {"Sec-Fetch-Site": "cross-site", "Sec-Fetch-Mode": "no-cors", "Sec-Fetch-Dest": "image"},
    "another site's script": {"Sec-Fetch-Site": "cross-site", "Sec-Fetch-Mode": "no-cors", "Sec-Fetch-Dest": "script"},
    "another site's request": {"Sec-Fetch-Site": "cross-site", "Sec-Fetch-Mode": "cors"},
    "another site's frame": {
        "Sec-Fetch-Site": "cross-site",
        "Sec-Fetch-Mode": "navigate",
        "Sec-Fetch-Dest": "iframe",
    },
    "another port's picture": {"Sec-Fetch-Site": "same-site", "Sec-Fetch-Mode": "no-cors"},
    "another site's socket": {"Sec-Fetch-Site": "cross-site", "Sec-Fetch-Mode": "websocket"},
    "a site of a kind yet unknown": {"Sec-Fetch-Site": "elsewhere"},
}


@pytest.mark.parametrize("headers", FOREIGN.values(), ids=FOREIGN)
def test_foreign_page_may_neither_read_nor_fly(shared: Station, headers: dict[str, str]) -> None:
    assert shared.get("/health", headers)[0] == 403
    lines = {"Host": shared.address, **headers}
    request = "GET /ws HTTP/1.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
    request += "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n"
    request += "".join(f"{name}: {value}\r\n" for name, value in lines.items()) + "\r\n"
    with socket.create_connection(("127.0.0.1", shared.port), timeout=WAIT_S) as raw:
        raw.sendall(request.encode())
        assert raw.recv(100).startswith(b"HTTP/1.1 403 ")
    shared.check_running()


@pytest.mark.parametrize("host", ["127.0.0.1", "localhost", "LOCALHOST"])
def test_own_page_may_connect_by_each_name_of_the_host(shared: Station, host: str) -> None:
    own = {"Host": f"{host}:{shared.port}", "Origin": f"http://{host}:{shared.port}"}
    assert shared.get("/health", own) == (200, "flying\n")


@pytest.mark.parametrize("site", ["cross-site", "same-site", "same-origin", "none"])
def test_link_of_any_page_may_open_the_station(shared: Station, site: str) -> None:
    opening = {"Sec-Fetch-Site": site, "Sec-Fetch-Mode": "navigate", "Sec-Fetch-Dest": "document"}
    assert shared.get("/health", opening) == (200, "flying\n")


@pytest.mark.parametrize("site", ["same-origin", "none"])
def test_own_page_may_send_requests_of_any_mode(shared: Station, site: str) -> None:
    for mode in ("cors", "no-cors", "same-origin", "websocket"):
        assert shared.get("/health", {"Sec-Fetch-Site": site, "Sec-Fetch-Mode": mode})[0] == 200


def test_websocket_of_another_origin_is_rejected(shared: Station) -> None:
    with pytest.raises(InvalidStatus, match="403"), shared.unannounced(origin="http://evil.example"):
        pytest.fail("the connection was accepted")


def test_no_file_outside_the_page_is_served(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    static = tmp_path / "static"
    static.mkdir()
    (static / "index.html").write_text("the page", encoding="utf-8")
    (tmp_path / "secret.txt").write_text("secret", encoding="utf-8")
    monkeypatch.setattr(station_app, "STATIC", static)
    with served(Session(scenario())) as station:
        assert station.get("/") == (200, "the page")
        for path in ("/../secret.txt", "/%2e%2e/secret.txt", "/..%2fsecret.txt", "/%2Fetc/passwd"):
            assert station.get(path)[0] == 404


def test_server_ends_while_pages_are_connected() -> None:
    with ExitStack() as pages:
        with served(Session(scenario())) as station:
            page = pages.enter_context(station.page())
            page.push()
        newest = station.session.newest
        closing(page)
        time.sleep(0.05)
        assert station.session.newest is newest, "no thread steps the session"


@pytest.mark.filterwarnings("ignore::pytest.PytestUnhandledThreadExceptionWarning")
def test_failure_of_the_simulation_reaches_all_pages(station: Station, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(_: object = None) -> None:
        raise ZeroDivisionError("a law divided by zero")

    with station.page() as page:
        page.wait_for(Frame)
        monkeypatch.setattr(station.session._sim, "step", fail)
        text = page.rejection()
        assert re.search(r" \d+\.\d\d s: a law divided by zero$", text)
        closing(page)
    with station.unannounced() as late:
        late.greet()
        assert late.rejection() == text
        closing(late)
    assert station.get("/health") == (200, "failed\n")
