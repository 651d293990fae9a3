"""Poses and Jacobian of a chain against the closed forms, products of exponentials, and differences."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import expm

import aftdeck
from aftdeck.arms.chain import AXIS, SLIDES
from aftdeck.arrays import Array
from aftdeck.tuples import MOST_JOINTS
from tests.kinematics.chain.chains import Chain, chain_of, posture, random_chain, random_coordinates
from tests.kinematics.poses import legal, turned


def by_exponentials(chain: Chain, q: Array) -> Array:
    """Return the tip's pose (4, 4) by products of matrix exponentials."""

    def matrix(row: Array) -> Array:
        return np.block([[row[3:12].reshape(3, 3), row[:3, None]], [np.zeros(3), 1.0]])

    found = np.eye(4)
    for row, value in zip(chain.joints, q, strict=True):
        x, y, z = row[AXIS : AXIS + 3]
        motion = np.zeros((4, 4))
        if row[SLIDES]:
            motion[:3, 3] = x, y, z
        else:
            motion[:3, :3] = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]
        found = found @ matrix(row) @ expm(value * motion)
    return np.asarray(found @ matrix(chain.hand))


def test_poses_and_jacobian_are_those_of_the_closed_forms(any_arm: aftdeck.Arm) -> None:
    chain, poses = chain_of(any_arm), legal(any_arm, 21, 4000)
    closed, jacobian = any_arm.forward(poses), any_arm.jacobian(poses)
    found = [posture(chain, q) for q in poses]
    tips = np.array([one.tip for one in found])
    assert np.abs(tips[:, :3] - closed.position).max() < 2e-14
    assert np.abs(tips[:, 3:].reshape(-1, 3, 3) - closed.rotation).max() < 2e-15
    assert np.abs(np.array([one.jacobian for one in found]) - jacobian).max() < 2e-14


@pytest.mark.parametrize("count", range(1, MOST_JOINTS + 1))
def test_tip_is_that_of_products_of_exponentials(count: int) -> None:
    rng = np.random.default_rng(count)
    for slides in range(count + 1):
        chain = random_chain(rng, count, slides)
        q = random_coordinates(rng, chain)
        tip, witness = posture(chain, q).tip, by_exponentials(chain, q)
        assert tip[:3] == pytest.approx(witness[:3, 3], abs=1e-13)
        assert tip[3:].reshape(3, 3) == pytest.approx(witness[:3, :3], abs=1e-13)


@pytest.mark.parametrize("count", range(1, MOST_JOINTS + 1))
def test_jacobian_is_that_of_differences(count: int) -> None:
    rng, h = np.random.default_rng(100 + count), 1e-6
    for slides in range(count + 1):
        chain = random_chain(rng, count, slides)
        q = random_coordinates(rng, chain)
        matrix = posture(chain, q).jacobian
        for k in range(count):
            change = h * (np.arange(count) == k)
            after, before = posture(chain, q + change).tip, posture(chain, q - change).tip
            angular = turned(after[3:].reshape(3, 3), before[3:].reshape(3, 3))
            assert matrix[:, k] == pytest.approx(np.concatenate([angular, after[:3] - before[:3]]) / (2 * h), abs=1e-8)
