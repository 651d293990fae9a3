"""LATRAJ: distance, angle and axis, from 0 to 180 deg, against SciPy."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from aftdeck.arrays import Array
from aftdeck.kinematics.linkage import Tip
from aftdeck.steering.aim import Aim, latraj

RNG = np.random.default_rng(50)
AXES = [*np.eye(3), *-np.eye(3), *(v / np.linalg.norm(v) for v in RNG.normal(size=(30, 3)))]
AXES += [np.array([0.6, 0.8, 0.0]), np.array([0.0, -0.6, 0.8]), np.array([1.0, 1.0, 1.0]) / math.sqrt(3.0)]
STARTS = [np.eye(3), Rotation.from_euler("zyx", [0.3, -0.7, 2.0]).as_matrix()]


def aim(start: Array, goal: Array, displacement: Array | None = None) -> Aim:
    position = np.array([1.0, -2.0, 3.0])
    packed = np.concatenate([position + (np.zeros(3) if displacement is None else displacement), goal.ravel()])
    return latraj(Tip(*position, *start.ravel()), packed)


@pytest.mark.parametrize("start", STARTS, ids=["level", "turned"])
@pytest.mark.parametrize(
    "angle", [1e-12, 1e-9, 1e-6, 1e-3, 0.5, math.pi / 2, 2.0, 3.0, math.pi - 1e-3, math.pi - 1e-6, math.pi - 1e-9]
)
def test_latraj_returns_angle_and_axis_of_any_rotation(start: Array, angle: float) -> None:
    for axis in AXES:
        found = aim(start, Rotation.from_rotvec(angle * axis).as_matrix() @ start)
        # a matrix gives the angle within about 4e-16 rad, and the axis within 4e-16 rad divided by the angle
        assert found.angle == pytest.approx(angle, abs=2e-15)
        assert np.array([found.ax, found.ay, found.az]) == pytest.approx(axis, abs=1e-15 + 2e-15 / min(angle, 1.0))
        assert np.linalg.norm([found.ax, found.ay, found.az]) == pytest.approx(1.0, abs=1e-14)


@pytest.mark.parametrize("start", STARTS, ids=["level", "turned"])
def test_latraj_returns_axis_of_180_deg_up_to_its_sign(start: Array) -> None:
    for axis in AXES:
        found = aim(start, (2.0 * np.outer(axis, axis) - np.eye(3)) @ start)
        axis_found = np.array([found.ax, found.ay, found.az])
        assert found.angle == pytest.approx(math.pi, abs=2e-15)
        assert abs(axis_found @ axis) == pytest.approx(1.0, abs=1e-14)


def test_rotation_by_latraj_reaches_random_attitudes() -> None:
    for start, goal in zip(
        Rotation.random(500, rng=51).as_matrix(), Rotation.random(500, rng=52).as_matrix(), strict=True
    ):
        found = aim(start, goal)
        turn = Rotation.from_rotvec(found.angle * np.array([found.ax, found.ay, found.az])).as_matrix()
        assert turn @ start == pytest.approx(goal, abs=1e-12)
        assert found.angle == pytest.approx(Rotation.from_matrix(goal @ start.T).magnitude(), abs=1e-12)


def test_latraj_at_the_target_is_zero() -> None:
    found = aim(STARTS[0], STARTS[0])
    assert found == Aim(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


def test_line_of_sight_is_unit_vector_to_target() -> None:
    found = aim(STARTS[0], STARTS[0], np.array([0.3, -0.4, 1.2]))
    assert found.distance == pytest.approx(1.3)
    assert [found.ux, found.uy, found.uz] == pytest.approx([0.3 / 1.3, -0.4 / 1.3, 1.2 / 1.3])
