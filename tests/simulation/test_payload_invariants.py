"""Each payload exists exactly once and never jumps: while it is held, fixed or free, and in every transition."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import aftdeck
from aftdeck import Inputs
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from tests.simulation.concept import AT_PORT, ON_BAR, held_for, scenario, vec3
from tests.simulation.flights import events_of, flown, random_inputs, srms
from tests.simulation.payload_invariants import EXACT, check_possession, in_frame_7, in_space, moved, posed
from tests.steering.flying import fly

seeds = st.integers(0, 2**32 - 1)
FREE_FLYER = 'name = "free flyer"'
TWO = 'name = "payload"\n[[cargo]]\nname = "free flyer"\nstart = { position = ["40 ft", "30 ft", "20 ft"] }'


@settings(max_examples=4)
@given(seeds)
def test_concept_payload_keeps_invariants_under_random_inputs(seed: int) -> None:
    rng = np.random.default_rng(seed)
    made = scenario(vec3(ON_BAR + rng.uniform(-0.2, 0.2, 3) * [1.0, 0.3, 0.1]), cargo=TWO)
    sim = aftdeck.Simulation(made)
    frames = flown(sim, [Inputs(effector="close"), *[Inputs()] * 190, *random_inputs(rng, 250)])
    check_possession(made, frames)


@settings(max_examples=4)
@given(seeds)
def test_concept_payload_keeps_invariants_at_the_port(seed: int) -> None:
    rng = np.random.default_rng(seed)
    made = scenario(vec3(AT_PORT + rng.uniform(-0.1, 0.1, 3)), vec3(rng.uniform(-1.0, 1.0, 3)), held=True)
    frames = flown(made, random_inputs(rng, 300, 0.3, switches=0.25))
    check_possession(made, frames)


@settings(max_examples=4)
@given(seeds)
def test_shuttle_payload_keeps_invariants_under_random_inputs(seed: int) -> None:
    rng = np.random.default_rng(seed)
    x, y = rng.uniform(-1.5, 1.5, 2)
    made = srms(float(rng.uniform(0.5, 3.5)), float(x), float(y), vec3(rng.uniform(-4.0, 4.0, 3)))
    sim = aftdeck.Simulation(made)
    mode = "auto" if rng.random() < 0.5 else "manual"
    capture = [Inputs(effector="close", effector_mode=mode, mode="END EFF"), *[Inputs()] * 140]  # type: ignore[arg-type]
    rest = [Inputs(latch="unlatch"), *random_inputs(rng, 250, 0.1, switches=0.25, without=("effector_mode",))]
    frames = flown(sim, [*capture, *rest])
    assert any(frame.work.cargo[0].held for frame in frames)
    check_possession(made, frames)


SLOWLY = "control_period = 0.08"
LIFT = Inputs((0.0, 0.0, -1.0), mode="ORB UNL")


def captured(share: float) -> tuple[Scenario, aftdeck.Simulation, list[Frame]]:
    """Capture the Shuttle's latched payload from 3 inches above its fixture, rotated by up to 6 deg; return the run."""
    made = srms(3.0, 1.0, 2.0, (5.0 * share, -4.0 * share, 6.0 * share), head=SLOWLY)
    sim = aftdeck.Simulation(made)
    frames = fly(sim, 2.64, Inputs(effector="close", effector_mode="manual", mode="END EFF"))
    assert frames[-1].work.cargo[0].held and frames[-1].work.cargo[0].seat == "bay"
    return made, sim, frames


def stowed() -> tuple[np.ndarray, np.ndarray]:
    """Return a rigidized payload's pose in frame 7, with the accuracy of the scenario's joint angles."""
    frame = aftdeck.Simulation(srms(0.0, held=True)).step(Inputs())
    return in_frame_7(frame, frame.work.cargo[0])


@pytest.mark.parametrize("retracted", [0.0, 0.3, 0.95, 1.0])
def test_unlatched_payload_does_not_jump_while_carriage_draws_in(retracted: float) -> None:
    """A fixed payload does not move with the carriage; after UNLATCH, it moves only by the rest of the travel."""
    made, sim, frames = captured(0.1)
    if retracted:
        frames += fly(sim, retracted * 7.0, Inputs(rigid="rigid"))
    frames += fly(sim, 30.4, Inputs(rigid="off", latch="unlatch"))
    assert not frames[-1].work.cargo[0].seat
    frames += fly(sim, 24.0, LIFT)
    off = in_frame_7(frames[-1], frames[-1].work.cargo[0])
    frames += fly(sim, 12.0, Inputs(rigid="rigid"))
    check_possession(made, frames)
    assert "RIGID" in frames[-1].work.hand.flags
    shift, _ = moved(off, in_frame_7(frames[-1], frames[-1].work.cargo[0]))
    whole, _ = moved(off, stowed())
    assert shift == pytest.approx((1.0 - retracted) * whole, abs=0.02 * whole)


def test_carriage_stops_before_a_wall_and_continues_when_clear() -> None:
    made, sim, frames = captured(1.0)
    frames += fly(sim, 30.4, Inputs(latch="unlatch"))
    frames += fly(sim, 12.0, Inputs(rigid="rigid"))
    (text,) = (event.text for frame in frames for event in frame.events if event.kind == "waits")
    assert "carriage" in text and "payload" in text
    stopped = frames[-1].work.hand.carriage
    assert stopped is not None and stopped < 0.9
    assert not [c for frame in frames for c in frame.work.contacts if {c.a, c.b} == {"payload", "bay"}]
    frames += fly(sim, 30.0, LIFT)
    assert (frames[-1].work.hand.carriage or 0.0) > stopped
    check_possession(made, frames)


def test_latches_draw_a_held_payload_in() -> None:
    made = srms(0.5, 0.5, -0.3, (0.1, 0.1, -0.1), held=True, head=SLOWLY)
    sim = aftdeck.Simulation(made)
    frames = fly(sim, 30.4, Inputs(latch="latch")) + fly(sim, 30.4, Inputs(latch="unlatch"))
    assert {("latched", "info"), ("unlatched", "info")} <= set(events_of(frames))
    assert moved(posed(frames[0].work.cargo[0]), posed(frames[-1].work.cargo[0]))[0] > 0.01
    check_possession(made, frames + fly(sim, 2.0, Inputs((0.0, 0.0, -1.0), mode="ORB LD")))


# --- released payloads keep their motion ----------------------------------------------------------------------


def test_released_payload_keeps_velocity_and_angular_velocity() -> None:
    made = scenario((28.0, 10.0, -28.0), held=True)
    sim = aftdeck.Simulation(made)
    push = Inputs((0.2, 0.1, -0.1), (0.05, 0.1, 0.1), orbiter=(1.0, -1.0, 0.0))
    frames = flown(sim, held_for(150, push))
    frames += flown(sim, [Inputs(push.translation, push.rotation, orbiter=push.orbiter, effector="open")] * 250)
    free = [frame for frame in frames if not frame.work.cargo[0].held]
    assert len(free) > 50 and len(free) < 250
    check_possession(made, frames)
    velocities = np.diff([in_space(frame, frame.work.cargo[0])[0] for frame in free], axis=0) / 0.02
    assert np.ptp(velocities, axis=0) == pytest.approx(np.zeros(3), abs=1e-9)
    # the payload keeps its motion in space from the last step before the release
    last = frames[len(frames) - len(free) - 1], free[0]
    before = np.subtract(*(in_space(frame, frame.work.cargo[0])[0] for frame in last[::-1])) / 0.02
    assert np.linalg.norm(before) > 0.05
    assert velocities[0] == pytest.approx(before, abs=2e-4)  # the displacement is only a chord of the path
    turns = [np.array(a.work.cargo[0].orientation).T @ b.work.cargo[0].orientation for a, b in pairwise(free)]
    assert np.ptp(turns, axis=0) == pytest.approx(np.zeros((3, 3)), abs=1e-9)
    held = np.array(last[0].work.cargo[0].orientation).T @ last[1].work.cargo[0].orientation
    assert turns[0] == pytest.approx(held, abs=1e-6)


@pytest.mark.slow
def test_released_free_flyer_stays_in_its_deadband() -> None:
    made = scenario(ON_BAR, held=True, cargo=FREE_FLYER + '\nstart = { position = ["28 ft", "0 ft", "-5.82 ft"] }')
    sim = aftdeck.Simulation(made)
    frames = flown(sim, held_for(100, Inputs((0.0, 0.0, -1.0), (0.1, 0.0, 0.0))))
    frames += flown(sim, [Inputs(effector="open")] * 3000)
    check_possession(made, frames)
    free = [np.array(frame.work.cargo[0].orientation) for frame in frames if not frame.work.cargo[0].held]
    angles = np.degrees([np.arccos(np.clip((np.trace(free[0].T @ axes) - 1.0) / 2.0, -1.0, 1.0)) for axes in free])
    assert angles.max() < 3.0**0.5 + 0.1
    assert angles.max() > 0.5  # 0.02 deg/s about each axis for a minute
    steps = np.degrees(np.abs(np.diff(free, axis=0)).max())
    assert steps < 0.02 * 0.02 * 3.0


def test_undocked_payload_rests_while_the_orbiter_accelerates() -> None:
    made = scenario(vec3(np.add(AT_PORT, [0.05, 0.0, 0.0])), held=True)
    sim = aftdeck.Simulation(made)
    frames = flown(sim, [Inputs(), Inputs(effector="open"), *[Inputs()] * 200])
    assert frames[-1].work.cargo[0].seat == "port" and not frames[-1].work.cargo[0].held
    back = Inputs(orbiter=(-1.0, 0.0, 0.0))
    undock = Inputs(orbiter=back.orbiter, latch="unlatch")
    frames += flown(sim, [*held_for(38, back), undock, back, undock, *held_for(150, back)])
    check_possession(made, frames)
    assert not frames[-1].work.cargo[0].seat
    here, there = (in_space(frame, frame.work.cargo[0]) for frame in (frames[100], frames[-1]))
    assert moved(here, there) == pytest.approx((0.0, 0.0), abs=EXACT)
