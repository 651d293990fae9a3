"""Connection of one page: its hello, its messages, and the answers."""

from __future__ import annotations

import json
from contextlib import ExitStack

import pytest

from aftdeck.station.messages import from_page, kinds, to_page
from aftdeck.station.messages.frame import Frame
from aftdeck.station.server import page as station_page
from aftdeck.station.server.page import MAX_PAGES, MAX_REJECTIONS, TOO_MANY_PAGES
from tests.station.direct_pages import DirectStation
from tests.station.pages import STILL, Page, Station, closing, text_of


def test_page_is_welcomed_and_gets_frames(shared: Station) -> None:
    with shared.unannounced() as page:
        welcome = page.greet()
        assert (welcome.protocol, welcome.scenario) == (kinds.PROTOCOL, "first-flight")
        frame = page.wait_for(Frame)
        assert len(frame.display.poses) == 7 * len(welcome.bodies)


INVALID_HELLO = {
    "no hello": '{"type":"proceed","seq":1}',
    "no JSON": "hello",
    "empty": "",
    "no number": '{"type":"hello"}',
    "text": '{"type":"hello","protocol":"2"}',
    "field": '{"type":"hello","protocol":2,"more":2}',
    "deep": '{"x":' + "[" * 3000,
    "long": '{"type":"hello","' + "é" * 1000 + '":1}',
    "binary": b"\x00\xff",
}


@pytest.mark.parametrize("first", INVALID_HELLO.values(), ids=INVALID_HELLO)
def test_wrong_first_message_ends_the_connection(shared: Station, first: str | bytes) -> None:
    with shared.unannounced() as page:
        page.send(first)
        assert "hello" in reason_of_close(page)
    shared.check_running()


def test_page_of_another_protocol_is_disconnected(shared: Station) -> None:
    with shared.unannounced() as page:
        page.send('{"type":"hello","protocol":99}')
        text = reason_of_close(page)
        assert "99" in text and str(kinds.PROTOCOL) in text
    shared.check_running()


def reason_of_close(page: Page) -> str:
    """Return the server's reason for closing the connection; check that the close frame's reason begins like it."""
    text = page.rejection()
    closed = closing(page)
    assert closed.rcvd is not None
    assert closed.rcvd.code == 1008
    assert closed.rcvd.reason and text.startswith(closed.rcvd.reason[:20])
    return text


def test_page_without_a_hello_is_disconnected(shared: Station, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(station_page, "HELLO_WITHIN", 0.1)
    with shared.unannounced() as page:
        assert "0.1 s" in page.rejection()
        closing(page)
    shared.check_running()


def test_page_beyond_the_maximum_number_is_rejected(shared: Station) -> None:
    with ExitStack() as pages:
        for _ in range(MAX_PAGES):
            pages.enter_context(shared.page())
        with shared.unannounced() as late:
            late.send(from_page.Hello(kinds.PROTOCOL))
            assert late.rejection() == TOO_MANY_PAGES
            closing(late)
    shared.check_running()


def controllers(count: int = 1, **changed: object) -> str:
    """Return a `Controllers` message with `count` keyboards; `changed` replaces fields of each."""
    used = {"kind": "keyboard", "name": "Keyboard", "deadband": 0, "expo": 0, "bindings": ["KeyW +X"], "centres": []}
    return json.dumps({"type": "controllers", "seq": 1, "controllers": [used | changed] * count})


INVALID = {
    "empty": "",
    "cut short": '{"type":"proceed"',
    "a list": "[]",
    "null": "null",
    "no type": '{"seq":1}',
    "an unknown type": '{"type":"eject","seq":1}',
    "a type that is not text": '{"type":[],"seq":1}',
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
    "a deadband of 1": controllers(deadband=1.0),
    "an invalid binding": controllers(bindings=["KeyW"]),
    "a binding too long": controllers(bindings=["KeyW " + "x" * 17]),
    "too many bindings": controllers(bindings=["KeyW +X"] * 97),
    "a centre of 1": controllers(centres=[1.0]),
    "a mapping that is text": controllers(bindings="KeyW +X"),
    "too many controllers": controllers(count=6),
    "deep lists": '{"x":' + "[" * 3000,
    "deep tables": '{"x":' + '{"x":' * 700,
}


@pytest.mark.parametrize("text", INVALID.values(), ids=INVALID)
def test_invalid_message_is_rejected_and_the_page_stays(shared: Station, text: str) -> None:
    with shared.page() as page:
        page.send(text)
        assert page.wait_for(to_page.Refused).seq == -1
        seq = page.push()
        page.wait_for(Frame, lambda frame: frame.display.stick_seq == seq)
    shared.check_running()


def test_binary_message_is_rejected(shared: Station) -> None:
    with shared.page() as page:
        page.send(text_of(from_page.Proceed(0)).encode())
        assert "binary" in page.rejection()
    shared.check_running()


REFUSED = {
    "a stick beyond full deflection": (from_page.Sticks(0, (0.0, 1.0000001, 0.0), STILL, 0.0), "sticks", "-1", "1"),
    "a huge stick": (from_page.Sticks(0, STILL, (0.0, 0.0, -1e308), 0.0), "sticks", "-1", "1"),
    "a huge drive": (from_page.Sticks(0, STILL, STILL, 7.0), "sticks", "-1", "1"),
    "a joint beyond the last": (from_page.SelectJoint(0, 6), "0 to 5", "got 6"),
    "a joint below the first": (from_page.SelectJoint(0, -1), "0 to 5", "got -1"),
    "an unknown mode": (from_page.EnterMode(0, "WARP"), "mode 'WARP'", "OPR CMD", "ORB LD"),
    "a mode with special characters": (from_page.EnterMode(0, "\x00\n<b>é"), "mode '\\x00\\n<b>é'", "OPR CMD"),
    "a target too far away": (from_page.SetTarget(0, (1e308, 1e308, -1e308), STILL), "1000 m", "1e+308"),
    "a target with a huge angle": (from_page.SetTarget(0, STILL, (1e300, 0.0, 0.0)), "100 rad", "1e+300"),
}


@pytest.mark.parametrize(("message", "parts"), [(m, parts) for m, *parts in REFUSED.values()], ids=REFUSED)
def test_rejected_command_names_what_was_given_and_what_is_allowed(
    direct: DirectStation, message: from_page.FromPage, parts: list[str]
) -> None:
    with direct.page() as page:
        page.send(message)
        refused = page.wait_for(to_page.Refused)
        assert refused.seq == 0
        assert all(part in refused.text for part in parts), refused.text


def test_commands_that_the_simulation_rejects_are_logged(direct: DirectStation) -> None:
    direct.host.step()
    with direct.page() as page:
        page.send(from_page.SetTarget(page.next_seq(), (-50.0, 0.0, 0.0), STILL))
        page.send(from_page.Proceed(page.next_seq()))
        texts: list[str] = []
        while len(texts) < 2:
            events = page.wait_for(to_page.Events).events
            texts += [event.text for event in events if event.kind in ("check", "refused")]
        assert texts[0].startswith("CMD CK FAIL")
        assert texts[1].startswith("PROCEED") and "ORB UNL" in texts[1]


def test_message_out_of_order_is_not_executed(station: Station) -> None:
    with station.page() as page:
        page.send(from_page.SelectJoint(7, 1))
        page.send(from_page.SelectJoint(6, 2))
        page.send(from_page.SelectJoint(7, 3))
        for number in (6, 7):
            refused = page.wait_for(to_page.Refused)
            assert refused.seq == number and "7" in refused.text
        first = page.wait_for(Frame)
        assert page.wait_for(Frame, lambda frame: frame.tick > first.tick + 4).joint == 1
    station.check_running()


def test_too_long_message_ends_its_own_page_only(shared: Station) -> None:
    with shared.page() as other, shared.page() as page:
        page.send(" " * kinds.MAX_MESSAGE_BYTES + "{}")
        closed = closing(page)
        assert closed.rcvd is not None
        assert closed.rcvd.code == 1009
        first = other.wait_for(Frame)
        other.wait_for(Frame, lambda frame: frame.tick > first.tick + 10)
    shared.check_running()


def test_page_that_sends_only_invalid_messages_is_disconnected(shared: Station) -> None:
    with shared.page() as page:
        for _ in range(MAX_REJECTIONS):
            page.send("nonsense")
        for _ in range(MAX_REJECTIONS):
            page.rejection()
        assert str(MAX_REJECTIONS) in page.rejection()
        closing(page)
    shared.check_running()


def test_page_with_some_invalid_messages_stays(shared: Station) -> None:
    with shared.page() as page:
        for _ in range(MAX_REJECTIONS + 5):
            page.send("nonsense")
            page.rejection()
            page.push()
        page.wait_for(Frame, lambda frame: frame.display.stick_seq == page.seq)
    shared.check_running()
