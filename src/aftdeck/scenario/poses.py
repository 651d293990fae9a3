"""Conversion of a scenario's joint angles, matrices, poses and targets, with checks."""

from __future__ import annotations

from typing import get_args

import numpy as np

from aftdeck.arms.by_joint import shown, wrong_unit
from aftdeck.arms.geometry import frozen
from aftdeck.files import Where
from aftdeck.frames import FrameName, Pose, endori, panel_rotation, rotation_x
from aftdeck.kinematics.arm import Arm
from aftdeck.matrices import product
from aftdeck.scenario.by_joint import fits
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import JointAngles, PoseSpec, Row
from aftdeck.scenario.target import Target, target_at

FRAMES: tuple[FrameName, ...] = get_args(FrameName)
"""Coordinate frames in which every pose may be given."""
ORTHONORMAL = 1e-6
"""Greatest deviation of a matrix in the file from an orthonormal matrix [1]."""


def joint_angles(problems: Problems, arm: Arm, given: JointAngles, where: Where) -> np.ndarray | None:
    """Return the joints' coordinates (n,) [rad or m] as an array; None if their number or an angle is not allowed."""
    if not fits(problems, arm.model, given, where):
        return None
    inside = [check_angle(problems, arm, joint, angle, where) for joint, angle in enumerate(given)]
    return frozen(given) if all(inside) else None


def check_angle(problems: Problems, arm: Arm, joint: int, angle: float, where: Where) -> bool:
    """Return whether a joint's coordinate [rad or m] is within its hard limits; report it if not."""
    (low, high), slides = arm.limits.hard[joint], arm.model.slides[joint]
    if why := wrong_unit(arm.joints[joint], slides, angle):
        problems.add(where, why)
        return False
    if low <= angle <= high:
        return True
    at, least, most = (shown(value, slides) for value in (angle, low, high))
    problems.add(where, f"{arm.joints[joint]} at {at} is outside its hard limits {least} to {most}")
    return False


def rotation_matrix(problems: Problems, rows: tuple[Row, Row, Row], where: Where) -> np.ndarray | None:
    """Return a matrix as an array; None if the matrix is not right-handed and orthonormal."""
    matrix = np.array(rows, dtype=np.float64)
    if not np.isfinite(matrix).all():
        problems.add(where, "expected finite numbers")
    elif (
        np.abs(matrix).max() > 1.0 + ORTHONORMAL  # checked first: the products below may overflow
        or np.abs(matrix @ matrix.T - np.eye(3)).max() > ORTHONORMAL
        or np.linalg.det(matrix) < 0.0
    ):
        problems.add(where, "is not a right-handed orthonormal matrix (to within 1e-6)")
    else:
        return matrix
    return None


def target(problems: Problems, arm: Arm, spec: PoseSpec, where: Where) -> Target | None:
    """Return the target for a pose, given by joint angles or by position and orientation; None if the pose is wrong."""
    pose = pose_in_l(problems, arm, spec, where)
    if pose is None:
        return None
    if spec.joints is None:
        return target_at(pose)
    return target_at(pose, tuple(map(float, spec.joints)))


def pose_in_l(problems: Problems, arm: Arm, spec: PoseSpec, where: Where) -> Pose | None:
    """Return the pose of frame 7 in L that a table gives; None if the table is wrong.

    The table gives joint angles, or a position with an orientation.
    """
    if (spec.cargo, spec.seat, spec.above, spec.offset) != (None, None, None, None):
        what = "cargo, seat, above and offset are allowed only in the target of a phase and in the pose at the start"
        problems.add(where, what)
        return None
    if spec.joints is not None:
        euler = (spec.roll, spec.pitch, spec.yaw)
        if spec.position is not None or spec.matrix is not None or euler != (None, None, None):
            problems.add(where, "give either joints, or a position with an orientation, not both")
            return None
        angles = joint_angles(problems, arm, spec.joints, (*where, "joints"))
        return None if angles is None else arm.forward(angles)
    frame = next((name for name in FRAMES if name == spec.frame), None)
    if frame is None:
        problems.add((*where, "frame"), f"expected one of {', '.join(FRAMES)}, got {spec.frame!r}")
        return None
    pose = position_and_rotation(problems, spec, where)
    if pose is None:
        return None
    rotation = pose.rotation
    if frame == "panel":
        rotation = product(rotation, rotation_x(-arm.model.end_effector_roll))
    return arm.model.mount.from_(frame, Pose(pose.position, rotation))


def position_and_rotation(problems: Problems, spec: PoseSpec, where: Where) -> Pose | None:
    """Return a pose given by position and orientation, in the frame that `spec` names; None if the pose is wrong."""
    euler = (spec.roll, spec.pitch, spec.yaw)
    if spec.position is None or spec.joints is not None:
        problems.add(where, "give joints (the angle of each joint), or a position with an orientation")
        return None
    if spec.matrix is not None:
        if euler != (None, None, None):
            problems.add(where, "give either a matrix or roll, pitch, yaw, not both")
            return None
        given = rotation_matrix(problems, spec.matrix, (*where, "matrix"))
        if given is None:
            return None
        rotation = given
    else:
        roll, pitch, yaw = (angle or 0.0 for angle in euler)
        rotation = panel_rotation(pitch, yaw, roll) if spec.frame == "panel" else endori(roll, pitch, yaw)
    return Pose(np.array(spec.position, dtype=np.float64), rotation)
