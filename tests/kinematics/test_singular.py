"""The three singularities: positions, signs of the distances, and agreement with the determinant of the Jacobian."""

from __future__ import annotations

import math

import numpy as np
import pytest

import aftdeck
from tests.kinematics.poses import STRAIGHT, legal, singular_poses

INCH = 0.0254


@pytest.mark.parametrize("kind", ["shoulder", "elbow", "wrist"])
def test_distance_is_zero_only_at_its_own_singularity(arm: aftdeck.Arm, kind: str) -> None:
    found = arm.singularities(singular_poses(arm)[kind])._asdict()
    assert abs(float(found.pop(kind))) < 1e-15
    assert min(abs(float(d)) for d in found.values()) > 0.1


def test_distances_lie_between_minus_one_and_one(arm: aftdeck.Arm) -> None:
    q = np.random.default_rng(30).uniform(-math.pi, math.pi, (50_000, 6))
    found = np.abs(np.stack(arm.singularities(q)))
    assert found.max() <= 1.0 + 1e-15
    assert (found.max(axis=1) > 0.9).all()


def test_product_of_distances_is_proportional_to_the_determinant(arm: aftdeck.Arm) -> None:
    upper, lower, wrist = math.hypot(251.05, 6.0) * INCH, math.hypot(277.95, 6.0) * INCH, 18 * INCH
    q = legal(arm, 31, 5000)
    product = np.prod(np.stack(arm.singularities(q)), axis=0) * upper * lower * (upper + lower + wrist)
    determinant = np.linalg.det(arm.jacobian(q))
    assert np.abs(determinant) == pytest.approx(np.abs(product), abs=1e-9)
    sign = np.sign(determinant * product)[np.abs(product) > 1e-6]
    assert abs(sign.sum()) == len(sign)


def test_distances_are_positive_in_the_usual_configuration(arm: aftdeck.Arm) -> None:
    usual = arm.singularities(np.radians([0, 60, -90, 30, 0, 0]))
    assert min(float(d) for d in usual) > 0.0
    assert float(arm.singularities([0, 1, STRAIGHT + 0.01, 0, 0, 0]).elbow) < 0.0
    assert float(arm.singularities(np.radians([0, 60, -90, 30, 100, 0])).wrist) < 0.0
    assert float(arm.singularities(np.radians([0, 140, -10, 0, 0, 0])).shoulder) < 0.0


def test_elbow_singularity_is_announced_at_the_cradle(arm: aftdeck.Arm) -> None:
    assert abs(float(arm.singularities(np.zeros(6)).elbow)) < arm.model.singular
