"""Inputs of the page in control: a state machine whose caller passes the time."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from aftdeck.errors import CommandError
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.station.conversion.welcome_of import welcome_of
from aftdeck.station.core.commands import check_switch, travel
from aftdeck.station.core.page_inputs import LOST, MAX_WAITING, STILL, PageInputs
from aftdeck.station.messages import from_page

SILENCE = 0.5
PAN = CameraDrive("A", pan=1.0)


@pytest.fixture(autouse=True)
def limited_silence(monkeypatch: pytest.MonkeyPatch, patient_station: None) -> None:
    """Set the station's time limit, which `patient_station` has removed."""
    monkeypatch.setattr("aftdeck.station.core.page_inputs.SILENCE", SILENCE)


def sticks(seq: int, forward: float) -> from_page.Sticks:
    return from_page.Sticks(seq, (forward, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0)


@given(
    st.lists(st.tuples(st.floats(0.0, 3.0), st.floats(-1.0, 1.0), st.booleans()), max_size=60),
    st.integers(0, 5),
)
def test_deflected_sticks_act_only_while_messages_arrive(events: list[tuple[float, float, bool]], delay: int) -> None:
    """No deflection acts if no message has arrived for longer than the time `SILENCE`.

    After a pause longer than the time `LOST`, no deflection acts until the sticks have been centred.
    """
    inputs, now, last_message, centred_since_loss = PageInputs(delay), 10.0, -math.inf, True
    zeroed = False
    for seq, (pause, forward, sends) in enumerate(events):
        now += pause
        if sends:
            if zeroed and now - last_message > LOST:
                centred_since_loss = False
            centred_since_loss = centred_since_loss or forward == 0.0
            last_message, zeroed = now, False
            try:
                inputs.steer(sticks(seq, forward), now)
            except CommandError:
                assert not centred_since_loss and forward != 0.0
        taken = inputs.take(now, rate_held=False)
        acts = any(travel(taken.sticks))
        zeroed = zeroed or (bool(taken.cause) and not acts)
        assert not acts or (now - last_message <= SILENCE and centred_since_loss)
        assert taken.cause in ("", "sticks silent")


@given(st.lists(st.integers(0, 10_000), min_size=1, max_size=40), st.integers(0, 30))
def test_stick_numbers_leave_the_delay_after_its_duration(numbers: list[int], delay: int) -> None:
    inputs, flown = PageInputs(delay), []
    for number in numbers:
        inputs.steer(sticks(number, 0.0), 1.0)
        flown.append(inputs.take(1.0, rate_held=False).flown())
    assert flown == ([-1] * delay + numbers)[: len(numbers)]


def test_each_step_executes_one_command_in_order() -> None:
    inputs = PageInputs(0)
    sent = [from_page.SelectJoint(seq, seq % 6) for seq in range(MAX_WAITING)]
    for message in sent:
        inputs.command(message)
    with pytest.raises(CommandError):
        inputs.command(from_page.Proceed(99))
    assert [inputs.take(1.0, rate_held=False).command for _ in range(MAX_WAITING + 1)] == [*sent, None]


def test_stop_deletes_commands_and_centres_the_sticks() -> None:
    inputs, stop = PageInputs(0), from_page.Stop(40)
    inputs.steer(sticks(1, 1.0), 1.0)
    inputs.turn(PAN, 1.0)
    for seq in range(MAX_WAITING):
        inputs.command(from_page.SelectJoint(seq, 0))
    inputs.command(stop)
    taken = inputs.take(1.0, rate_held=False)
    assert taken.command == stop and taken.sticks.seq == 1 and not any(travel(taken.sticks)) and taken.camera == STILL
    assert inputs.take(1.0, rate_held=False).command is None


def test_hand_over_needs_centred_sticks_and_is_logged_once() -> None:
    inputs = PageInputs(0)
    inputs.steer(sticks(1, 0.5), 1.0)
    with pytest.raises(CommandError):
        inputs.hand_over("1 to 2")
    assert inputs.take(1.0, rate_held=False).sticks.translation[0] == 0.5
    inputs.steer(sticks(2, 0.0), 1.0)
    inputs.command(from_page.SelectJoint(3, 1))
    inputs.hand_over("1 to 2")
    taken = inputs.take(1.0, rate_held=False)
    assert (taken.cause, taken.handed_over, taken.command) == ("handed over", "1 to 2", None)
    assert inputs.take(1.0, rate_held=False)[3:5] == ("", "")


def test_restart_empties_the_command_delay() -> None:
    inputs = PageInputs(2)
    inputs.steer(sticks(7, 0.0), 1.0)
    for _ in range(2):
        inputs.take(1.0, rate_held=False).flown()
    inputs.command(from_page.Restart(8))
    assert [inputs.take(1.0, rate_held=False).flown() for _ in range(3)] == [-1, -1, 7]


@pytest.mark.parametrize("silent_s", [0.9 * SILENCE, 1.1 * SILENCE])
def test_silent_page_moves_no_camera(silent_s: float) -> None:
    inputs = PageInputs(0)
    inputs.turn(PAN, 1.0)
    camera = inputs.take(1.0 + silent_s, rate_held=False).camera
    assert camera == (PAN if silent_s < SILENCE else STILL)


def test_rate_hold_ends_when_the_page_is_silent() -> None:
    inputs = PageInputs(0)
    inputs.steer(sticks(1, 0.0), 1.0)
    assert inputs.take(1.0 + 1.1 * SILENCE, rate_held=False).cause == ""
    assert inputs.take(1.0 + 1.1 * SILENCE, rate_held=True).cause == "sticks silent"


@pytest.mark.parametrize("angles", [(), (0.0,) * 5, (0.0,) * 7, (1e6,) * 6])
def test_master_arm_needs_a_plausible_angle_for_each_joint(angles: tuple[float, ...]) -> None:
    welcome = welcome_of(load_scenario("first-flight"), demo=False)
    check_switch(from_page.SetMaster(1, (0.0,) * 6), welcome)
    with pytest.raises(CommandError):
        check_switch(from_page.SetMaster(1, angles), welcome)
