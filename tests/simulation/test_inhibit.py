"""Contacts in flight: the two-frame rule, and an inhibited arm that deepens nothing, whatever the operator does."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from tests.simulation.concept import AT_PORT, ON_BAR, scenario, vec3
from tests.simulation.flights import anything, flown, harmful, in_turn, same_possession, srms

DEPTH = 1e-9
"""By how much a clearance may fall and count as kept [m]."""
PRONG = "prong"
seeds = st.integers(0, 2**32 - 1)


def over_the_bar(rng: np.random.Generator) -> Scenario:
    """The concept's open hand about the bar, deep in it or just clear."""
    off = rng.uniform(-1.0, 1.0, 3) * [0.6, 0.5, 0.3]
    return scenario(vec3(ON_BAR + off), vec3(rng.uniform(-3.0, 3.0, 3)))


def held_in_the_bay(rng: np.random.Generator) -> Scenario:
    """The payload in the grasp, at a wall or on the floor of the bay."""
    off = rng.choice([-1.0, 1.0], 3) * [0.0, 1.0, 0.75] + rng.uniform(-0.1, 0.1, 3)
    return scenario(vec3(ON_BAR + off), held=True)


def held_at_the_port(rng: np.random.Generator) -> Scenario:
    """The payload in the grasp, turned, its rim at the assembly element."""
    return scenario(vec3(AT_PORT + rng.uniform(-0.5, 0.5, 3)), vec3(rng.uniform(-12.0, 12.0, 3)), held=True)


def shuttle(rng: np.random.Generator) -> Scenario:
    """The Shuttle's end effector about the payload's fixture in the bay."""
    above, x, y = rng.uniform(-8.0, 4.0), *rng.uniform(-20.0, 20.0, 2)
    return srms(float(above), float(x), float(y), vec3(rng.uniform(-10.0, 10.0, 3)))


def shuttle_loaded(rng: np.random.Generator) -> Scenario:
    """The Shuttle's payload in the grasp at its place in the bay."""
    x, y, above = rng.uniform(-3.0, 3.0, 3)
    return srms(float(above), float(x), float(y), vec3(rng.uniform(-2.0, 2.0, 3)), held=True)


PLACES = [over_the_bar, held_in_the_bay, held_at_the_port, shuttle, shuttle_loaded]


def drifts(frame: Frame) -> bool:
    """Whether a payload floats: what it does to the arm is not the arm's."""
    return any(not cargo.held and not cargo.seat for cargo in frame.work.cargo)


def check_kept(made: Scenario, frames: list[Frame]) -> int:
    """That no inhibited step deepened a contact of the arm or made one; how many steps were inhibited."""
    inhibited = 0
    for before, now in in_turn(frames):
        if not before.work.arm_inhibit or drifts(before):
            continue
        inhibited += 1
        was, is_now = harmful(made, before), harmful(made, now)
        for pair, contact in is_now.items():
            if pair in was:
                assert contact.clearance >= was[pair].clearance - DEPTH, (now.time_s, pair)
            else:  # it was there, and not the arm's: of something just taken, or made to touch till now
                there = {(c.a, c.b): c.clearance for c in before.work.contacts}
                assert not same_possession(before, now) or contact.clearance >= there[pair] - DEPTH, (now.time_s, pair)
    return inhibited


def check_two_frames(made: Scenario, frames: list[Frame]) -> None:
    """That the arm and the finger are inhibited by what was found in two frames in succession, and by nothing else."""
    for before, now in in_turn(frames):
        if not same_possession(before, now):
            continue
        touched = {(c.a, c.b) for c in before.work.contacts}
        twice = {pair for pair in harmful(made, now) if pair in touched}
        finger = {pair for pair in twice if PRONG in pair}
        expected = (bool(twice - finger), bool(finger)) if now.work.task == 1 else (bool(twice), bool(twice))
        assert (now.work.arm_inhibit, now.work.finger_inhibit) == expected, now.time_s
        told = " ".join(event.text for event in now.events if event.kind == "inhibit")
        assert ("ARM INHIBIT:" in told) == (now.work.arm_inhibit and not before.work.arm_inhibit)
        assert ("ARM INHIBIT off" in told) == (before.work.arm_inhibit and not now.work.arm_inhibit)


@pytest.mark.parametrize("place", PLACES, ids=lambda place: place.__name__)
@settings(max_examples=4)
@given(seed=seeds)
def test_an_inhibited_arm_deepens_no_contact_whatever_is_asked_of_it(place: object, seed: int) -> None:
    assert callable(place)
    rng = np.random.default_rng(seed)
    made = place(rng)
    frames = flown(made, anything(rng, 250))
    check_kept(made, frames)
    check_two_frames(made, frames)
