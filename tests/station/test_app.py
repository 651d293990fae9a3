from __future__ import annotations

import json
import re
import socket
import time
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from threading import Event, Thread

import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus

from aftdeck.simulation.frame import Frame as Flown
from aftdeck.simulation.inputs import Inputs
from aftdeck.station.messages import from_page, kinds, to_page
from aftdeck.station.messages.frame import Frame
from aftdeck.station.server import app as station_app
from aftdeck.station.server import page as station_page
from aftdeck.station.server.page import MOST_PAGES, MOST_WRONG
from aftdeck.station.session import session as station_session
from aftdeck.station.session.session import MOST_WAITING, SILENCE, Phase, Session
from tests.station.pages import STILL, WAIT_S, Page, Station, scenario, served, text_of, until


@pytest.fixture
def station() -> Iterator[Station]:
    with served(Session(scenario())) as station:
        yield station


@pytest.fixture(scope="module")
def shared() -> Iterator[Station]:
    """One station for all the tests that leave the arm where it stands."""
    with served(Session(scenario())) as station:
        yield station


def closing(page: Page) -> ConnectionClosed:
    """How the server ends a connection."""
    end = time.monotonic() + WAIT_S
    while time.monotonic() < end:
        try:
            page.hear()
        except ConnectionClosed as closed:
            return closed
    pytest.fail("the server does not close the connection")


# --- the handshake ----------------------------------------------------------------------------------------


def test_a_page_is_welcomed_with_all_that_it_needs_once(shared: Station) -> None:
    with shared.stranger() as page:
        welcome = page.greet()
        assert (welcome.protocol, welcome.scenario) == (kinds.PROTOCOL, "first-flight")
        frame = page.wait_for(Frame)
        assert len(frame.display.poses) == 7 * len(welcome.bodies)


@pytest.mark.parametrize(
    ("first", "sentence"),
    [
        (
            '{"type":"hello","protocol":99}',
            f"this page speaks protocol 99, the station {kinds.PROTOCOL}: reload the page",
        ),
        ('{"type":"proceed","seq":1}', "the first message must be a hello"),
        ("hello", "the first message must be a hello"),
        ("", "the first message must be a hello"),
        ('{"type":"hello"}', "the first message must be a hello"),
        ('{"type":"hello","protocol":"2"}', "the first message must be a hello"),
        ('{"type":"hello","protocol":2,"more":2}', "the first message must be a hello"),
        ('{"x":' + "[" * 3000, "the first message must be a hello"),
        ('{"type":"hello","' + "é" * 1000 + '":1}', "the first message must be a hello"),
        (b"\x00\xff", "the first message must be a hello"),
    ],
    ids=["protocol", "no hello", "no JSON", "empty", "no number", "text", "field", "deep", "long", "binary"],
)
def test_a_wrong_first_message_gets_a_sentence_and_the_end(shared: Station, first: str | bytes, sentence: str) -> None:
    with shared.stranger() as page:
        page.say(first)
        assert sentence in page.refusal()
        closed = closing(page)
        assert closed.rcvd is not None
        assert closed.rcvd.code == 1008
        assert sentence.startswith(closed.rcvd.reason[:20])
    shared.is_unhurt()


def test_a_page_that_says_no_hello_is_let_go(shared: Station, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(station_page, "HELLO_WITHIN", 0.1)
    with shared.stranger() as page:
        assert page.refusal() == "no hello came within 0.1 s"
        closing(page)
    shared.is_unhurt()


def test_a_page_too_many_is_refused(shared: Station) -> None:
    with ExitStack() as pages:
        for _ in range(MOST_PAGES):
            pages.enter_context(shared.page())
        with shared.stranger() as late:
            late.say(from_page.Hello(kinds.PROTOCOL))
            assert late.refusal() == f"{MOST_PAGES} pages are connected already"
            closing(late)
    shared.is_unhurt()


def test_a_second_window_never_flies_and_is_no_watcher(station: Station) -> None:
    with station.stranger() as window:
        window.say(from_page.Hello(kinds.PROTOCOL, shows=True))
        assert not window.wait_for(to_page.Role).flying
        with station.page() as page:
            assert page.wait_for(to_page.Role) == to_page.Role(True, 0, 1, 1, asking=0, name="", names=())
            assert page.flown(page.push((1.0, 0.0, 0.0))).translation == (1.0, 0.0, 0.0)
        window.push((1.0, 0.0, 0.0))
        assert window.refusal() == "you watch; another page flies"


def test_a_page_too_narrow_leaves_its_seat_and_takes_it_again_behind_the_others(station: Station) -> None:
    with station.page() as narrow, station.page() as other:
        narrow.wait_for(to_page.Role, lambda role: role.flying and role.watchers == 1)
        narrow.push(translation=(1.0, 0.0, 0.0))
        narrow.wait_for(Frame, lambda frame: frame.translation[0] == 1.0)
        narrow.say(from_page.LeaveSeat(narrow.next_seq()))
        assert narrow.wait_for(to_page.Role, lambda role: not role.flying) == to_page.Role(
            False, 0, 0, flier=2, asking=0, name="", names=()
        )
        assert narrow.wait_for(Frame, lambda frame: frame.position_hold).translation == (0.0, 0.0, 0.0)
        narrow.say(from_page.AskSticks(narrow.next_seq()))
        assert narrow.refusal() == "you watch; another page flies"
        other.wait_for(to_page.Role, lambda role: role.flying)
        narrow.say(from_page.TakeSeat(narrow.next_seq()))
        assert narrow.wait_for(to_page.Role, lambda role: role.number == 1).flier == 2, "whoever flies goes on"
        other.say(from_page.LeaveSeat(other.next_seq()))
        narrow.wait_for(to_page.Role, lambda role: role.flying)
        assert narrow.flown(narrow.push((0.5, 0.0, 0.0))).translation == (0.5, 0.0, 0.0)


# --- messages that are none -------------------------------------------------------------------------------


def controllers(count: int = 1, **changed: object) -> str:
    """A message that tells of keyboards, with something changed in them."""
    used = {"kind": "keyboard", "name": "Keyboard", "deadband": 0, "expo": 0, "bindings": ["KeyW +X"], "centres": []}
    return json.dumps({"type": "controllers", "seq": 1, "controllers": [used | changed] * count})


NOT_UNDERSTOOD = {
    "empty": "",
    "cut short": '{"type":"proceed"',
    "a list": "[]",
    "null": "null",
    "no type": '{"seq":1}',
    "an unknown type": '{"type":"eject","seq":1}',
    "a type that is no text": '{"type":[],"seq":1}',
    "an unknown field": '{"type":"proceed","seq":1,"force":true}',
    "no seq": '{"type":"proceed"}',
    "a seq that is text": '{"type":"proceed","seq":"1"}',
    "a broken seq": '{"type":"proceed","seq":1.5}',
    "a seq below zero": '{"type":"proceed","seq":-1}',
    "a seq beyond JavaScript": f'{{"type":"proceed","seq":{2**53}}}',
    "a seq of 4000 digits": f'{{"type":"proceed","seq":1{"0" * 4000}}}',
    "too few axes": '{"type":"sticks","seq":1,"translation":[0,0],"rotation":[0,0,0],"drive":0}',
    "NaN": '{"type":"sticks","seq":1,"translation":[NaN,0,0],"rotation":[0,0,0],"drive":0}',
    "Infinity": '{"type":"sticks","seq":1,"translation":[0,0,0],"rotation":[0,0,0],"drive":Infinity}',
    "a number too large": '{"type":"sticks","seq":1,"translation":[1e999,0,0],"rotation":[0,0,0],"drive":0}',
    "a stick that is null": '{"type":"sticks","seq":1,"translation":[0,0,0],"rotation":[0,0,0],"drive":null}',
    "an unknown rate": '{"type":"select_rate","seq":1,"rate":"ludicrous"}',
    "half a surrogate": '{"type":"enter_mode","seq":1,"mode":"\\ud800"}',
    "a controller of an unknown kind": controllers(kind="trackball"),
    "a controller without a name": controllers(name=""),
    "a name too long": controllers(name="x" * 81),
    "a deadband of all": controllers(deadband=1.0),
    "a binding that is none": controllers(bindings=["KeyW"]),
    "a binding too long": controllers(bindings=["KeyW " + "x" * 17]),
    "too many bindings": controllers(bindings=["KeyW +X"] * 65),
    "a centre at the end": controllers(centres=[1.0]),
    "a mapping in words": controllers(bindings="KeyW +X"),
    "too many controllers": controllers(count=6),
    "deep lists": '{"x":' + "[" * 3000,
    "deep tables": '{"x":' + '{"x":' * 700,
}


@pytest.mark.parametrize("text", NOT_UNDERSTOOD.values(), ids=NOT_UNDERSTOOD)
def test_a_message_that_is_none_is_refused_and_the_page_stays(shared: Station, text: str) -> None:
    with shared.page() as page:
        page.say(text)
        assert page.refusal().startswith("message not understood: ")
        seq = page.push()
        page.wait_for(Frame, lambda frame: frame.display.stick_seq == seq)
    shared.is_unhurt()


def test_a_binary_message_is_refused(shared: Station) -> None:
    with shared.page() as page:
        page.say(text_of(from_page.Proceed(0)).encode())
        assert page.refusal() == "messages are JSON text; this one was binary"
    shared.is_unhurt()


REFUSED = {
    "a stick past its travel": (from_page.Sticks(0, (0.0, 1.0000001, 0.0), STILL, 0.0), "sticks lie between -1 and 1"),
    "a huge stick": (from_page.Sticks(0, STILL, (0.0, 0.0, -1e308), 0.0), "sticks lie between -1 and 1"),
    "a huge drive": (from_page.Sticks(0, STILL, STILL, 7.0), "sticks lie between -1 and 1"),
    "a joint too many": (from_page.SelectJoint(0, 6), "joints are numbered 0 to 5, got 6"),
    "a joint below the first": (from_page.SelectJoint(0, -1), "joints are numbered 0 to 5, got -1"),
    "a mode that is none": (from_page.EnterMode(0, "WARP"), "no mode 'WARP' can be entered here: there are OPR CMD"),
    "a mode with signs": (from_page.EnterMode(0, "\x00\n<b>é"), "no mode '\\x00\\n<b>é' can be entered here"),
    "a target at infinity": (from_page.SetTarget(0, (1e308, 1e308, -1e308), STILL), "a target lies within 1000 m"),
    "a target that whirls": (from_page.SetTarget(0, STILL, (1e300, 0.0, 0.0)), "is turned by 100 rad at most"),
}


@pytest.mark.parametrize(("message", "sentence"), REFUSED.values(), ids=REFUSED)
def test_a_command_that_cannot_be_is_refused_in_a_sentence(
    shared: Station, message: from_page.FromPage, sentence: str
) -> None:
    with shared.page() as page:
        page.say(message)
        refused = page.wait_for(to_page.Refused)
        assert refused.seq == 0
        assert sentence in refused.text
    shared.is_unhurt()


def test_what_the_simulation_refuses_stands_in_the_log(shared: Station) -> None:
    with shared.page() as page:
        page.say(from_page.SetTarget(page.next_seq(), (-50.0, 0.0, 0.0), STILL))
        page.say(from_page.Proceed(page.next_seq()))
        texts: list[str] = []
        while len(texts) < 2:
            events = page.wait_for(to_page.Events).events
            texts += [event.text for event in events if event.kind in ("check", "refused")]
        assert texts[0].startswith("CMD CK FAIL: the arm cannot reach this pose: its wrist is ")
        assert texts[1] == "PROCEED does nothing in ORB UNL: enter OPR CMD or AUTO 1-4 first"
    shared.is_unhurt()


def test_a_message_out_of_order_is_not_flown(station: Station) -> None:
    with station.page() as page:
        page.say(from_page.SelectJoint(7, 1))
        page.say(from_page.SelectJoint(6, 2))
        page.say(from_page.SelectJoint(7, 3))
        assert page.refusal() == "message 6 came after message 7; it was not taken"
        assert page.refusal() == "message 7 came after message 7; it was not taken"
        first = page.wait_for(Frame)
        assert page.wait_for(Frame, lambda frame: frame.tick > first.tick + 4).joint == 1
    station.is_unhurt()


def test_a_message_too_long_ends_its_page_alone(shared: Station) -> None:
    with shared.page() as other, shared.page() as page:
        page.say(" " * kinds.MAX_MESSAGE_BYTES + "{}")
        closed = closing(page)
        assert closed.rcvd is not None
        assert closed.rcvd.code == 1009
        first = other.wait_for(Frame)
        other.wait_for(Frame, lambda frame: frame.tick > first.tick + 10)
    shared.is_unhurt()


def test_a_page_that_is_always_wrong_is_closed(shared: Station) -> None:
    with shared.page() as page:
        for _ in range(MOST_WRONG):
            page.say("nonsense")
        said = f"{MOST_WRONG} messages were refused; the connection is closed"
        page.wait_for(to_page.Refused, lambda refused: refused.text == said)
        closing(page)
    shared.is_unhurt()


def test_a_page_that_errs_now_and_then_stays(shared: Station) -> None:
    with shared.page() as page:
        for _ in range(MOST_WRONG + 5):
            page.say("nonsense")
            page.refusal()
            page.push()
        page.wait_for(Frame, lambda frame: frame.display.stick_seq == page.seq)
    shared.is_unhurt()


# --- too much, too slow, gone -----------------------------------------------------------------------------


def test_a_flood_of_commands_ends_its_page_and_not_the_flight(station: Station) -> None:
    with station.page() as page:
        try:
            for seq in range(10_000):
                page.say(from_page.SelectJoint(seq, seq % 6))
        except ConnectionClosed:
            pass  # the end comes while the flood goes on
        closing(page)
    station.is_unhurt()


def test_a_flood_of_sticks_is_flown_newest_first(shared: Station) -> None:
    with shared.page() as page:
        for _ in range(10_000):
            page.push()
        page.wait_for(Frame, lambda frame: frame.display.stick_seq == 9_999)
    shared.is_unhurt()


def test_stop_is_never_refused_and_overtakes_what_waits(station: Station, monkeypatch: pytest.MonkeyPatch) -> None:
    simulation, queue = station.session._sim, station.session._commands
    step, stands, goes_on = simulation.step, Event(), Event()

    def wait(inputs: Inputs | None = None) -> Flown:
        stands.set()
        assert goes_on.wait(WAIT_S)
        return step(inputs)

    with station.page() as page, ExitStack() as held:
        held.callback(goes_on.set)
        monkeypatch.setattr(simulation, "step", wait)
        assert stands.wait(WAIT_S)
        for _ in range(MOST_WAITING):
            page.say(from_page.SelectJoint(page.next_seq(), 5))
        page.push(translation=(0.5, 0.0, 0.0))
        until(lambda: len(queue) == MOST_WAITING, "the queue is full")
        page.say(from_page.Stop(page.next_seq()))
        page.say(from_page.SelectRate(page.next_seq(), "vernier"))
        until(lambda: len(queue) == 2, "STOP and what comes after it alone wait")
        goes_on.set()
        frame = page.wait_for(Frame, lambda frame: frame.rate == "vernier")
        assert (frame.joint, frame.translation) == (0, STILL)


def test_a_page_that_never_reads_holds_up_nobody(station: Station) -> None:
    with station.page() as flier, station.stranger(buffered=1) as sleeper:
        sleeper.socket.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        sleeper.greet()
        until(lambda: flier.is_answered(150), "150 frames at the control period")
    station.is_unhurt()


def test_many_watchers_that_never_read_hold_up_nobody(station: Station) -> None:
    with ExitStack() as sleepers:
        for _ in range(10):
            sleepers.enter_context(station.stranger(buffered=1)).greet()
        station.is_unhurt()


def test_sticks_go_to_zero_when_their_page_is_cut_off_and_the_next_page_gets_them(station: Station) -> None:
    with station.stranger() as flier, station.page() as next_one:
        # the stranger is welcomed second and watches; the other one flies
        flier.greet()
        assert next_one.wait_for(to_page.Role).flying
        assert not flier.wait_for(to_page.Role).flying
        next_one.push(translation=(1.0, 0.0, 0.0))
        flier.wait_for(Frame, lambda frame: frame.translation[0] == 1.0)
        next_one.socket.socket.shutdown(socket.SHUT_RDWR)  # no goodbye
        assert flier.wait_for(to_page.Role, lambda role: role.flying).watchers == 0
        frame = flier.wait_for(Frame, lambda frame: frame.translation[0] == 0.0)
        assert frame.display.stick_seq == -1, "not because they were silent"
        seq = flier.push(rotation=(0.0, 0.0, 0.5))
        assert flier.wait_for(Frame, lambda frame: frame.display.stick_seq == seq).rotation == (0.0, 0.0, 0.5)


def test_the_sticks_are_handed_over_at_rest_to_the_page_that_asks(station: Station) -> None:
    with station.page() as flier, station.page() as other:
        flier.wait_for(to_page.Role, lambda role: role.flying and role.watchers == 1)
        assert other.wait_for(to_page.Role).flier == 1
        other.say(from_page.AskSticks(other.next_seq()))
        flier.wait_for(to_page.Role, lambda role: role.asking == 2)
        flier.push(translation=(1.0, 0.0, 0.0))
        flier.wait_for(Frame, lambda frame: frame.translation[0] == 1.0)
        flier.say(from_page.GiveSticks(flier.next_seq()))
        assert flier.refusal() == "let go of the sticks first: they are given at rest"
        flier.flown(flier.push())
        flier.say(from_page.GiveSticks(flier.next_seq()))
        assert other.wait_for(to_page.Role, lambda role: role.flying).flier == 2
        assert not flier.wait_for(to_page.Role, lambda role: role.flier == 2).flying
        flier.push(translation=(1.0, 0.0, 0.0))
        assert flier.refusal() == "you watch; another page flies"
        assert other.flown(other.push(rotation=(0.0, 0.0, 0.5))).rotation == (0.0, 0.0, 0.5)
    texts = [event.text for event in station.session.log_since(0)]
    assert "page 1 gives the sticks to page 2" in texts


def test_a_name_goes_to_every_page_and_into_the_log(station: Station) -> None:
    with station.page() as flier, station.page() as other:
        flier.say(from_page.SetName(flier.next_seq(), "Anna"))
        anna = to_page.NamedPage(1, "Anna")
        assert other.wait_for(to_page.Role, lambda role: role.names == (anna,)).name == ""
        other.say(from_page.SetName(other.next_seq(), "Ben"))  # who only watches has a name, too
        both = flier.wait_for(to_page.Role, lambda role: len(role.names) == 2)
        assert both.names == (anna, to_page.NamedPage(2, "Ben")) and both.name == "Anna"
        other.say(from_page.AskSticks(other.next_seq()))
        flier.wait_for(to_page.Role, lambda role: role.asking == 2)
        flier.say(from_page.KeepSticks(flier.next_seq()))
        assert other.refusal() == "Anna keeps the sticks"
        other.say(from_page.AskSticks(other.next_seq()))
        flier.wait_for(to_page.Role, lambda role: role.asking == 2)
        flier.say(from_page.GiveSticks(flier.next_seq()))
        other.wait_for(to_page.Role, lambda role: role.flying)
        other.say(from_page.SetName(other.next_seq(), ""))
        assert flier.wait_for(to_page.Role, lambda role: len(role.names) == 1).names == (anna,)
    until(lambda: "Anna gives the sticks to Ben" in [event.text for event in station.session.log_since(0)], "the line")


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("A" * 25, "a name has 24 characters at most, got 25"),
        (" Anna", "a name begins and ends without a space, got ' Anna'"),
        ("   ", "a name needs at least one letter or digit"),
        ("Anna\nflies", "a name stands on one line"),
        ("\u202eannA", "a name stands on one line"),
    ],
)
def test_what_is_no_name_is_refused_in_a_sentence_and_not_repaired(station: Station, name: str, sentence: str) -> None:
    with station.page() as page:
        page.say(from_page.SetName(page.next_seq(), "Anna"))
        page.wait_for(to_page.Role, lambda role: role.name == "Anna")
        page.say(from_page.SetName(page.next_seq(), name))
        refused = page.wait_for(to_page.Refused)
        assert refused.seq == page.seq and sentence in refused.text
        page.say(from_page.AskSticks(page.next_seq()))
        page.wait_for(to_page.Refused)
        with station.page() as other:
            assert other.wait_for(to_page.Role, lambda role: role.number == 2).names == (to_page.NamedPage(1, "Anna"),)


def test_a_second_window_has_no_name(station: Station) -> None:
    with station.page(), station.stranger() as window:
        window.say(from_page.Hello(kinds.PROTOCOL, shows=True))
        window.say(from_page.SetName(window.next_seq(), "Anna"))
        assert window.refusal() == "you watch; another page flies"


def test_sticks_that_are_kept_stay_where_they_are(station: Station) -> None:
    with station.page() as flier, station.page() as other:
        flier.say(from_page.AskSticks(flier.next_seq()))
        assert flier.refusal() == "you fly: there is nobody to ask for the sticks"
        flier.say(from_page.GiveSticks(flier.next_seq()))
        assert flier.refusal() == "nobody asks for the sticks, or no longer"
        other.say(from_page.AskSticks(other.next_seq()))
        flier.wait_for(to_page.Role, lambda role: role.asking == 2)
        flier.say(from_page.KeepSticks(flier.next_seq()))
        assert other.refusal() == "page 1 keeps the sticks"
        assert flier.wait_for(to_page.Role, lambda role: role.asking == 0).flying


def test_silent_sticks_go_to_zero(station: Station, monkeypatch: pytest.MonkeyPatch) -> None:
    with station.page() as page:
        seq = page.push(translation=(1.0, 0.0, 0.0))
        page.wait_for(Frame, lambda frame: frame.translation[0] == 1.0)
        monkeypatch.setattr(station_session, "SILENCE", SILENCE)
        assert page.wait_for(Frame, lambda frame: frame.translation[0] == 0.0).display.stick_seq == seq


def test_a_watcher_may_not_fly(shared: Station) -> None:
    with shared.page(), shared.page() as watcher:
        for _ in range(MOST_WRONG + 5):  # a watcher is not ended for trying
            watcher.push(translation=(1.0, 0.0, 0.0))
            assert watcher.refusal() == "you watch; another page flies"
    shared.is_unhurt()


def test_a_stick_is_answered_by_the_next_frame(shared: Station) -> None:
    def most_are(page: Page) -> bool:
        took = []
        for _ in range(40):
            begun = time.monotonic()
            page.flown(page.push())
            took.append(time.monotonic() - begun)
        return sorted(took)[20] < 0.04

    with shared.page() as page:
        until(lambda: most_are(page), "half of 40 sticks are answered within 0.04 s")


# --- foreign pages ----------------------------------------------------------------------------------------

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
}


@pytest.mark.parametrize("headers", FOREIGN.values(), ids=FOREIGN)
def test_a_foreign_page_may_neither_read_nor_fly(shared: Station, headers: dict[str, str]) -> None:
    assert shared.get("/health", headers) == (403, "only this station's own page may talk to it\n")
    lines = {"Host": shared.address, **headers}
    request = "GET /ws HTTP/1.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
    request += "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n"
    request += "".join(f"{name}: {value}\r\n" for name, value in lines.items()) + "\r\n"
    with socket.create_connection(("127.0.0.1", shared.port), timeout=WAIT_S) as raw:
        raw.sendall(request.encode())
        assert raw.recv(100).startswith(b"HTTP/1.1 403 ")
    shared.is_unhurt()


@pytest.mark.parametrize("host", ["127.0.0.1", "localhost", "LOCALHOST"])
def test_the_stations_own_page_may_talk_to_it_by_each_of_its_names(shared: Station, host: str) -> None:
    own = {"Host": f"{host}:{shared.port}", "Origin": f"http://{host}:{shared.port}"}
    assert shared.get("/health", own) == (200, "flying\n")


def test_a_websocket_of_another_origin_is_refused(shared: Station) -> None:
    with pytest.raises(InvalidStatus, match="403"), shared.stranger(origin="http://evil.example"):
        pytest.fail("it was let in")


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


def test_the_server_ends_while_pages_are_connected() -> None:
    with ExitStack() as pages:
        with served(Session(scenario())) as station:
            page = pages.enter_context(station.page())
            page.push()
        assert station.session.phase is Phase.CLOSED
        closing(page)


# --- a simulation that fails ------------------------------------------------------------------------------


@pytest.mark.filterwarnings("ignore::pytest.PytestUnhandledThreadExceptionWarning")
def test_pages_are_told_when_the_simulation_fails(station: Station, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(_: object = None) -> None:
        raise ZeroDivisionError("a law divided by zero")

    with station.page() as page:
        page.wait_for(Frame)
        monkeypatch.setattr(station.session._sim, "step", fail)
        text = page.refusal()
        assert re.fullmatch(r"the simulation stopped at \d+\.\d\d s: a law divided by zero", text)
        closing(page)
    with station.stranger() as late:
        late.greet()
        assert late.refusal() == text
        closing(late)
    assert station.get("/health") == (200, "failed\n")


def test_pages_come_and_go_at_once(shared: Station) -> None:
    def visit() -> None:
        for _ in range(5):
            with shared.page() as page:
                page.push(translation=(0.0, 0.0, 0.0))
                page.wait_for(Frame)

    visitors = [Thread(target=visit) for _ in range(6)]
    for visitor in visitors:
        visitor.start()
    for visitor in visitors:
        visitor.join(WAIT_S)
    until(lambda: not any(visitor.is_alive() for visitor in visitors), "all have gone")
    shared.is_unhurt()
