"""Joint coordinates for a pose of the tip, by a search."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

import aftdeck
from aftdeck.arrays import Array
from aftdeck.kinematics.chain.search import Found, miss_of, search
from aftdeck.tuples import MOST_JOINTS
from tests.kinematics.chain.chains import Chain, chain_of, posture, random_chain, random_coordinates
from tests.kinematics.poses import legal

WIDE = np.array([[-4.0, 4.0]] * MOST_JOINTS)


def searched(
    chain: Chain, goal: Array, near: Array, limits: Array = WIDE, rotation: float = 1.0
) -> tuple[Array, Found]:
    q = near.copy()
    follow = np.array([rotation] * 3 + [1.0 / chain.scale] * 3)
    return q, search(chain.joints, chain.hand, goal, limits[: chain.number], chain.scale, follow, q)


def test_miss_is_the_rotation_vector_and_the_translation() -> None:
    rng, miss = np.random.default_rng(1), np.empty(6)
    for angle in (0.0, 1e-12, 1e-6, 0.1, 1.0, 3.0, math.pi - 1e-6):
        vector = angle * Rotation.random(random_state=rng).as_matrix()[0]
        tip, turn = Rotation.random(random_state=rng).as_matrix(), Rotation.from_rotvec(vector).as_matrix()
        miss_of(np.append([1.0, 2.0, 3.0], tip), np.append([4.0, 4.0, 4.0], turn @ tip), miss)
        assert miss[:3] == pytest.approx(vector, abs=1e-9)
        assert tuple(miss[3:]) == (3.0, 2.0, 1.0)


def test_miss_of_half_a_turn_is_half_a_turn() -> None:
    miss = np.empty(6)
    for axis in np.eye(3):
        turn = Rotation.from_rotvec(math.pi * axis).as_matrix()
        miss_of(np.append(np.zeros(3), np.eye(3)), np.append(np.zeros(3), turn), miss)
        assert np.linalg.norm(miss[:3]) == pytest.approx(math.pi, abs=1e-12)


def test_search_finds_the_angles_of_a_pose_of_the_arms(any_arm: aftdeck.Arm) -> None:
    rng, chain = np.random.default_rng(4), chain_of(any_arm)
    missed = 0
    for q in legal(any_arm, 24, 200):
        near = np.clip(q + rng.uniform(-0.3, 0.3, 6), *any_arm.limits.hard.T)
        found, end = searched(chain, posture(chain, q).tip, near, any_arm.limits.hard)
        assert ((any_arm.limits.hard[:, 0] <= found) & (found <= any_arm.limits.hard[:, 1])).all()
        missed += not (end.turn < 1e-11 and end.distance < 1e-10)
    assert missed <= 4  # a stop can be in the way of a search


@pytest.mark.parametrize("count", range(1, MOST_JOINTS + 1))
def test_search_finds_the_pose_of_a_random_chain(count: int) -> None:
    rng, missed = np.random.default_rng(count), 0
    for n in range(60):
        chain = random_chain(rng, count, n % min(count, 3))
        q = random_coordinates(rng, chain)
        _, end = searched(chain, posture(chain, q).tip, q + rng.uniform(-0.2, 0.2, count))
        missed += not (end.turn < 1e-10 and end.distance < 1e-9)
    assert missed <= 2


@pytest.mark.parametrize("count", [2, 4, 5, 6, 7])
def test_search_ends_at_the_least_miss_if_the_pose_is_out_of_reach(count: int) -> None:
    rng = np.random.default_rng(count)
    for _ in range(20):
        chain = random_chain(rng, count)
        near = random_coordinates(rng, chain)
        goal = posture(chain, near).tip
        goal[:3] *= 3.0 * chain.scale / np.linalg.norm(goal[:3])
        found, _ = searched(chain, goal, near, rotation=0.2)

        def weighted(q: Array, chain: Chain = chain, goal: Array = goal) -> Array:
            miss = np.empty(6)
            miss_of(posture(chain, q).tip, goal, miss)
            return np.asarray(miss * np.array([0.2] * 3 + [1.0 / chain.scale] * 3))

        witness = least_squares(weighted, found, bounds=(-4.0 - 1e-9, 4.0 + 1e-9), xtol=1e-12, ftol=1e-12, gtol=1e-12)
        assert np.linalg.norm(weighted(found)) <= np.linalg.norm(witness.fun) + 1e-4


def test_search_stays_within_limits_and_is_repeatable() -> None:
    rng = np.random.default_rng(9)
    chain = random_chain(rng, 7, 1)
    limits = np.array([[-0.5, 0.4]] * 7)
    goal = posture(chain, random_coordinates(rng, chain)).tip
    first, end = searched(chain, goal, np.full(7, 5.0), limits)
    again, same = searched(chain, goal, np.full(7, 5.0), limits)
    assert ((first >= -0.5) & (first <= 0.4)).all()
    assert (first == again).all() and end == same
