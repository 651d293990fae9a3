"""Steering of the concept arm: every mode, its limits, and many arms at once."""

from __future__ import annotations

import numpy as np
import pytest

import aftdeck
from aftdeck.scenario.model import Scenario
from aftdeck.steering.batch import steer_batch
from tests.steering.flying import FOOT, fly, scenario

START = (20.0, 60.0, -100.0, 5.0, -30.0, 10.0)
GOAL = (-15.0, 50.0, -80.0, -10.0, -45.0, 60.0)
PAYLOAD = """
[payload]
mass = "15000 lb"
position = [0, 0, 1.5]
por = [0.3, 0, 0.2]
"""


def concept(extra: str = "") -> Scenario:
    return scenario(START, f'arm = "concept-1972"\n{extra}')


@pytest.mark.parametrize("law", ["1", "2", "3"])
def test_automatic_modes_reach_a_pose_within_every_limit(law: str) -> None:
    goal = [f"{angle} deg" for angle in GOAL]
    run = aftdeck.run(concept(f"[[phase]]\nmode = {law}\ntarget = {{ joints = {goal} }}\nduration = 120"))
    assert run.summary.ended == "completed"
    assert np.degrees(run.summary.joints_rad) == pytest.approx(GOAL, abs=0.05)
    assert run.summary.worst_rate_ratio <= 1.0


@pytest.mark.parametrize(("axis", "in_l"), [(0, [-1, 0, 0]), (1, [0, -1, 0]), (2, [0, 0, 1])])
def test_orb_unl_stick_moves_tip_along_orbiter_axis(axis: int, in_l: list[int]) -> None:
    stick = [0.0, 0.0, 0.0]
    stick[axis] = 0.3
    sim = aftdeck.Simulation(concept())
    frames = fly(sim, 4.0, aftdeck.Inputs(translation=(stick[0], stick[1], stick[2])))
    twist = sim.scenario.arm.jacobian(frames[-1].angles) @ np.array(frames[-1].rates_commanded)
    assert twist[3:] == pytest.approx(0.3 * 2 * FOOT * np.array(in_l), abs=1e-4)
    assert twist[:3] == pytest.approx(np.zeros(3), abs=1e-4)


def test_end_eff_sticks_act_along_the_axes_of_system_2() -> None:
    sim = aftdeck.Simulation(concept('mode = "END EFF"'))
    last = fly(sim, 4.0, aftdeck.Inputs(translation=(0.2, 0.0, 0.0), rotation=(0.0, 0.0, 0.3)))[-1]
    hand = sim.scenario.arm.forward(last.angles).rotation
    twist = sim.scenario.arm.jacobian(last.angles) @ np.array(last.rates_commanded)
    assert hand.T @ twist[3:] == pytest.approx([0.4 * FOOT, 0, 0], abs=2e-4)
    assert hand.T @ twist[:3] == pytest.approx([0, 0, np.radians(1.5)], abs=2e-4)


@pytest.mark.parametrize("mode", ["PL", "ORB LD"])
def test_payload_modes_rotate_about_point_of_resolution(mode: str) -> None:
    sim = aftdeck.Simulation(concept(f'mode = "{mode}"{PAYLOAD}'))
    arm, payload = sim.scenario.arm, sim.scenario.payload
    assert payload is not None
    start = payload.resolution(arm.forward(np.radians(START)))
    frames = fly(sim, 5.0, aftdeck.Inputs(rotation=(0.3, 0.2, 0.0)))
    assert payload.resolution(arm.forward(frames[-1].angles)) == pytest.approx(start, abs=1e-3)
    assert np.linalg.norm(frames[-1].rates_commanded) > 0.01


def test_held_stick_stops_before_a_stop_or_singularity() -> None:
    sim = aftdeck.Simulation(concept())
    frames = fly(sim, 40.0, aftdeck.Inputs(translation=(-1.0, 0.0, -0.5)))
    low, high = sim.scenario.arm.limits.soft.T
    angles = np.array([frame.angles for frame in frames])
    assert ((angles >= low - 1e-9) & (angles <= high + 1e-9)).all()
    assert np.abs(frames[-1].rates_commanded).max() < 1e-3
    assert {"soft stop", "singularity"} & {limit.kind for limit in frames[-1].limits}


def test_batch_of_concept_arms_reaches_its_targets() -> None:
    arm = aftdeck.load_arm("concept-1972").at(stand=16 * FOOT)
    rng = np.random.default_rng(60)
    start = np.radians(START) + rng.uniform(-0.2, 0.2, (70, 6))
    goal = start + rng.uniform(-0.1, 0.1, (70, 6))
    done = steer_batch(arm, start, arm.forward(goal), steps=1000, period=0.02, gain=0.5)
    assert done.angles == pytest.approx(goal, abs=1e-3)
    alone = steer_batch(arm, start[7], arm.forward(goal[7]), steps=1000, period=0.02, gain=0.5)
    assert (alone.angles == done.angles[7]).all()
