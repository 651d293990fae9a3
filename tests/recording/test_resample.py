"""Inputs at another control period: no switch is lost, none is doubled."""

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
    return [msgspec.structs.replace(one, tick=tick) for tick, one in enumerate(made, 1)]


flights = st.lists(steps, max_size=40).map(numbered)


def at(inputs: list[Input], new: float, old: float = OLD) -> list[Input]:
    return list(resampled(iter(inputs), old, new))


@settings(max_examples=40)
@given(flights)
def test_the_same_period_changes_nothing(inputs: list[Input]) -> None:
    assert at(inputs, OLD) == inputs


@settings(max_examples=40)
@given(flights, st.sampled_from(PERIODS))
def test_the_flight_lasts_as_long_to_the_step(inputs: list[Input], new: float) -> None:
    made = at(inputs, new)
    assert [one.tick for one in made] == list(range(1, len(made) + 1))
    whole = len(inputs) * Fraction(str(OLD)) / Fraction(str(new))
    assert whole <= len(made) < whole + 1


@settings(max_examples=40)
@given(flights, st.sampled_from(PERIODS))
def test_no_switch_is_lost_and_none_is_doubled(inputs: list[Input], new: float) -> None:
    made = at(inputs, new)
    for name in SWITCHES:
        moved = [getattr(one, name) for one in inputs if getattr(one, name) is not None]
        flown = [getattr(one, name) for one in made if getattr(one, name) is not None]
        # a coarser step flies the last of several positions
        assert len(flown) <= len(moved) and flown[-1:] == moved[-1:]
        if new <= OLD:
            assert flown == moved
    for name in ("proceed", "stop", "rate_hold"):
        pressed = sum(getattr(one, name) for one in inputs)
        flown_presses = sum(getattr(one, name) for one in made)
        assert flown_presses == pressed if new <= OLD else flown_presses <= pressed
    assert sum(one.rate_hold for one in made) % 2 == sum(one.rate_hold for one in inputs) % 2


@settings(max_examples=40)
@given(flights, st.sampled_from(PERIODS))
def test_sticks_stand_where_they_last_stood(inputs: list[Input], new: float) -> None:
    period, step = Fraction(str(OLD)), Fraction(str(new))
    for one in at(inputs, new):
        begun = [given for given in inputs if (given.tick - 1) * period < one.tick * step]
        assert (one.translation, one.drive) == (begun[-1].translation, begun[-1].drive)


@settings(max_examples=40)
@given(flights, st.sampled_from([p for p in PERIODS if p >= OLD]))
def test_a_switch_is_moved_in_the_step_in_which_the_person_moved_it(inputs: list[Input], new: float) -> None:
    made = at(inputs, new)
    for given_then in inputs:
        if given_then.stop:
            # the first new step that ends after the old one has begun
            tick = next(k for k in itertools.count(1) if k * new - 1e-9 > (given_then.tick - 1) * OLD)
            assert made[tick - 1].stop


@pytest.mark.parametrize(
    ("first", "second", "proceeds"),
    [("proceed", "stop", False), ("stop", "proceed", True)],
)
def test_stop_after_proceed_stops_though_both_come_in_one_step(first: str, second: str, proceeds: bool) -> None:
    presses = [Input(tick=1), Input(tick=2), msgspec.structs.replace(Input(tick=3), **{first: True})]
    (_, one) = at([*presses, msgspec.structs.replace(Input(tick=4), **{second: True})], 0.04)
    assert one.stop and one.proceed == proceeds


def test_a_targets_parts_stay_together() -> None:
    turn = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    by_joints = Input(tick=1, target=Target((1.0, 2.0, 3.0), turn, (0.0,) * 6))
    by_pose = Input(tick=2, target=Target((4.0, 5.0, 6.0), turn))
    (one,) = at([by_joints, by_pose], 0.04)
    assert one.target == by_pose.target


def test_a_script_flies_every_step_of_its_own() -> None:
    script = [Input(tick=tick, script=True) for tick in range(1, 11)]
    for new in PERIODS:
        assert all(one.script for one in at(script, new))
