"""MASTER: each joint follows the master arm's joint within its limits, without overshoot."""

from __future__ import annotations

import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.parts.carried import steering_setup
from aftdeck.steering.layout import (
    AIMS,
    ARRIVED,
    CAUSE,
    COMMAND,
    DT,
    HIGH,
    LAW,
    LIMITING_JOINT,
    LOW,
    MASTER,
    MASTER_LAW,
    MEASURED,
    RATE,
    RATE_UP,
    RATES,
    REPORT,
    STATE,
)
from aftdeck.steering.limiters import BY_STOP
from aftdeck.steering.msteer import msteer
from tests.each import each, seeds
from tests.steering.flying import BAY, FOOT, fly, heavy_por, kinds, scenario

ROUNDING = 1e-12
"""Rounding of an angle [rad]."""
ARMS = pytest.mark.parametrize("name", ["srms", "concept-1972"])
CONCEPT = (20.0, 60.0, -100.0, 5.0, -30.0, 10.0)


def master_scenario(name: str, extra: str = "") -> Scenario:
    return scenario(BAY if name == "srms" else CONCEPT, f'arm = "{name}"\nmode = "MASTER"\n{extra}')


class Follower:
    """Arm that follows the rates of MASTER exactly."""

    def __init__(self, made: Scenario, angles: Array, rate: str = "coarse") -> None:
        self.rules = steering_setup(made, made.payload).rules["MASTER", "coarse" if rate == "coarse" else "vernier", 10]
        self.command, self.state, self.report = np.zeros(COMMAND), np.zeros(STATE), np.zeros(REPORT)
        self.command[LAW] = MASTER_LAW
        self.state[:6] = self.state[AIMS : AIMS + 6] = angles

    def step(self, master: Array) -> tuple[Array, Array]:
        """Return the rates of a step and the angles after it; check the limits of every step."""
        self.command[MASTER : MASTER + 6] = master
        before = self.state[RATES : RATES + 6].copy()
        msteer(self.rules, self.command, self.state, self.report)
        rates = self.state[RATES : RATES + 6].copy()
        dt, most, up = self.rules[DT], self.rules[RATE : RATE + 6], self.rules[RATE_UP : RATE_UP + 6]
        assert (np.abs(rates) <= most).all()
        assert (np.abs(rates - before) <= up * dt * (1.0 + 1e-9) + ROUNDING).all()
        self.state[:6] += rates * dt
        self.state[AIMS : AIMS + 6] = self.state[:6]
        self.state[MEASURED : MEASURED + 6] = rates
        return rates, self.state[:6].copy()

    @property
    def stops(self) -> tuple[Array, Array]:
        return self.rules[LOW : LOW + 6], self.rules[HIGH : HIGH + 6]

    @property
    def longest(self) -> float:
        """Upper bound of the time of a motion between the stops [s]."""
        low, high = self.stops
        ways = (high - low) / self.rules[RATE : RATE + 6] + self.rules[RATE : RATE + 6] / self.rules[
            RATE_UP : RATE_UP + 6
        ]
        return float(ways.max()) + 10.0


@ARMS
@each("seed", seeds(8, 80))
def test_joints_reach_master_angles_without_overshoot(name: str, seed: int) -> None:
    rng = np.random.default_rng(seed)
    period = float(rng.choice([0.005, 0.02, 0.08, 0.2])) if seed else 0.02
    made = master_scenario(name, f"control_period = {period}\nduration = {1000 * period}")
    soft = made.arm.limits.soft
    start, master = rng.uniform(soft[:, 0], soft[:, 1], (2, 6))
    if seed % 3 == 0:
        master = start + rng.normal(0.0, 0.02, 6).clip(-0.05, 0.05)
        master = master.clip(soft[:, 0], soft[:, 1])
    arm = Follower(made, start, "vernier" if seed % 4 == 3 else "coarse")
    direction = np.sign(master - start)
    last = start
    for _ in range(int(arm.longest / period) + 1):
        _, angles = arm.step(master)
        assert (direction * (angles - last) >= -ROUNDING).all()  # no joint moves away from the master
        assert (direction * (angles - master) <= ROUNDING).all()  # no joint passes the master
        last = angles
        if arm.report[ARRIVED]:
            break
    assert last == pytest.approx(master, abs=1e-9)
    for _ in range(50):
        rates, angles = arm.step(master)
        assert angles == pytest.approx(master, abs=1e-9) and np.abs(rates).max() < 1e-9 / period
        assert arm.report[ARRIVED] == 1.0


@ARMS
@each("seed", seeds(6, 60))
def test_jumping_master_is_followed_within_every_limit(name: str, seed: int) -> None:
    rng = np.random.default_rng(100 + seed)
    made = master_scenario(name)
    soft = made.arm.limits.soft
    arm = Follower(made, rng.uniform(soft[:, 0], soft[:, 1]))
    master = arm.state[:6].copy()
    for _ in range(6000):
        if rng.random() < 0.01:
            master = rng.uniform(soft[:, 0] - 0.5, soft[:, 1] + 0.5)
        _, angles = arm.step(master)
        assert (angles >= soft[:, 0] - ROUNDING).all() and (angles <= soft[:, 1] + ROUNDING).all()


@pytest.mark.parametrize("joint", range(6))
@pytest.mark.parametrize("direction", [1, -1])
def test_master_beyond_a_stop_moves_the_joint_up_to_the_stop(joint: int, direction: int) -> None:
    made = master_scenario("concept-1972")
    soft = made.arm.limits.soft
    arm = Follower(made, soft.mean(axis=1))
    master = soft.mean(axis=1)
    master[joint] = soft[joint, 1 if direction > 0 else 0] + 0.3 * direction
    for _ in range(int(arm.longest / 0.02)):
        _, angles = arm.step(master)
    assert angles[joint] == pytest.approx(soft[joint, 1 if direction > 0 else 0], abs=1e-9)
    assert (int(arm.report[CAUSE]), int(arm.report[LIMITING_JOINT])) == (BY_STOP, joint)


def test_joints_past_their_stops_move_only_back() -> None:
    # the Shuttle's arm at its cradle: shoulder and elbow pitch outside their soft stops
    made = master_scenario("srms")
    arm = Follower(made, np.zeros(6))
    for master in (np.zeros(6), np.radians([0.0, -1.0, 1.0, 0.0, 0.0, 0.0])):
        for _ in range(100):
            rates, _ = arm.step(master)
            assert (rates == 0.0).all()
    back = np.radians([0.0, 20.0, -20.0, 0.0, 0.0, 0.0])
    for _ in range(int(arm.longest / 0.02)):
        _, angles = arm.step(back)
    assert angles == pytest.approx(back, abs=1e-9)


@ARMS
def test_arm_rests_until_the_master_moves(name: str) -> None:
    sim = aftdeck.Simulation(master_scenario(name))
    frames = fly(sim, 2.0, aftdeck.Inputs())
    assert (np.array([frame.angles for frame in frames]) == sim.scenario.initial_angles).all()
    assert frames[-1].mode == "MASTER" and frames[-1].law == 10


def test_arm_returns_to_its_angles_at_entry_of_master() -> None:
    sim = aftdeck.Simulation(scenario())
    before = fly(sim, 4.0, aftdeck.Inputs(translation=(0.0, 0.0, -0.5)))[-1]
    frames = fly(sim, 20.0, aftdeck.Inputs(mode="MASTER"))
    assert frames[-1].angles == pytest.approx(before.angles, abs=1e-9)
    assert np.abs(frames[-1].rates).max() < 1e-9


def test_master_holds_a_fast_joint_at_its_soft_stop() -> None:
    sim = aftdeck.Simulation(scenario((0.0, 140.0, -80.0, 10.0, 0.0, 0.0)))
    fly(sim, 1.9, aftdeck.Inputs(mode="SINGLE", joint=1, drive=1.0))
    frames = fly(sim, 5.0, aftdeck.Inputs(mode="MASTER"))
    assert max(frame.angles[1] for frame in frames) <= sim.scenario.arm.limits.soft[1, 1] + ROUNDING


def test_master_is_followed_more_slowly_with_a_payload() -> None:
    made = scenario(BAY, 'mode = "MASTER"\n[payload]\nmass = "32000 lb"')
    empty = scenario(BAY, 'mode = "MASTER"')
    plain, loaded = (steering_setup(s, s.payload).rules["MASTER", "coarse", 10] for s in (empty, made))
    assert loaded[RATE : RATE + 6] == pytest.approx(plain[RATE : RATE + 6] * heavy_por().translation[0] / (2.0 * FOOT))
    assert kinds(aftdeck.Simulation(made).step(aftdeck.Inputs())) == set()
