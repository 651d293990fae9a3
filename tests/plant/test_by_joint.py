"""Laws of the plants for any number of joints: each joint moves as it would alone."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.plant.kinematic import follow
from aftdeck.plant.multibody.joint_laws import (
    GIVE,
    HOLDING,
    JUMPS,
    SEIZES,
    SERVO,
    SLIPS,
    TORQUE,
    USUAL,
    command_joints,
    deflect_brakes,
    measure_joints,
)
from aftdeck.plant.state import new_plant_state
from tests.each import each, seeds
from tests.joints import NUMBERS, random_arrays

STEP, PERIOD = 0.002, 0.02
BOUNDS = np.array([1.8, 0.01, 0.3])
ROWS = 6
"""Rows of the joints' places."""


def alone(arrays: list[Array], joint: int) -> list[Array]:
    """Return copies of the arrays of one joint, which are the last axis."""
    return [array[..., joint : joint + 1].copy() for array in arrays]


@each("seed", seeds(40, 2000))
def test_joints_follow_their_commands_each_for_itself(seed: int) -> None:
    n = NUMBERS[seed % len(NUMBERS)]
    given, angles, rates, commanded = random_arrays(seed, n, 3.0, 1.2, 1.0, 1.0)
    stops = np.array([[-1.0, 1.0]] * n)
    one_by_one = [alone([given, angles, rates, commanded], k) for k in range(n)]
    follow(given, 0.5, stops, angles, rates, commanded)
    for k, own in enumerate(one_by_one):
        follow(own[0], 0.5, stops[k : k + 1], *own[1:])
        assert [array[k] for array in (given, angles, rates, commanded)] == [array[0] for array in own]


class Joints:
    """Random servos and brakes of n joints, with MuJoCo's arrays as if these were all of its joints."""

    def __init__(self, seed: int, n: int) -> None:
        rng = np.random.default_rng(seed)
        self.places = np.array([np.arange(n)] * ROWS)
        self.places[SERVO + 1] += n  # brakes are the actuators after the servos
        self.servo = rng.uniform(0.1, 1.0, (7, n)) * np.array([[0.1], [0.01], [1e-4], [1e-4], [1.0], [1.0], [1e-3]])
        self.servo[HOLDING] = self.servo[TORQUE] * 1.5
        self.gains, self.biases = np.zeros((2 * n, 10)), np.zeros((2 * n, 10))
        self.gains[:n, 0] = 10.0 ** rng.uniform(0.0, 3.0, n)
        self.biases[:n, 2] = -self.gains[:n, 0]
        scale = 10.0 ** rng.uniform(-3.0, 0.0)
        self.rates, self.angles, self.qpos, self.windup, self.qvel, self.acceleration, self.torques = random_arrays(
            seed, n, 0.1, 1.0, 1.0, 0.01, scale, 1.0, 1.0
        )
        self.rates[rng.random(n) < 0.3] = 0.0
        self.holds = np.where(rng.random(n) < 0.5, np.nan, self.angles + 0.01)
        self.ctrl, self.act, self.force = random_arrays(seed + 1, n, 1.0, 1e-4, 1.0)
        self.reference, self.commanded, self.overdriven = np.zeros(n), np.ones(n), np.zeros(n, np.uint8)

    def only(self, k: int) -> Joints:
        """Return the same values for one joint."""
        one = object.__new__(Joints)
        n = len(self.rates)
        for name, values in vars(self).items():
            if name in ("gains", "biases"):
                chosen = values[[k, n + k]]
            elif name == "places":
                chosen = np.array([[0]] * ROWS)
                chosen[SERVO + 1] = 1
            else:
                chosen = values[..., k : k + 1]
            setattr(one, name, chosen.copy())
        return one

    def command(self, *, braked: bool, by_angle: bool) -> int:
        return command_joints(
            self.rates, self.angles, braked, by_angle, self.places, self.servo, self.gains, self.biases, STEP, BOUNDS,
            self.qvel, self.acceleration, self.torques, self.holds, self.ctrl, self.act,
        )  # fmt: skip

    def measure(self, *, braked: bool, by_angle: bool, flexible: bool) -> None:
        n = len(self.rates)
        positions = np.concatenate([self.qpos, self.windup])
        force = np.concatenate([self.force, self.force])
        measure_joints(
            braked, by_angle, self.places, np.arange(n, 2 * n) if flexible else np.zeros(0, np.int64), self.servo,
            self.gains, self.biases, STEP, 2e5, positions, self.qvel, self.act, self.ctrl, force, self.angles,
            self.rates, self.holds, self.torques, self.overdriven, self.reference, PERIOD, np.zeros(n), self.commanded,
        )  # fmt: skip


def assert_joint_is(joints: Joints, k: int, one: Joints) -> None:
    for name, values in vars(joints).items():
        if name not in ("gains", "biases", "places"):
            assert np.array_equal(values[..., k : k + 1], vars(one)[name], equal_nan=True), name


@each("seed", seeds(80, 4000))
def test_servos_and_brakes_act_on_each_joint_for_itself(seed: int) -> None:
    """How fine the steps have to be depends on the joint that needs the finest ones."""
    n, braked, by_angle = NUMBERS[seed % len(NUMBERS)], bool(seed & 4), bool(seed & 8)
    joints = Joints(seed, n)
    ones = [joints.only(k) for k in range(n)]
    decided = joints.command(braked=braked, by_angle=by_angle)
    assert decided == max(one.command(braked=braked, by_angle=by_angle) for one in ones)
    assert decided in ((USUAL, SEIZES, SLIPS) if braked else (USUAL, JUMPS))
    for k, one in enumerate(ones):
        assert_joint_is(joints, k, one)


@each("seed", seeds(80, 4000))
def test_joints_are_measured_each_for_itself(seed: int) -> None:
    n, braked, by_angle, flexible = NUMBERS[seed % len(NUMBERS)], bool(seed & 4), bool(seed & 8), bool(seed & 16)
    joints = Joints(seed, n)
    ones = [joints.only(k) for k in range(n)]
    for one in (joints, *ones):
        one.measure(braked=braked, by_angle=by_angle, flexible=flexible)
    for k, one in enumerate(ones):
        assert_joint_is(joints, k, one)


@each("joints", NUMBERS)
def test_brakes_of_all_joints_deflect_up_to_where_they_slip(joints: int) -> None:
    made = Joints(0, joints)
    made.qvel[:] = 10.0 * made.servo[GIVE] / STEP
    deflect_brakes(made.places, made.servo, made.qvel, STEP, made.act)
    assert made.act.tolist() == made.servo[GIVE].tolist()


@each("joints", (*NUMBERS, 6))
def test_new_state_has_the_arms_number_of_joints(joints: int) -> None:
    state = new_plant_state(joints)
    assert [len(values) for values in (state.angles, state.rates, state.commanded, state.reference, state.holds)] == (
        [joints] * 5
    )
