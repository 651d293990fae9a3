"""Roles of the pages of one station: operator, observers, secondary windows."""

from __future__ import annotations

import socket

import pytest

from aftdeck.station.core import page_inputs
from aftdeck.station.core.desk import NOT_IN_CONTROL
from aftdeck.station.core.page_inputs import SILENCE
from aftdeck.station.messages import from_page, kinds, to_page
from aftdeck.station.messages.frame import Frame
from aftdeck.station.server.page import MAX_REJECTIONS
from tests.station.direct_pages import DirectStation
from tests.station.pages import Station


def hand_overs(station: DirectStation) -> list[str]:
    """Return the log lines about handovers of control."""
    return [event.text for event in station.session.log.since(0) if event.kind == "hand-over"]


def test_secondary_window_is_neither_operator_nor_observer(station: Station) -> None:
    with station.unannounced() as window:
        window.send(from_page.Hello(kinds.PROTOCOL, shows=True))
        assert not window.wait_for(to_page.Role).flying
        with station.page() as page:
            assert page.wait_for(to_page.Role) == to_page.Role(True, True, 0, 1, 1, asking=0, name="", names=())
            assert page.flown(page.push((1.0, 0.0, 0.0))).translation == (1.0, 0.0, 0.0)
        window.push((1.0, 0.0, 0.0))
        assert window.rejection() == NOT_IN_CONTROL


def test_narrow_page_loses_control_and_rejoins_behind_the_others(station: Station) -> None:
    with station.page() as narrow, station.page() as other:
        narrow.wait_for(to_page.Role, lambda role: role.flying and role.watchers == 1)
        narrow.push(translation=(1.0, 0.0, 0.0))
        narrow.wait_for(Frame, lambda frame: frame.translation[0] == 1.0)
        narrow.send(from_page.LeaveSeat(narrow.next_seq()))
        assert narrow.wait_for(to_page.Role, lambda role: not role.flying) == to_page.Role(
            False, True, 0, 0, flier=2, asking=0, name="", names=()
        )
        assert narrow.wait_for(Frame, lambda frame: frame.position_hold).translation == (0.0, 0.0, 0.0)
        narrow.send(from_page.AskSticks(narrow.next_seq()))
        assert narrow.rejection() == NOT_IN_CONTROL
        other.wait_for(to_page.Role, lambda role: role.flying)
        narrow.send(from_page.TakeSeat(narrow.next_seq()))
        assert narrow.wait_for(to_page.Role, lambda role: role.number == 1).flier == 2, "the operator stays in control"
        other.send(from_page.LeaveSeat(other.next_seq()))
        narrow.wait_for(to_page.Role, lambda role: role.flying)
        assert narrow.flown(narrow.push((0.5, 0.0, 0.0))).translation == (0.5, 0.0, 0.0)


def test_next_page_gets_centred_sticks_when_the_operator_disconnects(station: Station) -> None:
    with station.unannounced() as second, station.page() as first:
        # `first` is welcomed first and takes control
        second.greet()
        assert first.wait_for(to_page.Role).flying
        assert not second.wait_for(to_page.Role).flying
        first.push(translation=(1.0, 0.0, 0.0))
        second.wait_for(Frame, lambda frame: frame.translation[0] == 1.0)
        first.socket.socket.shutdown(socket.SHUT_RDWR)  # without a close frame
        assert second.wait_for(to_page.Role, lambda role: role.flying).watchers == 0
        frame = second.wait_for(Frame, lambda frame: frame.translation[0] == 0.0)
        assert frame.display.stick_seq == -1, "centred because the operator changed, not because of silence"
        seq = second.push(rotation=(0.0, 0.0, 0.5))
        assert second.wait_for(Frame, lambda frame: frame.display.stick_seq == seq).rotation == (0.0, 0.0, 0.5)


def test_sticks_of_a_silent_page_go_to_zero(direct: DirectStation, monkeypatch: pytest.MonkeyPatch) -> None:
    with direct.page() as page:
        seq = page.push(translation=(1.0, 0.0, 0.0))
        page.wait_for(Frame, lambda frame: frame.translation[0] == 1.0)
        monkeypatch.setattr(page_inputs, "SILENCE", SILENCE)
        assert page.wait_for(Frame, lambda frame: frame.translation[0] == 0.0).display.stick_seq == seq


def test_observer_cannot_send_commands(shared: Station) -> None:
    with shared.page(), shared.page() as observer:
        for _ in range(MAX_REJECTIONS + 5):  # they do not count towards MAX_REJECTIONS
            observer.push(translation=(1.0, 0.0, 0.0))
            assert observer.rejection() == NOT_IN_CONTROL
    shared.check_running()


def test_control_goes_to_the_page_that_asks_with_centred_sticks(direct: DirectStation) -> None:
    with direct.page() as operator, direct.page() as other:
        operator.wait_for(to_page.Role, lambda role: role.flying and role.watchers == 1)
        assert other.wait_for(to_page.Role).flier == 1
        other.send(from_page.AskSticks(other.next_seq()))
        operator.wait_for(to_page.Role, lambda role: role.asking == 2)
        operator.push(translation=(1.0, 0.0, 0.0))
        operator.wait_for(Frame, lambda frame: frame.translation[0] == 1.0)
        operator.send(from_page.GiveSticks(operator.next_seq()))
        assert operator.wait_for(to_page.Refused).seq == operator.seq
        operator.flown(operator.push())
        operator.send(from_page.GiveSticks(operator.next_seq()))
        assert other.wait_for(to_page.Role, lambda role: role.flying).flier == 2
        assert not operator.wait_for(to_page.Role, lambda role: role.flier == 2).flying
        operator.push(translation=(1.0, 0.0, 0.0))
        assert operator.rejection() == NOT_IN_CONTROL
        other.push(rotation=(0.0, 0.0, 0.5))
        other.wait_for(Frame, lambda frame: frame.rotation == (0.0, 0.0, 0.5))
    (line,) = hand_overs(direct)
    assert "page 1" in line and "page 2" in line


def test_operator_keeps_control_when_the_request_is_declined(direct: DirectStation) -> None:
    with direct.page() as operator, direct.page() as other:
        operator.send(from_page.AskSticks(operator.next_seq()))
        assert operator.wait_for(to_page.Refused).seq == operator.seq
        operator.send(from_page.GiveSticks(operator.next_seq()))
        assert operator.wait_for(to_page.Refused).seq == operator.seq
        other.send(from_page.AskSticks(other.next_seq()))
        operator.wait_for(to_page.Role, lambda role: role.asking == 2)
        operator.send(from_page.KeepSticks(operator.next_seq()))
        assert "page 1" in other.rejection()
        assert operator.wait_for(to_page.Role, lambda role: role.asking == 0).flying


def test_name_goes_to_every_page_and_into_the_log(direct: DirectStation) -> None:
    with direct.page() as operator, direct.page() as other:
        operator.send(from_page.SetName(operator.next_seq(), "Anna"))
        anna = to_page.NamedPage(1, "Anna")
        assert other.wait_for(to_page.Role, lambda role: role.names == (anna,)).name == ""
        other.send(from_page.SetName(other.next_seq(), "Ben"))  # an observer may have a name too
        both = operator.wait_for(to_page.Role, lambda role: len(role.names) == 2)
        assert both.names == (anna, to_page.NamedPage(2, "Ben")) and both.name == "Anna"
        other.send(from_page.AskSticks(other.next_seq()))
        operator.wait_for(to_page.Role, lambda role: role.asking == 2)
        operator.send(from_page.KeepSticks(operator.next_seq()))
        assert "Anna" in other.rejection()
        operator.wait_for(to_page.Role, lambda role: role.asking == 0)
        other.send(from_page.AskSticks(other.next_seq()))
        operator.wait_for(to_page.Role, lambda role: role.asking == 2)
        operator.send(from_page.GiveSticks(operator.next_seq()))
        other.wait_for(to_page.Role, lambda role: role.flying)
        other.send(from_page.SetName(other.next_seq(), ""))
        assert operator.wait_for(to_page.Role, lambda role: len(role.names) == 1).names == (anna,)
    direct.host.step()
    (line,) = hand_overs(direct)
    assert line.startswith("Anna ") and line.endswith(" Ben")


@pytest.mark.parametrize(
    ("name", "part"),
    [
        ("A" * 25, "24 characters at most, got 25"),
        (" Anna", "got ' Anna'"),
        ("   ", "got '   '"),
        ("Anna\nflies", "got 'Anna\\nflies'"),
        ("\u202eannA", "got '\\u202eannA'"),
    ],
)
def test_invalid_name_is_rejected_and_not_corrected(direct: DirectStation, name: str, part: str) -> None:
    with direct.page() as page:
        page.send(from_page.SetName(page.next_seq(), "Anna"))
        page.wait_for(to_page.Role, lambda role: role.name == "Anna")
        page.send(from_page.SetName(page.next_seq(), name))
        refused = page.wait_for(to_page.Refused)
        assert refused.seq == page.seq and part in refused.text
        page.send(from_page.AskSticks(page.next_seq()))
        page.wait_for(to_page.Refused)
        with direct.page() as other:
            assert other.wait_for(to_page.Role, lambda role: role.number == 2).names == (to_page.NamedPage(1, "Anna"),)


def test_secondary_window_has_no_name(station: Station) -> None:
    with station.page(), station.unannounced() as window:
        window.send(from_page.Hello(kinds.PROTOCOL, shows=True))
        window.send(from_page.SetName(window.next_seq(), "Anna"))
        assert window.rejection() == NOT_IN_CONTROL
