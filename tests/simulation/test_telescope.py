"""Steering of the concept arm while its telescope moves."""

from __future__ import annotations

from itertools import pairwise

import msgspec
import numpy as np
import pytest

import aftdeck
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from tests.steering.flying import FOOT, scenario, target

START = (20.0, 60.0, -100.0, 5.0, -30.0, 10.0)
GOAL = (-15.0, 50.0, -80.0, -10.0, -45.0, 60.0)


def concept(extra: str = "") -> Scenario:
    return scenario(START, f'arm = "concept-1972"\n{extra}')


def flown(sim: aftdeck.Simulation, seconds: float, inputs: aftdeck.Inputs) -> list[Frame]:
    return [sim.step(inputs) for _ in range(round(seconds / sim.scenario.control_period))]


def telescope_inputs(stand: float) -> aftdeck.Inputs:
    """Return inputs with centred sticks and a command for the telescope: -1 shortens it, +1 extends it."""
    return aftdeck.Inputs(telescope=stand)


def test_tip_position_includes_telescope_length() -> None:
    sim = aftdeck.Simulation(concept())
    for frame in flown(sim, 3.0, aftdeck.Inputs(translation=(0.2, 0.1, 0.0), telescope=1.0)):
        tip = sim.scenario.arm.at(stand=(12.0 + frame.time_s) * FOOT).forward(frame.angles)
        assert frame.position == pytest.approx(tip.position, abs=1e-12)


def test_twist_includes_telescope_motion() -> None:
    sim = aftdeck.Simulation(concept())
    frames = flown(sim, 2.4, aftdeck.Inputs(translation=(0.2, 0.1, 0.3), telescope=-1.0))
    for before, frame in pairwise(frames[100:]):
        moved = (np.array(frame.position) - before.position) / 0.02
        assert frame.twist[3:] == pytest.approx(moved, abs=2e-3)
    assert frames[-1].twist_commanded[5] == pytest.approx(0.3 * 2.0 * FOOT, abs=1e-3)
    assert frames[-1].twist[5] == pytest.approx(frames[-1].twist_commanded[5] + FOOT, abs=2e-3)  # axis 3 is down


@pytest.mark.parametrize("law", ["position", "closed loop", "open loop"])
@pytest.mark.parametrize("stand", [-1.0, 1.0])
def test_automatic_motion_reaches_pose_after_telescope_motion(law: str, stand: float) -> None:
    sim = aftdeck.Simulation(concept(f'mode = "OPR CMD"\nlaw = "{law}"'))
    goal = target(sim.scenario.arm, GOAL)  # for a telescope of 12 ft
    flown(sim, 1.5, telescope_inputs(stand))
    frame = sim.step(aftdeck.Inputs(target=goal, proceed=True))
    while frame.sequence in {"checking", "in progress"}:
        frame = sim.step(aftdeck.Inputs())
        assert frame.time_s < 120.0
    assert frame.goal is not None and frame.goal.distance < 0.02 and frame.goal.angle < 0.004
    assert np.abs(np.degrees(frame.angles) - GOAL).max() > 1.0  # because the telescope has another length


def test_closed_loop_reaches_pose_during_telescope_motion() -> None:
    sim = aftdeck.Simulation(concept('mode = "OPR CMD"'))
    goal = target(sim.scenario.arm, GOAL)
    sim.step(aftdeck.Inputs(target=goal, proceed=True))
    flown(sim, 5.0, telescope_inputs(0.5))
    frame = flown(sim, 40.0, aftdeck.Inputs())[-1]
    assert frame.sequence == "idle"
    assert frame.goal is not None and frame.goal.distance < 1e-3


def test_position_hold_keeps_tip_during_telescope_motion() -> None:
    sim = aftdeck.Simulation(concept("position_hold = true"))
    start = flown(sim, 0.1, aftdeck.Inputs())[-1]
    frames = flown(sim, 4.0, telescope_inputs(0.3))
    frames += flown(sim, 8.0, aftdeck.Inputs())
    assert max(np.linalg.norm(np.array(frame.position) - start.position) for frame in frames) < 0.2
    assert frames[-1].position == pytest.approx(start.position, abs=2e-3)


def test_target_angles_for_another_length_lead_to_the_pose() -> None:
    goal = [f"{angle} deg" for angle in GOAL]
    point = f"[[sequence]]\nslot = 1\n[[sequence.point]]\ntarget = {{ joints = {goal} }}"
    sim = aftdeck.Simulation(concept(f'mode = "AUTO 1"\nlaw = "position"\n{point}'))
    flown(sim, 1.0, telescope_inputs(1.0))
    frame = sim.step(aftdeck.Inputs(proceed=True))
    while frame.sequence in {"checking", "in progress"}:
        frame = sim.step(aftdeck.Inputs())
    there = sim.scenario.arm.forward(np.radians(GOAL)).position
    assert frame.position == pytest.approx(there, abs=1e-3)


def test_restored_telescope_continues_bit_for_bit() -> None:
    made = concept()
    sim = aftdeck.Simulation(made)
    push = aftdeck.Inputs(translation=(0.4, -0.2, 0.1), rotation=(0.0, 0.3, 0.0), telescope=1.0)
    flown(sim, 1.0, push)
    saved = sim.save()
    on = flown(sim, 1.0, push)
    other = aftdeck.Simulation(made)
    flown(other, 0.5, telescope_inputs(-1.0))
    other.restore(saved)
    again = flown(other, 1.0, push)
    assert msgspec.msgpack.encode(on) == msgspec.msgpack.encode(again)
    sim.restore(msgspec.msgpack.decode(msgspec.msgpack.encode(saved), type=type(saved)))
    assert msgspec.msgpack.encode(flown(sim, 1.0, push)) == msgspec.msgpack.encode(on)
