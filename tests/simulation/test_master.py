"""Master arm moved by the sticks: each axis moves one joint, at its rate limit and within the stops."""

from __future__ import annotations

import numpy as np
import pytest

import aftdeck
from aftdeck import Inputs
from aftdeck.arrays import Array
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.operator.master import AXES, axes_of, turn_master
from aftdeck.steering.layout import COMMAND, HIGH, LOW, MASTER, RATE, RULES, STICKS
from tests.steering.flying import BAY, scenario

START = {"srms": BAY, "concept-1972": (20.0, 60.0, -100.0, 5.0, -30.0, 10.0)}
ARMS = pytest.mark.parametrize("name", START)


def master_scenario(name: str) -> Scenario:
    return scenario(START[name], f'arm = "{name}"\nmode = "MASTER"')


def pushed(axis: int | None, by: float) -> Inputs:
    """Return inputs with one deflected axis of the sticks."""
    assert axis is not None, "an axis moves each joint of these arms"
    sticks = [0.0] * 6
    sticks[axis] = by
    roll, pitch, yaw, x, y, z = sticks
    return Inputs(translation=(x, y, z), rotation=(roll, pitch, yaw))


@ARMS
def test_each_axis_moves_one_master_joint_and_rhc_the_wrist(name: str) -> None:
    made = master_scenario(name)
    axes = axes_of(made.arm.model)
    assert set(axes) == set(range(len(AXES))) and len(axes) == len(made.arm.joints)
    for joint, axis in zip(made.arm.joints[3:], axes[3:], strict=True):
        assert axis is not None and AXES[axis] == "RHC " + joint.removeprefix("wrist_").replace("heading", "yaw")


@ARMS
@pytest.mark.parametrize("joint", range(6))
@pytest.mark.parametrize("rate", ["coarse", "vernier"])
def test_stick_moves_master_joint_at_its_rate_limit(name: str, joint: int, rate: str) -> None:
    made = master_scenario(name)
    axis, rates = axes_of(made.arm.model)[joint], made.arm.model.rates
    most = float((rates.coarse if rate == "coarse" else rates.vernier)[joint])
    sim = aftdeck.Simulation(made)
    begun: Array = np.array(sim.step(Inputs(rate="coarse" if rate == "coarse" else "vernier")).angles)
    for by, steps in ((0.5, 50), (-1.0, 10)):
        for _ in range(steps):
            frame = sim.step(pushed(axis, by))
    for _ in range(500):
        frame = sim.step(Inputs())
    assert frame.work.master is not None
    turned = np.zeros(6)
    turned[joint] = most * (0.5 * 50 - 10) * made.control_period
    assert np.array(frame.work.master) - begun == pytest.approx(turned, abs=1e-12)
    assert frame.angles == pytest.approx(frame.work.master, abs=1e-9)


@pytest.mark.slow
@ARMS
@pytest.mark.parametrize("by", [1.0, -1.0])
def test_sticks_move_master_only_to_soft_stops(name: str, by: float) -> None:
    made = master_scenario(name)
    low, high = made.arm.model.limits.soft.T
    for joint, axis in enumerate(axes_of(made.arm.model)):
        sim, end = aftdeck.Simulation(made), (high if by > 0.0 else low)[joint]
        way = abs(end - np.radians(START[name])[joint]) / made.arm.model.rates.coarse[joint]
        for _ in range(int(way / made.control_period) + 10):
            sim.advance(pushed(axis, by))
        frame = sim.look()
        assert frame.work.master is not None
        assert frame.work.master[joint] == pytest.approx(end, abs=1e-12)


def test_master_beyond_a_stop_can_only_move_back() -> None:
    sim = aftdeck.Simulation(master_scenario("srms"))
    beyond = (np.radians(200.0), *np.radians(BAY)[1:].tolist())
    sim.step(Inputs(master=beyond))
    assert sim.step(pushed(4, 1.0)).work.master == pytest.approx(beyond)
    back = sim.step(pushed(4, -1.0)).work.master
    assert back is not None and back[0] < beyond[0]


def test_sticks_do_not_move_master_in_other_modes() -> None:
    sim = aftdeck.Simulation(scenario(BAY, 'mode = "ORB UNL"'))
    for _ in range(100):
        sim.advance(pushed(4, 1.0))
    angles = sim.look().angles
    for _ in range(200):
        angles = sim.step(Inputs()).angles
    assert sim.step(Inputs(mode="MASTER")).work.master == pytest.approx(angles)


@pytest.mark.parametrize("joint", [0, 2])
def test_sticks_move_only_the_joints_that_an_axis_moves(joint: int) -> None:
    axes = tuple(k if k == joint else None for k in range(5))
    rules, command, period = np.zeros(RULES), np.zeros(COMMAND), 0.5
    rules[RATE : RATE + 5], rules[LOW : LOW + 5], rules[HIGH : HIGH + 5] = 0.1, -2.0, 2.0
    command[STICKS : STICKS + 6], command[MASTER : MASTER + 5] = 1.0, [0.5, 0.6, 0.7, 0.8, 0.9]
    expected = command[MASTER : MASTER + 5].copy()
    expected[joint] += 0.1 * period
    turn_master(axes, rules, command, period)
    assert command[MASTER : MASTER + 5].tolist() == expected.tolist()
