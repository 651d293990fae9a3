"""Roles of the pages of one station: operator, observers, secondary windows."""

from __future__ import annotations

import socket

import pytest

from aftdeck.station.messages import from_page, kinds, to_page
from aftdeck.station.messages.frame import Frame
from aftdeck.station.server.page import MOST_WRONG
from aftdeck.station.session import page_inputs
from aftdeck.station.session.page_inputs import SILENCE
from tests.station.pages import OBSERVES, Station, until


def test_secondary_window_is_neither_operator_nor_observer(station: Station) -> None:
    with station.stranger() as window:
        window.say(from_page.Hello(kinds.PROTOCOL, shows=True))
        assert not window.wait_for(to_page.Role).flying
        with station.page() as page:
            assert page.wait_for(to_page.Role) == to_page.Role(True, 0, 1, 1, asking=0, name="", names=())
            assert page.flown(page.push((1.0, 0.0, 0.0))).translation == (1.0, 0.0, 0.0)
        window.push((1.0, 0.0, 0.0))
        assert window.refusal() == OBSERVES


def test_narrow_page_loses_its_seat_and_rejoins_behind_the_others(station: Station) -> None:
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
        assert narrow.refusal() == OBSERVES
        other.wait_for(to_page.Role, lambda role: role.flying)
        narrow.say(from_page.TakeSeat(narrow.next_seq()))
        assert narrow.wait_for(to_page.Role, lambda role: role.number == 1).flier == 2, "whoever flies goes on"
        other.say(from_page.LeaveSeat(other.next_seq()))
        narrow.wait_for(to_page.Role, lambda role: role.flying)
        assert narrow.flown(narrow.push((0.5, 0.0, 0.0))).translation == (0.5, 0.0, 0.0)


def test_next_page_gets_centred_sticks_when_the_operator_is_cut_off(station: Station) -> None:
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


def test_sticks_of_a_silent_page_go_to_zero(station: Station, monkeypatch: pytest.MonkeyPatch) -> None:
    with station.page() as page:
        seq = page.push(translation=(1.0, 0.0, 0.0))
        page.wait_for(Frame, lambda frame: frame.translation[0] == 1.0)
        monkeypatch.setattr(page_inputs, "SILENCE", SILENCE)
        assert page.wait_for(Frame, lambda frame: frame.translation[0] == 0.0).display.stick_seq == seq


def test_observer_may_not_fly(shared: Station) -> None:
    with shared.page(), shared.page() as watcher:
        for _ in range(MOST_WRONG + 5):  # a watcher is not ended for trying
            watcher.push(translation=(1.0, 0.0, 0.0))
            assert watcher.refusal() == OBSERVES
    shared.is_unhurt()


def test_control_goes_to_the_page_that_asks_with_centred_sticks(station: Station) -> None:
    with station.page() as flier, station.page() as other:
        flier.wait_for(to_page.Role, lambda role: role.flying and role.watchers == 1)
        assert other.wait_for(to_page.Role).flier == 1
        other.say(from_page.AskSticks(other.next_seq()))
        flier.wait_for(to_page.Role, lambda role: role.asking == 2)
        flier.push(translation=(1.0, 0.0, 0.0))
        flier.wait_for(Frame, lambda frame: frame.translation[0] == 1.0)
        flier.say(from_page.GiveSticks(flier.next_seq()))
        assert "at rest" in flier.refusal()
        flier.flown(flier.push())
        flier.say(from_page.GiveSticks(flier.next_seq()))
        assert other.wait_for(to_page.Role, lambda role: role.flying).flier == 2
        assert not flier.wait_for(to_page.Role, lambda role: role.flier == 2).flying
        flier.push(translation=(1.0, 0.0, 0.0))
        assert flier.refusal() == OBSERVES
        assert other.flown(other.push(rotation=(0.0, 0.0, 0.5))).rotation == (0.0, 0.0, 0.5)
    (line,) = [event.text for event in station.session.log.since(0) if event.kind == "hand-over"]
    assert "page 1" in line and "page 2" in line


def test_operator_keeps_control_when_the_request_is_declined(station: Station) -> None:
    with station.page() as flier, station.page() as other:
        flier.say(from_page.AskSticks(flier.next_seq()))
        assert flier.refusal().startswith("you fly")
        flier.say(from_page.GiveSticks(flier.next_seq()))
        assert flier.refusal().startswith("nobody asks")
        other.say(from_page.AskSticks(other.next_seq()))
        flier.wait_for(to_page.Role, lambda role: role.asking == 2)
        flier.say(from_page.KeepSticks(flier.next_seq()))
        assert other.refusal().startswith("page 1 keeps")
        assert flier.wait_for(to_page.Role, lambda role: role.asking == 0).flying


def test_name_goes_to_every_page_and_into_the_log(station: Station) -> None:
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
    until(lambda: "Anna gives the sticks to Ben" in [event.text for event in station.session.log.since(0)], "the line")


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
def test_invalid_name_is_rejected_and_not_corrected(station: Station, name: str, sentence: str) -> None:
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


def test_secondary_window_has_no_name(station: Station) -> None:
    with station.page(), station.stranger() as window:
        window.say(from_page.Hello(kinds.PROTOCOL, shows=True))
        window.say(from_page.SetName(window.next_seq(), "Anna"))
        assert window.refusal() == OBSERVES
