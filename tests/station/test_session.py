from __future__ import annotations

import dataclasses
import math
from typing import Literal

import pytest

from aftdeck.errors import CommandError
from aftdeck.station.messages import from_page
from aftdeck.station.messages.frame import Frame
from aftdeck.station.session import page_inputs
from aftdeck.station.session.page_inputs import LOST, MOST_WAITING, SILENCE
from aftdeck.station.session.session import Session
from aftdeck.station.session.unattended import CAUSES
from tests.station.flying import comes, flying, shown, steps
from tests.station.pages import STILL, scenario


def left(session: Session) -> list[str]:
    """The causes for which the controls were unattended, in the order of the log."""
    texts = [event.text for event in session.log.since(0) if event.kind == "hands off"]
    return [next(cause for cause, text in CAUSES.items() if said.startswith(f"{text}: ")) for said in texts]


def sticks(seq: int, forward: float = 0.0) -> from_page.Sticks:
    return from_page.Sticks(seq, (forward, 0.0, 0.0), STILL, 0.0)


def test_an_arm_that_nobody_flies_stands_still() -> None:
    with flying() as session:
        frame = steps(session, 20)
    assert frame.angles == tuple(scenario().initial_angles.tolist())
    assert frame.display.stick_seq == -1


def test_sticks_move_the_tip_and_letting_go_stops_it() -> None:
    with flying() as session:
        before = shown(session).display.actual.position
        session.steer(sticks(4, forward=1.0))
        moving = comes(session, lambda frame: frame.display.actual.velocity[0] > 0.05, "the tip moves forward")
        assert moving.display.stick_seq == 4
        session.let_go()
        held = comes(session, lambda frame: max(abs(rate) for rate in frame.rates) == 0.0, "it stops")
        assert held.display.stick_seq == -1
    assert held.display.actual.position[0] > before[0]


def test_a_frame_tells_which_sticks_it_has_flown_after_the_command_delay() -> None:
    late = dataclasses.replace(scenario(), delay=25)
    with flying(made=late) as session:
        session.steer(sticks(4, forward=1.0))
        taken = comes(session, lambda frame: frame.display.stick_seq == 4, "sticks taken")
        assert taken.display.flown_seq == -1 and taken.translation == STILL
        flown = comes(session, lambda frame: frame.display.flown_seq == 4, "sticks flown")
        assert flown.tick == taken.tick + 25 and flown.translation[0] == 1.0


def test_sticks_under_way_are_not_told_to_the_page_that_flies_next() -> None:
    late = dataclasses.replace(scenario(), delay=25)
    with flying(made=late) as session:
        session.steer(sticks(900))
        taken = comes(session, lambda frame: frame.display.stick_seq == 900, "sticks taken")
        session.hand_over("page 1 gives the sticks to page 2")
        session.steer(sticks(5))
        told = {taken.display.flown_seq}

        def flies(frame: Frame) -> bool:
            told.add(frame.display.flown_seq)
            return frame.display.flown_seq == 5

        comes(session, flies, "the next page's sticks are flown")
        assert told == {-1, 5}, "900 was the number of another page's sticks"


def test_without_a_delay_the_sticks_taken_are_flown_and_a_script_flies_none() -> None:
    with flying(demo=True) as session:
        assert shown(session).display.flown_seq == -1
        session.steer(sticks(7, forward=1.0))
        frame = comes(session, lambda frame: frame.display.stick_seq == 7, "sticks taken")
        assert frame.display.flown_seq == 7


def test_whoever_leaves_leaves_the_arm_holding_its_position() -> None:
    with flying() as session:
        session.steer(sticks(1, forward=0.5))
        session.command(from_page.RateHold(2))
        comes(session, lambda frame: frame.rate_hold, "RATE HOLD")
        session.steer(sticks(3))
        assert steps(session, 5).translation[0] == 0.5
        session.let_go()
        frame = comes(session, lambda frame: not frame.rate_hold, "RATE HOLD let go")
        assert frame.position_hold and frame.translation == STILL
        comes(session, lambda frame: max(abs(rate) for rate in frame.rates) < 1e-6, "it rests")
        assert left(session) == ["page gone"]
        session.let_go()
        steps(session, 3)
        assert left(session) == ["page gone"]


@pytest.mark.parametrize("cause", ["page hidden", "device lost"])
def test_a_page_that_says_so_is_left_alone_and_its_sequence_steps(
    cause: Literal["page hidden", "device lost"],
) -> None:
    with flying() as session:
        x, y, z = shown(session).display.actual.position
        session.command(from_page.EnterMode(0, "OPR CMD"))
        session.command(from_page.SetTarget(1, (x + 0.1, y, z), shown(session).display.actual.attitude))
        session.command(from_page.Proceed(2))
        comes(session, lambda frame: frame.sequence == "in progress", "under way")
        session.command(from_page.HandsOff(3, cause))
        frame = comes(session, lambda frame: frame.position_hold, "POSITION HOLD")
        assert frame.sequence == "in progress"
        session.let_go()  # now nobody could stop it
        comes(session, lambda frame: frame.sequence != "in progress", "STOP")
        assert left(session)[-1] == "page gone"


def test_a_demonstration_steps_when_nobody_looks() -> None:
    with flying(demo=True) as session:
        comes(session, lambda frame: frame.phase == "up", "the script's first phase")
        session.command(from_page.HandsOff(0, "page hidden"))
        session.let_go()
        frame = steps(session, 10)
        assert frame.by == "script" and not frame.position_hold


def test_a_held_rate_needs_a_page_that_is_heard_of(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(page_inputs, "SILENCE", SILENCE)
    with flying() as session:
        session.steer(sticks(1, forward=1.0))
        session.command(from_page.RateHold(2))
        comes(session, lambda frame: frame.rate_hold, "RATE HOLD")
        for seq in range(3, 6):
            session.now += 0.9 * SILENCE
            session.steer(sticks(seq))
            assert steps(session, 3).rate_hold
        session.now += 1.1 * SILENCE
        assert comes(session, lambda frame: not frame.rate_hold, "it is let go").position_hold


def test_a_held_rate_that_is_let_go_through_a_delay_is_let_go_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(page_inputs, "SILENCE", SILENCE)
    delayed = dataclasses.replace(scenario(), delay=20)
    with flying(made=delayed) as session:
        session.steer(sticks(1, forward=1.0))
        session.command(from_page.RateHold(2))
        comes(session, lambda frame: frame.rate_hold, "RATE HOLD, delayed")
        session.now += 1.1 * SILENCE
        assert comes(session, lambda frame: not frame.rate_hold, "it is let go").position_hold
        steps(session, 30)
        assert not [event.text for event in session.log.since(0) if event.kind == "refused"]
        assert len([event for event in session.log.since(0) if event.kind == "hands off"]) == 1


def test_a_hidden_page_that_falls_silent_lets_a_held_rate_go_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(page_inputs, "SILENCE", SILENCE)
    with flying(made=dataclasses.replace(scenario(), delay=40)) as session:
        session.steer(sticks(1, forward=1.0))
        session.command(from_page.RateHold(2))
        comes(session, lambda frame: frame.rate_hold, "RATE HOLD, delayed")
        session.steer(sticks(3))
        session.command(from_page.HandsOff(4, "page hidden"))
        steps(session, 5)
        session.now += 1.1 * SILENCE
        comes(session, lambda frame: not frame.rate_hold, "it is let go")
        steps(session, 60)
        assert left(session) == ["page hidden"]
        assert not [event for event in session.log.since(0) if event.kind == "refused"]


def test_letting_go_forgets_the_commands_that_wait() -> None:
    with flying() as session:
        session.command(from_page.SelectJoint(0, 5))
        session.let_go()
        assert steps(session, 3).joint == 0


def test_silent_sticks_go_to_zero_and_no_sooner(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(page_inputs, "SILENCE", SILENCE)
    with flying() as session:
        session.steer(sticks(4, forward=1.0))
        comes(session, lambda frame: frame.translation[0] == 1.0, "the sticks")
        session.now += 0.99 * SILENCE
        assert steps(session, 5).translation[0] == 1.0
        session.now += 0.02 * SILENCE
        assert steps(session, 5).translation == STILL
        assert shown(session).display.stick_seq == 4


def test_sticks_that_were_lost_are_flown_again_once_they_were_at_rest(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(page_inputs, "SILENCE", SILENCE)
    with flying() as session:
        session.steer(sticks(4, forward=1.0))
        comes(session, lambda frame: frame.translation[0] == 1.0, "the sticks")
        session.now += max(1.02 * SILENCE, 1.02 * LOST)
        comes(session, lambda frame: frame.translation == STILL and frame.position_hold, "nobody flies")
        with pytest.raises(CommandError, match="silent"):
            session.steer(sticks(5, forward=1.0))
        session.steer(sticks(6, forward=1.0))  # told once
        comes(session, lambda frame: frame.display.stick_seq == 6, "heard")
        assert steps(session, 20).translation == STILL
        session.steer(sticks(7))
        session.steer(sticks(8, forward=1.0))
        comes(session, lambda frame: frame.translation[0] == 1.0, "flown again")


def test_a_restart_begins_anew() -> None:
    with flying() as session:
        session.steer(sticks(0, forward=1.0))
        steps(session, 30)
        session.let_go()
        session.command(from_page.Restart(1))
        frame = comes(session, lambda frame: frame.tick == 1, "the first instant again")
        assert frame.angles == pytest.approx(tuple(scenario().initial_angles.tolist()), abs=1e-12)
        assert [event.kind for event in session.log.since(0)][-1] == "restart"


def test_a_demonstration_flies_until_a_stick_moves() -> None:
    with flying(demo=True) as session:
        assert comes(session, lambda frame: frame.phase == "up", "the script's first phase").by == "script"
        session.steer(sticks(0, forward=0.0005))
        assert steps(session, 5).by == "script"
        session.steer(sticks(1, forward=0.2))
        assert comes(session, lambda frame: frame.by == "hand", "the hand").phase == ""
        assert "hand" in [event.kind for event in session.log.since(0)]


def test_a_demonstration_ends_with_its_script() -> None:
    with flying(demo=True) as session:
        session._sim._state.script.ended = "completed"
        assert comes(session, lambda frame: frame.by == "hand", "the hand").mode == "ORB UNL"


def test_a_target_keyed_in_is_flown_to() -> None:
    with flying() as session:
        here = shown(session).display.actual
        x, y, z = here.position
        session.command(from_page.EnterMode(0, "OPR CMD"))
        session.command(from_page.SetTarget(1, (x + 0.05, y, z), here.attitude))
        session.command(from_page.Proceed(2))
        under_way = comes(session, lambda frame: frame.sequence == "in progress", "under way")
        assert under_way.display.aim is not None and under_way.goal is not None
        assert under_way.display.aim.position == pytest.approx((x + 0.05, y, z), abs=1e-9)
        assert under_way.goal.distance == pytest.approx(0.05, abs=0.02)
        there = comes(session, lambda frame: frame.sequence == "idle", "there")
        assert math.dist(there.display.actual.position, (x + 0.05, y, z)) < 1e-3


def test_more_commands_than_may_wait_are_refused() -> None:
    session = Session(scenario())
    for seq in range(MOST_WAITING):
        session.command(from_page.SelectJoint(seq, 1))
    with pytest.raises(CommandError, match=f"{MOST_WAITING} commands"):
        session.command(from_page.SelectJoint(99, 1))
    session.command(from_page.Stop(100))
