"""LNKAGE: agreement with published poses, and rejected arguments."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import ArrayLike

import aftdeck
from aftdeck.errors import InputError
from aftdeck.frames import Pose, rotation_x
from aftdeck.kinematics.payload import HeldPayload
from tests.kinematics.poses import AXES, BODY, CENTRES, INCH, legal, structural
from tests.reference.tables import table

POSES = table("srms-poses")


@pytest.mark.parametrize("pose", POSES["pose"], ids=lambda pose: str(pose["joints"]))
def test_published_joint_angles_give_their_tip_and_boresight(arm: aftdeck.Arm, pose: dict[str, list[float]]) -> None:
    found = arm.forward(np.radians(pose["joints"]))
    assert structural(found.position) / INCH == pytest.approx(pose["tip"], abs=POSES["tip_tolerance"])
    boresight = BODY @ AXES @ found.rotation[:, 0]
    assert boresight == pytest.approx(pose["boresight"], abs=POSES["boresight_tolerance"])


def test_frame_7_has_the_axes_of_l_at_zero_angles(arm: aftdeck.Arm) -> None:
    assert arm.forward(np.zeros(6)).rotation == pytest.approx(np.eye(3), abs=1e-15)


def test_wrist_camera_is_above_the_roll_axis_at_zero_angles(
    arm: aftdeck.Arm,
) -> None:
    pose = arm.forward(np.zeros(6))
    camera = (np.array(CENTRES["wrist_camera"]) - np.array(CENTRES["tip"])) * INCH
    in_e = arm.end_effector(pose.rotation).T @ AXES.T @ camera
    assert in_e == pytest.approx([-28.8 * INCH, 0.0, -11.25 * INCH], abs=1e-6)


def test_batched_poses_equal_single_poses(any_arm: aftdeck.Arm) -> None:
    q = legal(any_arm, 1, 24).reshape(2, 3, 4, 6)
    many = any_arm.forward(q)
    assert many.position.shape == (2, 3, 4, 3) and many.rotation.shape == (2, 3, 4, 3, 3)
    for index in np.ndindex(2, 3, 4):
        one = any_arm.forward(q[index])
        assert (one.position == many.position[index]).all() and (one.rotation == many.rotation[index]).all()


def test_empty_input_gives_no_poses(arm: aftdeck.Arm) -> None:
    assert arm.forward(np.empty((0, 6))).position.shape == (0, 3)


def test_rotations_are_orthonormal_and_right_handed(any_arm: aftdeck.Arm) -> None:
    rotation = any_arm.forward(legal(any_arm, 2, 1000)).rotation
    assert np.abs(rotation @ np.swapaxes(rotation, 1, 2) - np.eye(3)).max() < 1e-14
    assert np.linalg.det(rotation) == pytest.approx(np.ones(1000))


@pytest.mark.parametrize(
    ("given", "pattern"),
    [
        (5.0, r"joint angles: .*\(\.\.\., 6\).* \(\)"),
        ([1.0, 2.0], r"joint angles: .*\(\.\.\., 6\).* \(2,\)"),
        ([[0.0] * 7], r"joint angles: .*\(\.\.\., 6\).* \(1, 7\)"),
        ("north", "joint angles: .*'north'"),
        ([0, 0, math.nan, 0, 0, 0], "joint angles: .*finite"),
        ([0, 0, math.inf, 0, 0, 0], "joint angles: .*finite"),
    ],
)
def test_invalid_joint_angles_are_rejected(arm: aftdeck.Arm, given: ArrayLike, pattern: str) -> None:
    for call in (arm.forward, arm.jacobian, arm.singularities):
        with pytest.raises(InputError, match=pattern):
            call(given)


def test_complex_angles_are_rejected(arm: aftdeck.Arm) -> None:
    with pytest.raises(InputError, match="expected numbers"):
        arm.forward(np.full(6, 0.1 + 0.1j))


def test_payload_pose_follows_its_own_axes() -> None:
    tip = Pose(np.array([1.0, 2.0, 3.0]), rotation_x(math.pi / 2))
    payload = HeldPayload(100.0, rotation_x(math.pi / 2), np.array([4.0, 0.0, 1.0]), np.array([0.0, 0.5, 0.0]))
    held = payload.pose(tip)
    # frame 7 and T_78 are each rotated by 90 deg about axis 1: axis 3 of the payload is axis -3 of L
    assert held.position == pytest.approx([5.0, 2.0, 2.0])
    assert held.rotation == pytest.approx(np.diag([1.0, -1.0, -1.0]))
    assert payload.resolution(tip) == pytest.approx([5.0, 1.5, 2.0])
