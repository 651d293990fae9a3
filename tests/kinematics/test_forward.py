"""LNKAGE against published poses, and what callers may hand it."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from numpy.typing import ArrayLike

import aftdeck
from aftdeck.errors import InputError
from aftdeck.frames import Pose, rotation_x
from aftdeck.kinematics.payload import Payload
from tests.kinematics.poses import AXES, BODY, CENTRES, INCH, legal, structural
from tests.reference.tables import table

POSES = table("srms-poses")


@pytest.mark.parametrize("pose", POSES["pose"], ids=lambda pose: str(pose["joints"]))
def test_the_tip_and_the_boresight_of_a_published_pose_come_out(arm: aftdeck.Arm, pose: dict[str, list[float]]) -> None:
    found = arm.forward(np.radians(pose["joints"]))
    assert structural(found.position) / INCH == pytest.approx(pose["tip"], abs=POSES["tip_tolerance"])
    boresight = BODY @ AXES @ found.rotation[:, 0]
    assert boresight == pytest.approx(pose["boresight"], abs=POSES["boresight_tolerance"])


def test_at_zero_angles_frame_7_has_the_axes_of_l(arm: aftdeck.Arm) -> None:
    assert arm.forward(np.zeros(6)).rotation == pytest.approx(np.eye(3), abs=1e-15)


def test_at_zero_angles_the_wrist_camera_stands_straight_above_the_roll_axis_in_the_end_effectors_axes(
    arm: aftdeck.Arm,
) -> None:
    pose = arm.forward(np.zeros(6))
    camera = (np.array(CENTRES["wrist_camera"]) - np.array(CENTRES["tip"])) * INCH
    in_e = arm.end_effector(pose.rotation).T @ AXES.T @ camera
    assert in_e == pytest.approx([-28.8 * INCH, 0.0, -11.25 * INCH], abs=1e-6)


def test_leading_dimensions_of_any_number_give_the_same_as_one_pose_at_a_time(any_arm: aftdeck.Arm) -> None:
    q = legal(any_arm, 1, 24).reshape(2, 3, 4, 6)
    many = any_arm.forward(q)
    assert many.position.shape == (2, 3, 4, 3) and many.rotation.shape == (2, 3, 4, 3, 3)
    for index in np.ndindex(2, 3, 4):
        one = any_arm.forward(q[index])
        assert (one.position == many.position[index]).all() and (one.rotation == many.rotation[index]).all()


def test_no_poses_give_no_poses(arm: aftdeck.Arm) -> None:
    assert arm.forward(np.empty((0, 6))).position.shape == (0, 3)


def test_rotations_are_orthonormal_and_right_handed(any_arm: aftdeck.Arm) -> None:
    rotation = any_arm.forward(legal(any_arm, 2, 1000)).rotation
    assert np.abs(rotation @ np.swapaxes(rotation, 1, 2) - np.eye(3)).max() < 1e-14
    assert np.linalg.det(rotation) == pytest.approx(np.ones(1000))


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (5.0, "joint angles: expected shape (..., 6), got ()"),
        ([1.0, 2.0], "joint angles: expected shape (..., 6), got (2,)"),
        ([[0.0] * 7], "joint angles: expected shape (..., 6), got (1, 7)"),
        ("north", "joint angles: expected numbers, got 'north'"),
        ([0, 0, math.nan, 0, 0, 0], "joint angles: expected finite numbers"),
        ([0, 0, math.inf, 0, 0, 0], "joint angles: expected finite numbers"),
    ],
)
def test_what_is_no_set_of_six_angles_is_refused(arm: aftdeck.Arm, given: ArrayLike, message: str) -> None:
    for call in (arm.forward, arm.jacobian, arm.singularities):
        with pytest.raises(InputError, match=re.escape(message)):
            call(given)


def test_complex_angles_are_refused(arm: aftdeck.Arm) -> None:
    with pytest.raises(InputError, match="expected numbers"):
        arm.forward(np.full(6, 0.1 + 0.1j))


def test_a_payload_sits_where_its_own_axes_say() -> None:
    tip = Pose(np.array([1.0, 2.0, 3.0]), rotation_x(math.pi / 2))
    payload = Payload(100.0, rotation_x(math.pi / 2), np.array([4.0, 0.0, 1.0]), np.array([0.0, 0.5, 0.0]))
    held = payload.pose(tip)
    # frame 7's quarter turn and T_78's make half a turn about axis 1: the payload's 3 points along L's -3
    assert held.position == pytest.approx([5.0, 2.0, 2.0])
    assert held.rotation == pytest.approx(np.diag([1.0, -1.0, -1.0]))
    assert payload.resolution(tip) == pytest.approx([5.0, 1.5, 2.0])
