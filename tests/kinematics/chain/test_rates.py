"""Singular values, joint rates, motions of redundant joints, and singularities of a chain."""

from __future__ import annotations

import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.kinematics.chain.many import FLOOR
from aftdeck.kinematics.chain.rates import Weighted, freeing_joint, rank_left, resolve, swing, weigh
from aftdeck.tuples import MOST_JOINTS
from tests.kinematics.chain.chains import Chain, chain_of, posture, random_chain, random_coordinates
from tests.kinematics.poses import legal, over_the_shoulder, singular_poses

ALIKE = np.ones(6)
COUNTS = pytest.mark.parametrize("count", range(1, MOST_JOINTS + 1))


def weights_of(chain: Chain, rng: np.random.Generator) -> Array:
    return rng.uniform(0.2, 3.0, chain.number)


def rates_of(matrix: Array, twist: Array, weights: Array, follow: Array = ALIKE) -> Array:
    rates = np.empty(matrix.shape[1])
    resolve(weigh(matrix, weights, follow), min(matrix.shape), twist, FLOOR, rates)
    return rates


@COUNTS
def test_factors_are_orthonormal_and_make_the_matrix(count: int) -> None:
    rng = np.random.default_rng(count)
    for _ in range(50):
        matrix = rng.normal(size=(6, count)) * 10.0 ** rng.uniform(-6, 3, (6, 1))
        w = weigh(matrix, np.ones(count), ALIKE)
        size = np.abs(matrix).max()
        assert (w.left * w.values) @ w.right.T == pytest.approx(matrix, abs=1e-14 * size)
        for one in (w.left, w.right):
            assert one.T @ one == pytest.approx(np.eye(min(6, count)), abs=1e-13)
        assert w.values == pytest.approx(np.linalg.svd(matrix, compute_uv=False), abs=1e-14 * size)


def test_small_singular_values_have_all_their_digits() -> None:
    matrix = np.diag([1.0, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15]) @ (np.eye(6) + 0.1 * np.tri(6))
    exact = weigh(matrix, np.ones(6), ALIKE).values
    assert np.prod(exact / np.diag(matrix)) == pytest.approx(1.0, rel=1e-13)  # the determinant


@COUNTS
def test_factors_of_dependent_columns_are_finite(count: int) -> None:
    matrix = np.zeros((6, count))
    assert rates_of(matrix, ALIKE, np.ones(count)) == pytest.approx(np.zeros(count))
    matrix[:] = [[1.0], [0.0], [0.0], [2.0], [0.0], [0.0]]
    w = weigh(matrix, np.ones(count), ALIKE)
    assert w.values[0] == pytest.approx(np.sqrt(5.0 * count))
    assert w.values[1:] == pytest.approx(0.0, abs=1e-14)
    assert np.isfinite(rates_of(matrix, ALIKE, np.ones(count))).all()


def test_rates_are_those_of_the_closed_forms(any_arm: aftdeck.Arm) -> None:
    rng, chain = np.random.default_rng(2), chain_of(any_arm)
    poses, twists = legal(any_arm, 22, 2000), rng.normal(size=(2000, 6))
    closed, singular = any_arm.joint_rates(poses, twists, singular="mask")
    clear = np.abs(np.array(any_arm.singularities(poses))).min(axis=0)
    follow = np.array([1.0] * 3 + [1.0 / chain.scale] * 3)
    for q, twist, rates, distance in zip(poses, twists, closed, clear, strict=True):
        if distance > 1e-3:
            found = rates_of(posture(chain, q).jacobian, twist, np.ones(6), follow)
            assert np.abs(found - rates).max() <= 1e-13 / distance**2 * (1.0 + np.abs(rates).max())
    assert not singular.all()


@pytest.mark.parametrize("count", [6, 7, 8])
def test_rates_make_the_twist_with_the_least_weighted_size(count: int) -> None:
    rng = np.random.default_rng(count)
    for _ in range(50):
        chain = random_chain(rng, count, int(rng.integers(0, 3)))
        matrix, twist = posture(chain, random_coordinates(rng, chain)).jacobian, rng.normal(size=6)
        weights = weights_of(chain, rng)
        rates = rates_of(matrix, twist, weights)
        root = np.sqrt(weights)
        witness = root * (np.linalg.pinv(matrix * root) @ twist)
        assert matrix @ rates == pytest.approx(twist, abs=1e-10)
        assert rates == pytest.approx(witness, rel=1e-8, abs=1e-9 * np.abs(witness).max())


@pytest.mark.parametrize("count", [1, 2, 3, 4, 5])
def test_short_chain_follows_the_twist_as_well_as_its_weights_ask(count: int) -> None:
    rng = np.random.default_rng(count)
    for _ in range(50):
        chain = random_chain(rng, count, int(rng.integers(0, 2)))
        matrix, twist = posture(chain, random_coordinates(rng, chain)).jacobian, rng.normal(size=6)
        follow = rng.uniform(0.1, 2.0, 6)
        rates = rates_of(matrix, twist, weights_of(chain, rng), follow)  # weights of the joints do not matter
        witness = np.linalg.lstsq(follow[:, None] * matrix, follow * twist)[0]
        assert rates == pytest.approx(witness, rel=1e-8, abs=1e-9 * np.abs(witness).max())


def test_chain_of_five_follows_translation_first_if_its_weight_is_greater() -> None:
    rng, follow = np.random.default_rng(3), np.array([1e-4] * 3 + [1.0] * 3)
    for _ in range(50):
        chain = random_chain(rng, 5)
        matrix, twist = posture(chain, random_coordinates(rng, chain)).jacobian, rng.normal(size=6)
        left = matrix @ rates_of(matrix, twist, np.ones(5), follow) - twist
        assert np.linalg.norm(left[3:]) < 1e-5
        assert np.linalg.norm(left[:3]) > 1e-3


@pytest.mark.parametrize("count", [7, 8])
def test_swing_turns_the_joint_and_holds_the_tip(count: int) -> None:
    rng = np.random.default_rng(count)
    for _ in range(50):
        chain = random_chain(rng, count)
        matrix, weights = posture(chain, random_coordinates(rng, chain)).jacobian, weights_of(chain, rng)
        w, rates = weigh(matrix, weights, ALIKE), np.empty(count)
        for joint in range(count):
            if swing(w, 6, joint, rates):
                assert rates[joint] == pytest.approx(1.0)
                assert matrix @ rates == pytest.approx(np.zeros(6), abs=1e-10 * np.abs(rates).max())


def test_chain_of_six_has_no_swing() -> None:
    rng = np.random.default_rng(6)
    chain = random_chain(rng, 6)
    w = weigh(posture(chain, random_coordinates(rng, chain)).jacobian, np.ones(6), ALIKE)
    assert not swing(w, 6, 2, np.empty(6))


def weighed(chain: Chain, q: Array) -> Weighted:
    follow = np.array([1.0] * 3 + [1.0 / chain.scale] * 3)
    return weigh(posture(chain, q).jacobian, np.ones(chain.number), follow)


def test_arms_lose_rank_at_the_singularities_of_the_closed_forms(arm: aftdeck.Arm) -> None:
    chain = chain_of(arm)
    for q in singular_poses(arm).values():
        assert rank_left(weighed(chain, q), 6) < 1e-12
    for q in legal(arm, 23, 500):
        near = min(abs(float(one)) for one in arm.singularities(q))
        assert (rank_left(weighed(chain, q), 6) < 1e-9) == (near < 1e-8)


def slope(chain: Chain, q: Array, rank: int, k: int, h: float = 1e-6) -> float:
    change = h * (np.arange(chain.number) == k)
    after, before = (weighed(chain, q + sign * change).values[rank - 1] for sign in (1.0, -1.0))
    return float(after - before) / (2 * h)


@COUNTS
def test_freeing_joint_changes_the_last_singular_value_most(count: int) -> None:
    rng, rank = np.random.default_rng(count), min(6, count)
    for slides in range(min(count, 3)):
        chain = random_chain(rng, count, slides)
        q = random_coordinates(rng, chain)
        w, seen = weighed(chain, q), posture(chain, q)
        found = freeing_joint(chain.joints, seen.joints, seen.tip, w, rank)
        slopes = [abs(slope(chain, q, rank, k)) for k in range(count)]
        assert slopes[found] == pytest.approx(max(slopes), abs=1e-7)


def test_joints_that_free_the_shuttles_arm_are_those_of_its_singularities(arm: aftdeck.Arm) -> None:
    chain = chain_of(arm)
    for name, joints in (("elbow", {2}), ("wrist", {4}), ("shoulder", {1, 2, 3})):
        q = over_the_shoulder(arm) if name == "shoulder" else singular_poses(arm)[name]
        w, seen = weighed(chain, q), posture(chain, q)
        assert freeing_joint(chain.joints, seen.joints, seen.tip, w, 6) in joints
