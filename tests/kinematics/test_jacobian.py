"""JACOBI and ERATES against finite differences of LNKAGE."""

from __future__ import annotations

import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.kinematics.observe import SEEN, observe
from tests.kinematics.poses import legal, turned


def by_differences(arm: aftdeck.Arm, q: Array, h: float = 1e-5) -> Array:
    """Return central differences (n, 6, 6); their error is about h^2 times the arm's length."""
    columns = []
    for k in range(6):
        change = np.zeros(6)
        change[k] = h
        after, before = arm.forward(q + change), arm.forward(q - change)
        angular = turned(after.rotation, before.rotation)
        columns.append(np.concatenate([angular, after.position - before.position], axis=1) / (2 * h))
    return np.stack(columns, axis=2)


def test_jacobian_agrees_with_differences_at_legal_poses_and_limits(any_arm: aftdeck.Arm) -> None:
    q = legal(any_arm, 3, 2000)
    assert np.abs(any_arm.jacobian(q) - by_differences(any_arm, q)).max() < 5e-9


def test_jacobian_agrees_with_differences_at_singular_poses(arm: aftdeck.Arm) -> None:
    q = np.array([[0.3, 0.5, -0.4, 0.2, np.pi / 2, 1.0], [0.0, 0.9, np.radians(-2.606), 0.1, 0.2, 0.3], np.zeros(6)])
    assert np.abs(arm.jacobian(q) - by_differences(arm, q)).max() < 5e-9


def test_jacobian_keeps_leading_dimensions(any_arm: aftdeck.Arm) -> None:
    q = legal(any_arm, 4, 6).reshape(2, 3, 6)
    many = any_arm.jacobian(q)
    assert many.shape == (2, 3, 6, 6)
    assert (many[1, 2] == any_arm.jacobian(q[1, 2])).all()


def test_observed_twist_is_the_jacobian_times_the_rates(any_arm: aftdeck.Arm) -> None:
    rng = np.random.default_rng(5)
    for q in legal(any_arm, 5, 200):
        rates, seen = rng.normal(size=6), np.empty(SEEN + 3)
        observe(any_arm.model.links, q, rates, seen)
        pose = any_arm.forward(q)
        assert seen[12:18] == pytest.approx(any_arm.jacobian(q) @ rates, abs=1e-12)
        assert (seen[:3] == pose.position).all() and (seen[3:12] == pose.rotation.ravel()).all()
        assert tuple(seen[18:]) == tuple(float(d) for d in any_arm.singularities(q))
