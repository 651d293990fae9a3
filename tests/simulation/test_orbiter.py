"""Translation of the orbiter: floating payloads, contacts, and docked payloads."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import aftdeck
from aftdeck import Inputs
from aftdeck.simulation.frame import Frame
from tests.simulation.concept import AT_PORT, FOOT, held_for, scenario, vec3
from tests.simulation.flights import events_of, flown, harmful
from tests.simulation.payload_invariants import check_possession, in_space

seeds = st.integers(0, 2**32 - 1)
SPEED, REACHED = 0.2 * FOOT, 2.0
"""Speed of the orbiter [m/s], and the time in which it is reached [s]."""
FORWARD, AFT = Inputs(orbiter=(1.0, 0.0, 0.0)), Inputs(orbiter=(-1.0, 0.0, 0.0))
PERIOD = 0.02
UNDER_THE_HAND = 'name = "payload"\nstart = { position = ["28 ft", "0 ft", "12.6 ft"] }'


def check_speed(frames: list[Frame]) -> None:
    """Check, except where the orbiter stops, that position is the integral of speed and acceleration is limited."""
    for before, now in pairwise(frames):
        v, w = np.array(before.work.orbiter_velocity), np.array(now.work.orbiter_velocity)
        assert np.abs(w).max() <= SPEED * (1.0 + 1e-12)
        moved = np.subtract(now.work.orbiter, before.work.orbiter)
        if w.any() or not v.any():
            assert np.abs(w - v).max() <= SPEED / REACHED * PERIOD * (1.0 + 1e-9)
            assert moved == pytest.approx(0.5 * (v + w) * PERIOD, abs=1e-4 * SPEED)


@settings(max_examples=4)
@given(seeds)
def test_orbiter_carries_fixed_payloads_but_not_floating_ones(seed: int) -> None:
    rng = np.random.default_rng(seed)
    cargo = 'name = "payload"\n[[cargo]]\nname = "free flyer"\nstart = { position = ["40 ft", "30 ft", "20 ft"] }'
    made = scenario(cargo=cargo)
    pushes = [Inputs(orbiter=vec3(rng.choice([-1.0, 0.0, 1.0], 3))) for _ in range(6)]
    frames = flown(made, [push for push in pushes for _ in range(50)])
    check_possession(made, frames)
    check_speed(frames)
    places = np.array([in_space(frame, frame.work.cargo[1])[0] for frame in frames])
    assert np.ptp(places, axis=0) == pytest.approx(np.zeros(3), abs=1e-9)
    for before, now in pairwise(frames):
        velocity = np.subtract(now.work.orbiter, before.work.orbiter) / PERIOD
        assert now.work.cargo[1].velocity == pytest.approx(-velocity, abs=1e-9)
        assert now.work.cargo[0].velocity == (0.0, 0.0, 0.0)


def test_contact_stops_the_orbiter_which_may_back_away() -> None:
    """A payload rests in space under the open end effector; the orbiter moves the end effector down to it."""
    made = scenario((28.0, 0.0, -20.0), cargo=UNDER_THE_HAND)
    sim = aftdeck.Simulation(made)
    frames = flown(sim, held_for(700, Inputs(orbiter=(0.0, 0.0, 1.0))))
    touched = [k for k, frame in enumerate(frames) if harmful(made, frame)]
    check_possession(made, frames)
    check_speed(frames)
    first = touched[0]
    assert [frame.work.arm_inhibit for frame in frames[first : first + 2]] == [False, True]
    assert not any(frames[first + 2].work.orbiter_velocity)
    depths = [min(c.clearance for c in harmful(made, frame).values()) for frame in frames[first + 1 :]]
    assert min(depths) >= depths[0] - 1e-9 and depths[0] > -2.5 * SPEED * PERIOD
    (text,) = (event.text for frame in frames for event in frame.events if event.kind == "refused")
    assert "payload" in text
    away = flown(sim, held_for(120, Inputs(orbiter=(0.0, 0.0, -1.0))))
    assert not away[-1].work.arm_inhibit and not away[-1].work.contacts
    assert ("inhibit", "info") in events_of(away)


@settings(max_examples=3)
@given(seeds)
def test_orbiter_deepens_no_contact_of_held_payload(seed: int) -> None:
    rng = np.random.default_rng(seed)
    off, turned = (
        np.add([0.2, 0.0, 0.0], rng.uniform(-0.3, 0.3, 3)),
        vec3(rng.choice([-1.0, 1.0], 3) * [4.0, 13.0, 13.0]),
    )
    made = scenario(vec3(AT_PORT + off), turned, held=True)
    frames = flown(made, [inputs for d in rng.choice([-1.0, 1.0], (6, 3)) for inputs in [Inputs(orbiter=vec3(d))] * 60])
    for before, now in pairwise(frames):
        was, is_now = harmful(made, before), harmful(made, now)
        if before.work.arm_inhibit:
            for pair in is_now:
                assert pair in was and is_now[pair].clearance >= was[pair].clearance - 1e-9


def test_docking_stops_the_orbiter_until_release() -> None:
    """A payload that is docked and held connects arm and port: from the next step on all velocities are zero."""
    made = scenario(vec3(np.add(AT_PORT, [0.8, 0.0, 0.0])), held=True)
    sim = aftdeck.Simulation(made)
    frames = flown(sim, held_for(400, FORWARD))
    docked = next(k for k, frame in enumerate(frames) if frame.work.cargo[0].seat == "port")
    assert 10 < docked < 399
    check_possession(made, frames)
    assert np.linalg.norm(frames[docked].work.orbiter_velocity) > 0.5 * SPEED
    # in this step the arm still held the payload at rest
    assert frames[docked].work.cargo[0].velocity == (0.0, 0.0, 0.0)
    for frame in frames[docked + 1 :]:
        assert frame.work.orbiter == frames[docked].work.orbiter
        assert not any(frame.work.orbiter_velocity) and not any(frame.rates)
        assert frame.work.nearest is None or frame.work.nearest.closing == 0.0
    assert events_of(frames[docked + 1 :]) == [("refused", "caution")]
    after = flown(sim, [Inputs(effector="open", orbiter=(-1.0, 0.0, 0.0)), *held_for(250, AFT)])
    released = next(k for k, frame in enumerate(after) if not frame.work.cargo[0].held)
    check_possession(made, after)
    check_speed(after[released:])
    assert np.linalg.norm(after[-1].work.orbiter_velocity) == pytest.approx(SPEED)


def test_docking_stops_a_coasting_orbiter_and_logs_the_reason() -> None:
    sim = aftdeck.Simulation(scenario(vec3(np.add(AT_PORT, [0.35, 0.0, 0.0])), held=True))
    frames = flown(sim, [*held_for(99, FORWARD), *[Inputs()] * 60])
    docked = next(k for k, frame in enumerate(frames) if frame.work.cargo[0].seat == "port")
    assert any(frames[docked].work.orbiter_velocity) and not any(frames[docked + 1].work.orbiter_velocity)
    assert events_of(frames[docked + 1 :]) == [("refused", "caution")]


def test_contact_with_resting_payload_inhibits_the_arm() -> None:
    """A contact does not accelerate the arm; the inhibited arm may only move away from the payload."""
    start = 'start = { position = ["28 ft", "0 ft", "12.4 ft"], velocity = ["0 ft/s", "0 ft/s", "0.2 ft/s"] }'
    made = scenario((28.0, 0.0, -20.0), cargo=f'name = "payload"\n{start}')
    sim = aftdeck.Simulation(made)
    frames = flown(sim, held_for(600, Inputs((0.0, 0.0, 1.0))))
    check_possession(made, frames)
    stopped = [k for k, frame in enumerate(frames) if frame.work.arm_inhibit]
    assert stopped
    for k in stopped[1:]:
        assert frames[k].position == frames[k - 1].position
    assert frames[stopped[0]].work.inhibits
