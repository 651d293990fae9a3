"""Contacts during a run: the two-frame rule, and an inhibited arm that deepens no contact."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import aftdeck
from aftdeck import Inputs
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.target import Target
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.operator.sequence import begin
from tests.simulation.concept import AT_PORT, ON_BAR, held_for, log_of, scenario, vec3
from tests.simulation.flights import flown, harmful, in_turn, random_inputs, same_possession, srms

DEPTH = 1e-9
"""Decrease of a clearance that counts as no change [m]."""
ASIDE = 0.05
"""Allowed decrease of a clearance for each metre of motion, in a step that leads out of several contacts [1]."""
LEVER = 10.0
"""Greatest distance of a contact point from the tip [m]."""
PRONG = "prong"
seeds = st.integers(0, 2**32 - 1)


def over_the_bar(rng: np.random.Generator) -> Scenario:
    """Start with the concept's open end effector around the bar; it penetrates the bar or is just clear of it."""
    off = rng.uniform(-1.0, 1.0, 3) * [0.6, 0.5, 0.3]
    return scenario(vec3(ON_BAR + off), vec3(rng.uniform(-3.0, 3.0, 3)))


def held_in_the_bay(rng: np.random.Generator) -> Scenario:
    """Start with the concept's payload held, at a wall or at the floor of the bay."""
    off = rng.choice([-1.0, 1.0], 3) * [0.0, 1.0, 0.75] + rng.uniform(-0.1, 0.1, 3)
    return scenario(vec3(ON_BAR + off), held=True)


def held_at_the_port(rng: np.random.Generator) -> Scenario:
    """Start with the concept's payload held and rotated, with its rim at the assembly element."""
    return scenario(vec3(AT_PORT + rng.uniform(-0.5, 0.5, 3)), vec3(rng.uniform(-12.0, 12.0, 3)), held=True)


def near_the_bar(rng: np.random.Generator) -> Scenario:
    """Start with the concept's open end effector above the bar, without a contact."""
    off = rng.uniform(-1.0, 1.0, 3) * [0.6, 0.08, 0.2] - [0.0, 0.0, 0.4]
    return scenario(vec3(ON_BAR + off))


def near_the_fixture(rng: np.random.Generator) -> Scenario:
    """Start with the Shuttle's end effector near the fixture, without a contact."""
    above, x, y = rng.uniform(1.0, 4.0), *rng.uniform(-20.0, 20.0, 2)
    return srms(float(above), float(x), float(y), vec3(rng.uniform(-10.0, 10.0, 3)))


def shuttle(rng: np.random.Generator) -> Scenario:
    """Start with the Shuttle's end effector at the payload's fixture in the bay."""
    above, x, y = rng.uniform(-8.0, 4.0), *rng.uniform(-20.0, 20.0, 2)
    return srms(float(above), float(x), float(y), vec3(rng.uniform(-10.0, 10.0, 3)))


def shuttle_loaded(rng: np.random.Generator) -> Scenario:
    """Start with the Shuttle's payload held, near its stowed position in the bay."""
    x, y, above = rng.uniform(-3.0, 3.0, 3)
    return srms(float(above), float(x), float(y), vec3(rng.uniform(-2.0, 2.0, 3)), held=True)


STARTS = [over_the_bar, held_in_the_bay, held_at_the_port, shuttle, shuttle_loaded]


def check_inhibited_steps(made: Scenario, frames: list[Frame]) -> int:
    """Check that no inhibited step makes or deepens a contact of the arm; return the number of inhibited steps.

    A prong that is not inhibited yet may still close and make contacts.
    """
    inhibited = 0
    for before, now in in_turn(frames):
        if not before.work.arm_inhibit:
            continue
        inhibited += 1
        was, is_now = harmful(made, before), harmful(made, now)
        closes = not before.work.finger_inhibit and before.work.hand.opening != now.work.hand.opening
        turn = np.subtract(now.orientation, before.orientation)
        travel = np.linalg.norm(np.subtract(now.position, before.position)) + LEVER * np.linalg.norm(turn)
        allowed = ASIDE * float(travel)
        for pair, contact in is_now.items():
            if PRONG in pair and closes:
                continue
            if pair in was:
                assert contact.clearance >= was[pair].clearance - DEPTH - allowed, (now.time_s, pair)
            else:  # not a new contact: before the step it was essential, or not a contact of the arm
                earlier = {(c.a, c.b): c.clearance for c in before.work.contacts}
                assert not same_possession(before, now) or contact.clearance >= earlier[pair] - DEPTH, (
                    now.time_s,
                    pair,
                )
    return inhibited


def check_finger(made: Scenario, frames: list[Frame]) -> int:
    """Check that no step under FINGER INHIBIT deepens the prong's contacts; return the number of these steps."""
    inhibited = [pair for pair in in_turn(frames) if pair[0].work.finger_inhibit]
    for before, now in inhibited:
        was = harmful(made, before)
        for pair, contact in harmful(made, now).items():
            assert before.position != now.position or contact.clearance >= was[pair].clearance - DEPTH
    return len(inhibited)


def check_two_frames(made: Scenario, frames: list[Frame]) -> None:
    """Check that exactly the contacts found in two successive frames inhibit the arm and the finger."""
    for before, now in in_turn(frames):
        if not same_possession(before, now):
            continue
        touched = {(c.a, c.b) for c in before.work.contacts}
        twice = {pair for pair in harmful(made, now) if pair in touched}
        finger = {pair for pair in twice if PRONG in pair}
        expected = (bool(twice), bool(finger) if now.work.task == 1 else bool(twice))
        assert (now.work.arm_inhibit, now.work.finger_inhibit) == expected, now.time_s
        text = " ".join(event.text for event in now.events if event.kind == "inhibit")
        assert ("ARM INHIBIT:" in text) == (now.work.arm_inhibit and not before.work.arm_inhibit)
        assert ("ARM INHIBIT off" in text) == (before.work.arm_inhibit and not now.work.arm_inhibit)


@pytest.mark.slow
@pytest.mark.parametrize("start", STARTS, ids=lambda start: start.__name__)
@settings(max_examples=3)
@given(seed=seeds)
def test_inhibited_arm_deepens_no_contact_under_random_inputs(start: object, seed: int) -> None:
    assert callable(start)
    rng = np.random.default_rng(seed)
    made = start(rng)
    frames = flown(made, random_inputs(rng, 200, without=("effector",) if rng.random() < 0.5 else ()))
    check_inhibited_steps(made, frames)
    check_two_frames(made, frames)


# --- cases with known results -----------------------------------------------------------------------------

DOWN, UP = Inputs((0.0, 0.0, 0.3)), Inputs((0.0, 0.0, -0.3))
ABOVE_BAR = (28.0, 0.0, 0.6)
"""Start position of the palm, 0.14 ft above the bar [ft]."""


def test_palm_contact_stops_the_arm_from_the_second_step() -> None:
    made = scenario(ABOVE_BAR)
    frames = flown(made, held_for(200, DOWN))
    first = next(k for k, frame in enumerate(frames) if harmful(made, frame))
    assert list(harmful(made, frames[first])) == [("palm", "payload receptacle")]
    assert [frame.work.arm_inhibit for frame in frames[first - 1 : first + 3]] == [False, False, True, True]
    assert not any(frame.work.finger_inhibit for frame in frames)
    assert frames[first].position != frames[first + 1].position
    assert {frame.position for frame in frames[first + 2 :]} == {frames[first + 1].position}
    assert not any(frames[-1].rates)
    up = flown(made, [*held_for(200, DOWN), *held_for(60, UP)])[200:]
    assert up[-1].position[2] < frames[first - 1].position[2] and not up[-1].work.contacts
    assert log_of(up)[-2:] == ["palm clear of payload receptacle", "ARM INHIBIT off"]


def test_prong_contact_inhibits_finger_and_arm_but_prong_may_open() -> None:
    """The end effector leans over the starboard edge of the payload, so the prong closes on the side of the payload."""
    made = scenario((28.0, -2.7, 0.95), (-20.0, 0.0, 0.0))
    sim = aftdeck.Simulation(made)
    frames = flown(sim, [Inputs(effector="close"), *[Inputs()] * 200])
    own = {pair for frame in frames for pair in harmful(made, frame)}
    assert own == {("prong", "payload")}
    check_two_frames(made, frames)
    assert check_finger(made, frames) > 20
    assert frames[-1].work.finger_inhibit and frames[-1].work.arm_inhibit
    assert frames[-1].work.hand.opening >= 0.0
    assert frames[-1].work.hand.opening == frames[-20].work.hand.opening > 0.1
    frames = flown(sim, [Inputs(effector="open"), *[Inputs()] * 100])
    check_two_frames(made, frames)
    assert frames[-1].work.hand.opening > 0.9


def advised(frame: Frame) -> Inputs:
    """Return inputs in the escape direction from the contacts of a frame, at a tenth of full deflection."""
    (escape,) = frame.ways_out
    assert escape.cause == "contact"
    value, mode = 0.1 * escape.sign, escape.position or None
    if escape.stick == "telescope":
        return Inputs(telescope=value)
    if escape.stick == "joint":
        return Inputs(mode=mode, joint=escape.axis, drive=value)
    three = vec3(np.eye(3)[escape.axis] * value)
    return Inputs(three, mode=mode) if escape.stick == "translation" else Inputs(rotation=three, mode=mode)


def freed(sim: aftdeck.Simulation, frame: Frame) -> bool:
    """Return whether the inputs of `advised`, repeated for up to a minute, end the inhibit."""
    for _ in range(3000):
        if not frame.work.arm_inhibit:
            return True
        if not frame.ways_out:
            return False
        frame = sim.step(advised(frame))
    return False


CLEAR_STARTS = [near_the_bar, near_the_fixture]


@pytest.mark.parametrize("start", CLEAR_STARTS, ids=lambda start: start.__name__)
@settings(max_examples=4)
@given(seed=seeds, mode=st.sampled_from(["ORB UNL", "END EFF", "SINGLE"]))
def test_escape_leads_out_of_any_contact(start: object, seed: int, mode: str) -> None:
    assert callable(start)
    rng = np.random.default_rng(seed)
    sim = aftdeck.Simulation(start(rng))
    frame = flown(sim, [Inputs(mode=mode), Inputs()])[-1]
    assume(not frame.work.contacts)  # the run must not start in contact
    for inputs in random_inputs(rng, 200, without=("latch", "mode"), every=40):
        if frame.work.arm_inhibit:
            break
        frame = sim.step(inputs)
    assert freed(sim, frame)


def test_motion_into_contact_fails_its_check_and_is_abandoned() -> None:
    goal = 'frame = "L", position = ["28 ft", "0 ft", "2 ft"], matrix = [[0, 0, -1], [0, 1, 0], [1, 0, 0]]'
    for law in ("position", "closed loop", "open loop"):
        phases = f'[[phase]]\nname = "down"\nmode = "OPR CMD"\nlaw = "{law}"\ntarget = {{ {goal} }}'
        sim = aftdeck.Simulation(scenario(ABOVE_BAR, cargo=f'name = "payload"\n{phases}'))
        frames = [sim.step()]
        while not sim.ended:
            frames.append(sim.step())
        check = frames[-1].check
        assert sim.ended == "fault" and check is not None and check.cause == "contact"
        assert frames[-1].angles == frames[0].angles and frames[-1].goal is not None
        target = sim.scenario.phases[0].target
        assert isinstance(target, Target)
        begin(sim._state, target)
        later = [sim.step(Inputs()) for _ in range(1500)]
        blocked = next(frame for frame in later if "blocked" in {event.kind for event in frame.events})
        touched = next(frame for frame in later if frame.work.arm_inhibit)
        assert touched.time_s - frames[-1].time_s == pytest.approx(check.seconds, abs=0.1)
        assert blocked.time_s > touched.time_s and min(frame.ratio for frame in later) == 0.0


def test_capture_does_not_log_separation_of_touching_parts() -> None:
    """A pair that is no longer monitored is not logged as separated, and the end of an inhibit is logged."""
    made = scenario(ON_BAR)
    frames = flown(made, [Inputs(effector="close"), *[Inputs()] * 200, *held_for(50, UP)])
    assert frames[-1].work.cargo[0].held
    check_two_frames(made, frames)
    lines = log_of(frames)
    assert not [line for line in lines if "clear of payload receptacle" in line]
    docked = flown(scenario(AT_PORT, held=True), [Inputs()] * 5)
    assert not [line for line in log_of(docked) if "clear of" in line]
