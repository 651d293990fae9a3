"""Access to a station over a network: names, keys, and what a page with each key may do."""

from __future__ import annotations

import socket
from collections.abc import Iterator
from contextlib import contextmanager
from http.client import HTTPConnection
from typing import cast

import pytest
from websockets.exceptions import InvalidStatus
from websockets.sync.client import connect

from aftdeck.station.core.desk import NOT_IN_CONTROL
from aftdeck.station.messages import from_page, to_page
from aftdeck.station.messages.frame import Frame
from aftdeck.station.server.access import LOCAL, Access, access_of, shown_host
from aftdeck.station.server.policy import HEADERS
from aftdeck.station.server.serve import addresses_of, listen
from aftdeck.station.session.session import Session
from tests.loaded import scenario
from tests.station.pages import Page, Station, served
from tests.waits import WAIT_S

FLY, WATCH = "key-of-the-operator", "key-of-an-observer"
KEYED = Access(LOCAL.names, keys=(("fly", FLY), ("watch", WATCH)))


class Listener:
    """Socket that seems to listen on an address."""

    def __init__(self, address: str) -> None:
        self._address = address

    def getsockname(self) -> tuple[str, int]:
        return self._address, 8340


def on(address: str) -> socket.socket:
    return cast("socket.socket", Listener(address))


@pytest.fixture(scope="module")
def keyed() -> Iterator[Station]:
    with served(Session(scenario()), access=KEYED) as station:
        yield station


@contextmanager
def page_with(station: Station, key: str) -> Iterator[Page]:
    """Yield a page with this key, after its welcome."""
    with connect(f"ws://{station.address}/{key}/ws", compression=None, open_timeout=WAIT_S) as link:
        page = Page(link)
        page.greet()
        yield page


@pytest.mark.parametrize("address", ["127.0.0.1", "127.0.0.9", "::1"])
def test_server_on_the_loopback_interface_needs_no_key(address: str) -> None:
    assert access_of(on(address), "localhost").keys == ()


@pytest.mark.parametrize("address", ["0.0.0.0", "::", "192.168.1.5", "10.0.0.2", "fe80::1%eth0"])
def test_server_on_any_other_interface_has_a_new_key_for_each_role(address: str) -> None:
    first, second = (dict(access_of(on(address), "any").keys) for _ in range(2))
    assert set(first) == {"fly", "watch"}
    assert len({*first.values(), *second.values()}) == 4
    assert all(len(key) >= 20 for key in first.values())
    assert dict(access_of(on(address), "any", fly=False).keys).keys() == {"watch"}


def test_addresses_for_the_user_contain_the_keys_and_the_stated_name() -> None:
    access = access_of(on("0.0.0.0"), "0.0.0.0", ("Lab.example",))
    shown = [address for _, address in addresses_of(on("0.0.0.0"), access, "0.0.0.0", ("Lab.example",))]
    assert shown == [f"http://Lab.example:8340/{key}/" for _, key in access.keys]
    with listen("127.0.0.1", 0) as listener:
        port = listener.getsockname()[1]
        local = access_of(listener, "127.0.0.1")
        assert addresses_of(listener, local, "127.0.0.1", ()) == [("", f"http://127.0.0.1:{port}/")]


def test_shown_host_of_all_interfaces_is_an_address_that_requests_may_name() -> None:
    host = shown_host(on("0.0.0.0"), "0.0.0.0")
    assert access_of(on("0.0.0.0"), "0.0.0.0").accepts(host)


@pytest.mark.parametrize(
    ("address", "host", "accepted"),
    [
        ("127.0.0.1", "localhost", True),
        ("127.0.0.1", "192.168.1.5", False),
        ("192.168.1.5", "192.168.1.5", True),
        ("192.168.1.5", "192.168.1.6", False),
        ("0.0.0.0", "192.168.1.6", True),
        ("0.0.0.0", "evil.example", False),
        ("0.0.0.0", "lab.example", True),
        ("192.168.1.5", "lab.example", True),
        ("192.168.1.5", None, False),
    ],
)
def test_requests_may_name_only_the_stated_hosts(address: str, host: str | None, accepted: bool) -> None:
    assert access_of(on(address), address, ("LAB.example",)).accepts(host) is accepted


@pytest.mark.parametrize("key", ["", "wrong", FLY[:-1], f"{FLY}x", FLY.upper(), "%2e%2e", "..", "é", "index.html"])
@pytest.mark.parametrize("rest", ["", "/", "/health", "/recordings.json", "/index.html", "/replay/a.mcap/"])
def test_nothing_is_served_without_a_key(keyed: Station, key: str, rest: str) -> None:
    path = f"/{key}{rest}".encode().decode("latin-1")
    status, text = keyed.get(path.encode("latin-1").decode("ascii", "ignore") or "/")
    assert status == 403
    assert "key" in text


@pytest.mark.parametrize("path", ["/ws", "/wrong/ws", f"/{FLY}x/ws", f"/ws/{FLY}", f"/ws?key={FLY}"])
def test_no_page_connects_without_a_key(keyed: Station, path: str) -> None:
    with (
        pytest.raises(InvalidStatus, match="403"),
        connect(f"ws://{keyed.address}{path}", compression=None, open_timeout=WAIT_S),
    ):
        pytest.fail("the connection was accepted")


@pytest.mark.parametrize("key", [FLY, WATCH])
def test_each_key_opens_the_page(keyed: Station, key: str) -> None:
    assert keyed.get(f"/{key}/health") == (200, "flying\n")
    status, text = keyed.get(f"/{key}/")
    assert status == 200
    assert "<title>Aftdeck" in text
    assert keyed.get(f"/{key}")[0] in (307, 302)


def test_page_with_the_key_for_observing_never_takes_control() -> None:
    with served(Session(scenario()), access=KEYED) as station, page_with(station, WATCH) as observer:
        role = observer.wait_for(to_page.Role)
        assert (role.flying, role.may_fly, role.flier) == (False, False, 0)
        for command in (
            from_page.EnterMode(observer.next_seq(), "TEST"),
            from_page.SetBrakes(observer.next_seq(), True),
            from_page.Restart(observer.next_seq()),
            from_page.FlyScenario(observer.next_seq(), 0),
            from_page.GiveSticks(observer.next_seq()),
        ):
            observer.send(command)
            assert observer.rejection() == NOT_IN_CONTROL
        observer.push(translation=(1.0, 0.0, 0.0))
        assert observer.rejection() == NOT_IN_CONTROL
        observer.send(from_page.AskSticks(observer.next_seq()))
        assert "observing" in observer.rejection()
        with page_with(station, FLY) as operator:
            assert operator.wait_for(to_page.Role).flying
            assert operator.flown(operator.push((1.0, 0.0, 0.0))).translation == (1.0, 0.0, 0.0)
            observer.send(from_page.LeaveSeat(observer.next_seq()))
            observer.wait_for(to_page.Role, lambda role: role.number == 0)
            observer.send(from_page.TakeSeat(observer.next_seq()))
            observer.wait_for(to_page.Role, lambda role: role.number == 1 and role.flier == 2)
        alone = observer.wait_for(to_page.Role, lambda role: role.flier == 0)
        assert not alone.flying
        assert observer.wait_for(Frame, lambda frame: frame.position_hold).translation == (0.0, 0.0, 0.0)


@pytest.mark.parametrize("path", ["/", "/health", "/none", f"/{FLY}/", f"/{FLY}/health", f"/{FLY}/none", f"/{FLY}"])
def test_every_answer_carries_the_security_headers(keyed: Station, path: str) -> None:
    link = HTTPConnection("127.0.0.1", keyed.port, timeout=WAIT_S)
    try:
        link.request("GET", path)
        answer = link.getresponse()
        answer.read()
        assert {name: answer.getheader(name) for name in HEADERS} == HEADERS
    finally:
        link.close()


def test_policy_allows_nothing_foreign_and_nothing_inline() -> None:
    policy = HEADERS["Content-Security-Policy"]
    assert "unsafe" not in policy
    assert "*" not in policy
    assert "http" not in policy
    assert policy.startswith("default-src 'none'")
