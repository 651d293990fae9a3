"""Session: sticks, unattended controls, restart, demonstration and commands."""

from __future__ import annotations

import dataclasses
import math
from typing import Literal

import pytest

from aftdeck.errors import CommandError
from aftdeck.station.core import page_inputs
from aftdeck.station.core.page_inputs import LOST, MAX_WAITING, SILENCE
from aftdeck.station.core.unattended import CAUSES
from aftdeck.station.messages import from_page
from aftdeck.station.messages.frame import Frame
from aftdeck.station.session.session import Session
from tests.loaded import scenario
from tests.station.flying import flying, shown, step_until, steps
from tests.station.pages import STILL


def unattended_causes(session: Session) -> list[str]:
    """Return the causes of unattended controls, in the order of the log."""
    lines = [event.text for event in session.log.since(0) if event.kind == "hands off"]
    return [next(cause for cause, text in CAUSES.items() if line.startswith(f"{text}: ")) for line in lines]


def sticks(seq: int, forward: float = 0.0) -> from_page.Sticks:
    return from_page.Sticks(seq, (forward, 0.0, 0.0), STILL, 0.0)


def test_arm_without_inputs_does_not_move() -> None:
    with flying() as session:
        frame = steps(session, 20)
    assert frame.angles == tuple(scenario().initial_angles.tolist())
    assert frame.display.stick_seq == -1


def test_sticks_move_the_tip_until_the_controls_are_unattended() -> None:
    with flying() as session:
        before = shown(session).display.actual.position
        session.accept(sticks(4, forward=1.0))
        moving = step_until(session, lambda frame: frame.display.actual.velocity[0] > 0.05, "the tip moves forward")
        assert moving.display.stick_seq == 4
        session.set_unattended()
        held = step_until(session, lambda frame: max(abs(rate) for rate in frame.rates) == 0.0, "it stops")
        assert held.display.stick_seq == -1
    assert held.display.actual.position[0] > before[0]


def test_frame_has_the_number_of_the_sticks_that_act_after_the_delay() -> None:
    late = dataclasses.replace(scenario(), delay=25)
    with flying(made=late) as session:
        session.accept(sticks(4, forward=1.0))
        taken = step_until(session, lambda frame: frame.display.stick_seq == 4, "sticks taken")
        assert taken.display.flown_seq == -1 and taken.translation == STILL
        flown = step_until(session, lambda frame: frame.display.flown_seq == 4, "the sticks act")
        assert flown.tick == taken.tick + 25 and flown.translation[0] == 1.0


def test_delayed_sticks_of_one_page_are_not_reported_to_the_next() -> None:
    late = dataclasses.replace(scenario(), delay=25)
    with flying(made=late) as session:
        session.accept(sticks(900))
        taken = step_until(session, lambda frame: frame.display.stick_seq == 900, "sticks taken")
        session.desk.hand_over("page 1 gives the sticks to page 2")
        session.accept(sticks(5))
        numbers = {taken.display.flown_seq}

        def acts(frame: Frame) -> bool:
            numbers.add(frame.display.flown_seq)
            return frame.display.flown_seq == 5

        step_until(session, acts, "the sticks of the new operator act")
        assert numbers == {-1, 5}, "900 is a message number of the other page"


def test_sticks_act_at_once_without_delay_and_not_during_a_script() -> None:
    with flying(demo=True) as session:
        assert shown(session).display.flown_seq == -1
        session.accept(sticks(7, forward=1.0))
        frame = step_until(session, lambda frame: frame.display.stick_seq == 7, "sticks taken")
        assert frame.display.flown_seq == 7


def test_page_that_leaves_ends_rate_hold_and_sets_position_hold() -> None:
    with flying() as session:
        session.accept(sticks(1, forward=0.5))
        session.accept(from_page.RateHold(2))
        step_until(session, lambda frame: frame.rate_hold, "RATE HOLD")
        session.accept(sticks(3))
        assert steps(session, 5).translation[0] == 0.5
        session.set_unattended()
        frame = step_until(session, lambda frame: not frame.rate_hold, "RATE HOLD off")
        assert frame.position_hold and frame.translation == STILL
        step_until(session, lambda frame: max(abs(rate) for rate in frame.rates) < 1e-6, "the arm stops")
        assert unattended_causes(session) == ["page gone"]
        session.set_unattended()
        steps(session, 3)
        assert unattended_causes(session) == ["page gone"]


@pytest.mark.parametrize("cause", ["page hidden", "device lost"])
def test_hands_off_sets_position_hold_and_the_sequence_continues(
    cause: Literal["page hidden", "device lost"],
) -> None:
    with flying() as session:
        x, y, z = shown(session).display.actual.position
        session.accept(from_page.EnterMode(0, "OPR CMD"))
        session.accept(from_page.SetTarget(1, (x + 0.1, y, z), shown(session).display.actual.attitude))
        session.accept(from_page.Proceed(2))
        step_until(session, lambda frame: frame.sequence == "in progress", "the motion")
        session.accept(from_page.HandsOff(3, cause))
        frame = step_until(session, lambda frame: frame.position_hold, "POSITION HOLD")
        assert frame.sequence == "in progress"
        session.set_unattended()  # now no page can stop the sequence
        step_until(session, lambda frame: frame.sequence != "in progress", "STOP")
        assert unattended_causes(session)[-1] == "page gone"


def test_demonstration_continues_without_pages() -> None:
    with flying(demo=True) as session:
        step_until(session, lambda frame: frame.phase == "up", "the script's first phase")
        session.accept(from_page.HandsOff(0, "page hidden"))
        session.set_unattended()
        frame = steps(session, 10)
        assert frame.by == "script" and not frame.position_hold


def test_rate_hold_ends_when_its_page_is_silent(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(page_inputs, "SILENCE", SILENCE)
    with flying() as session:
        session.accept(sticks(1, forward=1.0))
        session.accept(from_page.RateHold(2))
        step_until(session, lambda frame: frame.rate_hold, "RATE HOLD")
        for seq in range(3, 6):
            session.now += 0.9 * SILENCE
            session.accept(sticks(seq))
            assert steps(session, 3).rate_hold
        session.now += 1.1 * SILENCE
        assert step_until(session, lambda frame: not frame.rate_hold, "RATE HOLD off").position_hold


def test_rate_hold_is_cancelled_once_through_a_command_delay(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(page_inputs, "SILENCE", SILENCE)
    delayed = dataclasses.replace(scenario(), delay=20)
    with flying(made=delayed) as session:
        session.accept(sticks(1, forward=1.0))
        session.accept(from_page.RateHold(2))
        step_until(session, lambda frame: frame.rate_hold, "RATE HOLD, delayed")
        session.now += 1.1 * SILENCE
        assert step_until(session, lambda frame: not frame.rate_hold, "RATE HOLD off").position_hold
        steps(session, 30)
        assert not [event.text for event in session.log.since(0) if event.kind == "refused"]
        assert len([event for event in session.log.since(0) if event.kind == "hands off"]) == 1


def test_hidden_and_silent_page_cancels_rate_hold_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(page_inputs, "SILENCE", SILENCE)
    with flying(made=dataclasses.replace(scenario(), delay=40)) as session:
        session.accept(sticks(1, forward=1.0))
        session.accept(from_page.RateHold(2))
        step_until(session, lambda frame: frame.rate_hold, "RATE HOLD, delayed")
        session.accept(sticks(3))
        session.accept(from_page.HandsOff(4, "page hidden"))
        steps(session, 5)
        session.now += 1.1 * SILENCE
        step_until(session, lambda frame: not frame.rate_hold, "RATE HOLD off")
        steps(session, 60)
        assert unattended_causes(session) == ["page hidden"]
        assert not [event for event in session.log.since(0) if event.kind == "refused"]


def test_unattended_controls_delete_waiting_commands() -> None:
    with flying() as session:
        session.accept(from_page.SelectJoint(0, 5))
        session.set_unattended()
        assert steps(session, 3).joint == 0


def test_sticks_are_centred_after_the_silence_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(page_inputs, "SILENCE", SILENCE)
    with flying() as session:
        session.accept(sticks(4, forward=1.0))
        step_until(session, lambda frame: frame.translation[0] == 1.0, "the sticks")
        session.now += 0.99 * SILENCE
        assert steps(session, 5).translation[0] == 1.0
        session.now += 0.02 * SILENCE
        assert steps(session, 5).translation == STILL
        assert shown(session).display.stick_seq == 4


def test_sticks_after_a_long_silence_must_be_centred_first(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(page_inputs, "SILENCE", SILENCE)
    with flying() as session:
        session.accept(sticks(4, forward=1.0))
        step_until(session, lambda frame: frame.translation[0] == 1.0, "the sticks")
        session.now += max(1.02 * SILENCE, 1.02 * LOST)
        step_until(session, lambda frame: frame.translation == STILL and frame.position_hold, "unattended")
        with pytest.raises(CommandError, match=f"{LOST:g} s"):
            session.accept(sticks(5, forward=1.0))
        session.accept(sticks(6, forward=1.0))  # reported once
        step_until(session, lambda frame: frame.display.stick_seq == 6, "received")
        assert steps(session, 20).translation == STILL
        session.accept(sticks(7))
        session.accept(sticks(8, forward=1.0))
        step_until(session, lambda frame: frame.translation[0] == 1.0, "the sticks act again")


def test_restart_begins_at_the_initial_state() -> None:
    with flying() as session:
        session.accept(sticks(0, forward=1.0))
        steps(session, 30)
        session.set_unattended()
        session.accept(from_page.Restart(1))
        frame = step_until(session, lambda frame: frame.tick == 1, "the restart")
        assert frame.angles == pytest.approx(tuple(scenario().initial_angles.tolist()), abs=1e-12)
        assert [event.kind for event in session.log.since(0)][-1] == "restart"


def test_demonstration_runs_until_a_stick_moves() -> None:
    with flying(demo=True) as session:
        assert step_until(session, lambda frame: frame.phase == "up", "the script's first phase").by == "script"
        session.accept(sticks(0, forward=0.0005))
        assert steps(session, 5).by == "script"
        session.accept(sticks(1, forward=0.2))
        assert step_until(session, lambda frame: frame.by == "hand", "manual control").phase == ""
        assert "hand" in [event.kind for event in session.log.since(0)]


def test_demonstration_ends_with_its_script() -> None:
    with flying(demo=True) as session:
        session._sim._state.script.ended = "completed"
        assert step_until(session, lambda frame: frame.by == "hand", "manual control").mode == "ORB UNL"


def test_arm_moves_to_a_keyed_in_target() -> None:
    with flying() as session:
        here = shown(session).display.actual
        x, y, z = here.position
        session.accept(from_page.EnterMode(0, "OPR CMD"))
        session.accept(from_page.SetTarget(1, (x + 0.05, y, z), here.attitude))
        session.accept(from_page.Proceed(2))
        moving = step_until(session, lambda frame: frame.sequence == "in progress", "in progress")
        assert moving.display.aim is not None and moving.goal is not None
        assert moving.display.aim.position == pytest.approx((x + 0.05, y, z), abs=1e-9)
        assert moving.goal.distance == pytest.approx(0.05, abs=0.02)
        final = step_until(session, lambda frame: frame.sequence == "idle", "the end of the motion")
        assert math.dist(final.display.actual.position, (x + 0.05, y, z)) < 1e-3


def test_command_beyond_the_maximum_number_is_rejected() -> None:
    session = Session(scenario())
    for seq in range(MAX_WAITING):
        session.accept(from_page.SelectJoint(seq, 1))
    with pytest.raises(CommandError, match=str(MAX_WAITING)):
        session.accept(from_page.SelectJoint(99, 1))
    session.accept(from_page.Stop(100))
