"""Steering with the general solver: it commands what it commands with a closed form, and keeps the same rules."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from aftdeck.arms.chain import packed_chain
from aftdeck.arms.geometry import GENERAL
from aftdeck.arms.load import ArmModel
from aftdeck.arms.rank import Joint
from aftdeck.arrays import Array
from aftdeck.kinematics.arm import Arm
from aftdeck.kinematics.freeing import joint_out
from aftdeck.kinematics.jacobian import Twist, of_array
from aftdeck.kinematics.solver import closing, distance, posture, rates_of, tip_at, tip_of, twist_of
from aftdeck.steering.batch import steer_batch
from aftdeck.steering.layout import (
    ANGLES,
    COMMAND,
    DRIVE,
    JOINT,
    KEPT,
    LAW,
    MASTER,
    MEASURED,
    RATES,
    REPORT,
    STATE,
    STICKS,
    TARGET,
    TWIST,
)
from aftdeck.steering.mode import MODES
from aftdeck.steering.msteer import msteer
from aftdeck.steering.rules import Rate, rules_of
from tests import loaded
from tests.kinematics.poses import legal

FAR = 0.3
"""Distance from the singularities of the closed forms, from which no solver slows the arm [1]."""
CHAINS = ("five", "seven")


def as_chain(model: ArmModel) -> ArmModel:
    """Return an arm with a closed form as a chain that has none."""
    linkage = model.linkage
    joints = tuple(
        Joint(step, axis, False, 1.0, (low, high))
        for step, axis, (low, high) in zip(linkage.steps, linkage.axes, model.limits.hard.tolist(), strict=True)
    )
    links = np.concatenate([[0.0] * 7, [GENERAL], packed_chain(joints, linkage.tip, 1.0)])
    return replace(model, linkage=linkage._replace(links=links, singularities=("rank",)))


def clear(arm: Arm, count: int) -> Array:
    """Return angles inside the soft stops, far from every singularity."""
    low, high = arm.limits.soft.T
    q = np.clip(legal(arm, 5, 10 * count), low + 0.2, high - 0.2)
    return np.asarray(q[np.abs(np.array(arm.singularities(q))).min(axis=0) > FAR][:count])


@pytest.mark.parametrize("name", ["srms", "concept-1972"])
@pytest.mark.parametrize("law", [0, 2, 4, 5, 8, 9, 10])
def test_chain_of_an_arm_with_a_closed_form_is_steered_in_the_same_way(name: str, law: int) -> None:
    arm = loaded.arm(name)
    chained = Arm(as_chain(arm.model))
    mode = next(one.position for one in MODES.values() if law in one.laws)
    rng, poses = np.random.default_rng(law), clear(arm, 80)
    assert len(poses) > 40
    for q in poses:
        rate: Rate = "coarse" if rng.random() < 0.5 else "vernier"
        rates = rng.uniform(-0.3, 0.3, 6) * arm.rates.coarse
        command, states = np.zeros(COMMAND), []
        command[LAW], command[STICKS : STICKS + 6] = law, rng.uniform(-1.0, 1.0, 6)
        command[JOINT], command[DRIVE] = rng.integers(6), rng.uniform(-1.0, 1.0)
        command[KEPT : KEPT + 6] = q
        command[MASTER : MASTER + 6] = q + rng.uniform(-0.1, 0.1, 6)
        goal = arm.forward(q + rng.uniform(-0.05, 0.05, 6))
        command[TARGET : TARGET + 12] = [*goal.position, *goal.rotation.ravel()]
        for one in (arm, chained):
            rules = rules_of(one.model, arm.model.por_limits(0.0), 0.08)[mode, rate, law]
            state, report = np.zeros(STATE), np.zeros(REPORT)
            state[ANGLES : ANGLES + 6] = q
            state[RATES : RATES + 6] = state[MEASURED : MEASURED + 6] = rates
            state[TWIST : TWIST + 6] = twist_of(rules, posture(rules, of_array(q)), of_array(rates))
            msteer(rules, command.copy(), state, report)
            states.append(np.concatenate([state, report]))
        assert states[1] == pytest.approx(states[0], abs=1e-9)


@pytest.mark.parametrize("name", CHAINS)
def test_twists_and_rates_of_a_chain_are_inverse(name: str) -> None:
    arm, rng = loaded.chain(name), np.random.default_rng(2)
    links, count = arm.model.links, len(arm.joints)
    low, high = arm.limits.reach.T
    for q in rng.uniform(low, high, (200, count)):
        at = posture(links, of_array(q))
        assert np.array(tip_of(links, at)) == pytest.approx(np.array(tip_at(links, of_array(q))))
        rates = rng.uniform(-0.1, 0.1, count)
        twist = twist_of(links, at, of_array(rates))
        assert np.array(twist) == pytest.approx(arm.jacobian(q) @ rates)
        found = rates_of(links, at, twist, 1e-7)
        assert np.array(twist_of(links, at, found)) == pytest.approx(np.array(twist), abs=1e-9)
        assert np.linalg.norm(found) <= np.linalg.norm(rates) * (1.0 + 1e-9), "no rates of the same twist are smaller"


@pytest.mark.parametrize("name", CHAINS)
def test_a_chain_closes_on_its_singularity_as_fast_as_the_distance_falls(name: str) -> None:
    arm, rng, step = loaded.chain(name), np.random.default_rng(3), 1e-6
    links, count = arm.model.links, len(arm.joints)
    tried = 0
    low, high = arm.limits.reach.T
    for q in rng.uniform(low, high, (200, count)):
        values = np.linalg.svd(weighted(arm, q), compute_uv=False)
        if min(values[:-1] - values[1:]) < 1e-3:  # singular values that are equal have no derivative
            continue
        rates = rng.uniform(-1.0, 1.0, count)
        here, towards = closing(links, posture(links, of_array(q)), of_array(rates), 0)
        ahead, behind = (distance(links, posture(links, of_array(q + sign * step * rates)), 0) for sign in (1.0, -1.0))
        if here < 1.0:
            assert -towards == pytest.approx((ahead - behind) / (2.0 * step), abs=1e-5)
            tried += 1
    assert tried > 50


def weighted(arm: Arm, q: Array) -> Array:
    """Return the Jacobian with turning and moving alike."""
    linkage = arm.model.linkage
    whole = np.linalg.norm(linkage.steps[1:], axis=1).sum() + np.linalg.norm(linkage.tip)
    return np.array([1.0] * 3 + [3.0 / whole] * 3)[:, None] * arm.jacobian(q)


@pytest.mark.parametrize("name", CHAINS)
def test_the_joint_that_frees_a_chain_takes_it_away_from_its_singularity(name: str) -> None:
    arm, rng = loaded.chain(name), np.random.default_rng(4)
    links, near = arm.model.links, 0
    low, high = arm.limits.reach.T
    for q in rng.uniform(low, high, (2000, len(arm.joints))):
        (here,) = np.array(arm.singularities(q))
        if here > 0.05:
            continue
        joint, sign = joint_out(links, q, arm.limits.reach, 0, 0.05)
        q[joint] += 0.01 * sign
        assert np.array(arm.singularities(q))[0] > here
        near += 1
    assert near > 20


def test_five_joints_follow_the_translation_first() -> None:
    arm, rng = loaded.chain("five"), np.random.default_rng(5)
    links, tried = arm.model.links, 0
    low, high = arm.limits.reach.T
    for q in rng.uniform(low, high, (400, 5)):
        at, sizes = posture(links, of_array(q)), np.linalg.svd(weighted(arm, q)[3:], compute_uv=False)
        if distance(links, at, 0) < FAR or sizes[-1] < 0.3:
            continue
        twist = np.concatenate([rng.uniform(-0.3, 0.3, 3), rng.uniform(-0.3, 0.3, 3)])
        made = np.array(twist_of(links, at, rates_of(links, at, Twist(*twist), 1e-7)))
        turning, moving = np.linalg.norm((made - twist).reshape(2, 3), axis=1)
        assert moving < 0.03 * turning
        tried += 1
    assert tried > 50


@pytest.mark.parametrize("name", ["srms", "concept-1972"])
def test_batch_of_chains_is_that_of_the_closed_form(name: str) -> None:
    arm, rng = loaded.arm(name), np.random.default_rng(6)
    poses = clear(arm, 60)
    goal = arm.forward(poses + rng.uniform(-0.05, 0.05, poses.shape))
    closed, chained = (
        steer_batch(one, poses, goal, steps=20, period=0.08, gain=1.0) for one in (arm, Arm(as_chain(arm.model)))
    )
    for found, expected in zip(chained, closed, strict=True):
        assert found == pytest.approx(expected, abs=1e-9)


def test_batch_of_an_arm_with_seven_joints_reaches_its_targets() -> None:
    arm, rng = loaded.chain("seven"), np.random.default_rng(7)
    low, high = arm.limits.reach.T
    poses = rng.uniform(0.4 * low, 0.4 * high, (300, 7))
    poses = poses[np.array(arm.singularities(poses))[0] > FAR]
    goal = arm.forward(poses + rng.uniform(-0.05, 0.05, poses.shape))
    found = steer_batch(arm, poses, goal, steps=600, period=0.08, gain=1.0)
    assert len(poses) > 50 and np.abs(found.position_error).max() < 1e-6 and np.abs(found.rotation_error).max() < 1e-6
