"""Inputs resampled to another control period: no switch is lost or doubled."""

from __future__ import annotations

import itertools
from fractions import Fraction

import hypothesis.strategies as st
import msgspec
import pytest
from hypothesis import given, settings

from aftdeck.recording.records import Input
from aftdeck.recording.resample import resampled
from aftdeck.scenario.target import Target

OLD = 0.02
PERIODS = [0.001, 0.005, 0.01, 0.0125, 0.02, 0.03, 0.04, 0.05, 0.08, 0.2]
SWITCHES = ("mode", "joint", "rate", "law", "payload_axes", "position_hold")

stick = st.sampled_from([-1.0, -0.25, 0.0, 0.5])
steps = st.builds(
    Input,
    tick=st.just(0),
    translation=st.tuples(stick, stick, stick),
    drive=stick,
    mode=st.sampled_from([None, None, "ORB UNL", "SINGLE", "OPR CMD"]),
    joint=st.sampled_from([None, None, 0, 3]),
    rate=st.sampled_from([None, "coarse", "vernier"]),
    law=st.sampled_from([None, None, "position"]),
    payload_axes=st.sampled_from([None, True, False]),
    position_hold=st.sampled_from([None, True, False]),
    rate_hold=st.booleans(),
    proceed=st.sampled_from([False, False, True]),
    stop=st.sampled_from([False, False, True]),
)


def numbered(made: list[Input]) -> list[Input]:
    return [msgspec.structs.replace(step, tick=tick) for tick, step in enumerate(made, 1)]


input_lists = st.lists(steps, max_size=40).map(numbered)


def resample_to(inputs: list[Input], new: float, old: float = OLD) -> list[Input]:
    return list(resampled(iter(inputs), old, new))


@settings(max_examples=40)
@given(input_lists)
def test_same_period_changes_nothing(inputs: list[Input]) -> None:
    assert resample_to(inputs, OLD) == inputs


@settings(max_examples=40)
@given(input_lists, st.sampled_from(PERIODS))
def test_length_is_kept_to_one_step(inputs: list[Input], new: float) -> None:
    made = resample_to(inputs, new)
    assert [step.tick for step in made] == list(range(1, len(made) + 1))
    whole = len(inputs) * Fraction(str(OLD)) / Fraction(str(new))
    assert whole <= len(made) < whole + 1


@settings(max_examples=40)
@given(input_lists, st.sampled_from(PERIODS))
def test_no_switch_is_lost_or_doubled(inputs: list[Input], new: float) -> None:
    made = resample_to(inputs, new)
    for name in SWITCHES:
        moves = [getattr(step, name) for step in inputs if getattr(step, name) is not None]
        new_moves = [getattr(step, name) for step in made if getattr(step, name) is not None]
        # a longer step uses the last of several positions
        assert len(new_moves) <= len(moves) and new_moves[-1:] == moves[-1:]
        if new <= OLD:
            assert new_moves == moves
    for name in ("proceed", "stop", "rate_hold"):
        presses = sum(getattr(step, name) for step in inputs)
        new_presses = sum(getattr(step, name) for step in made)
        assert new_presses == presses if new <= OLD else new_presses <= presses
    assert sum(step.rate_hold for step in made) % 2 == sum(step.rate_hold for step in inputs) % 2


@settings(max_examples=40)
@given(input_lists, st.sampled_from(PERIODS))
def test_sticks_are_the_latest_ones(inputs: list[Input], new: float) -> None:
    old_period, new_period = Fraction(str(OLD)), Fraction(str(new))
    for step in resample_to(inputs, new):
        begun = [given for given in inputs if (given.tick - 1) * old_period < step.tick * new_period]
        assert (step.translation, step.drive) == (begun[-1].translation, begun[-1].drive)


@settings(max_examples=40)
@given(input_lists, st.sampled_from([p for p in PERIODS if p >= OLD]))
def test_stop_acts_in_the_step_of_its_time(inputs: list[Input], new: float) -> None:
    made = resample_to(inputs, new)
    for old_step in inputs:
        if old_step.stop:
            # the first new step that ends after the beginning of the old step
            tick = next(k for k in itertools.count(1) if k * new - 1e-9 > (old_step.tick - 1) * OLD)
            assert made[tick - 1].stop


@pytest.mark.parametrize(
    ("first", "second", "proceeds"),
    [("proceed", "stop", False), ("stop", "proceed", True)],
)
def test_later_of_stop_and_proceed_in_a_step_wins(first: str, second: str, proceeds: bool) -> None:
    presses = [Input(tick=1), Input(tick=2), msgspec.structs.replace(Input(tick=3), **{first: True})]
    (_, step) = resample_to([*presses, msgspec.structs.replace(Input(tick=4), **{second: True})], 0.04)
    assert step.stop and step.proceed == proceeds


@pytest.mark.parametrize("name", ["proceed", "stop"])
@pytest.mark.parametrize("pressed", [1, 2, 3, 4])
def test_press_in_any_old_step_acts_in_the_new_step(name: str, pressed: int) -> None:
    presses = [msgspec.structs.replace(Input(tick=tick), **{name: tick == pressed}) for tick in (1, 2, 3, 4)]
    made = resample_to(presses, 0.08)
    assert [(step.proceed, step.stop) for step in made] == [(name == "proceed", name == "stop")]


def test_target_is_not_mixed_from_two_targets() -> None:
    turn = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    by_joints = Input(tick=1, target=Target((1.0, 2.0, 3.0), turn, (0.0,) * 6))
    by_pose = Input(tick=2, target=Target((4.0, 5.0, 6.0), turn))
    (step,) = resample_to([by_joints, by_pose], 0.04)
    assert step.target == by_pose.target


def test_scripted_steps_stay_scripted() -> None:
    script = [Input(tick=tick, script=True) for tick in range(1, 11)]
    for new in PERIODS:
        assert all(step.script for step in resample_to(script, new))
