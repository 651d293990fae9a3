"""Poses of a chain's joints and of its tip, and the Jacobian.

A chain is an array with one row for each joint, from the foot to the tip; `arms.chain` has the indices into a row.
The coordinate of a joint is its angle [rad] if it turns, and its displacement [m] if it slides. L is the foot's frame.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arms.chain import AXIS, SLIDES
from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, compose, put_turn
from aftdeck.elementary import sincos
from aftdeck.kinematics.linkage import Floats
from aftdeck.law import law


@law
def place_joints(chain: Array, hand: Array, q: Floats, joints: Array, tip: Array) -> None:
    """Write the poses of all joints' frames and of the tip, in L.

    A joint's frame moves with the joint.

    Args:
        chain: (n, 16) the chain.
        hand: (12,) pose of the tip in the last joint's frame.
        q: (n,) coordinates of the joints [rad or m].
        joints: (n, 12) output.
        tip: (12,) output.
    """
    still, motion = np.empty(POSE), np.empty(POSE)
    for i in range(chain.shape[0]):
        _move(chain[i], q[i], motion)
        if i == 0:
            compose(chain[0], motion, joints[0])  # a row of the chain begins with a pose
        else:
            compose(joints[i - 1], chain[i], still)
            compose(still, motion, joints[i])
    compose(joints[chain.shape[0] - 1], hand, tip)


@law
def _move(joint: Array, q: float, motion: Array) -> None:
    """Write the displacement (12,) that a joint's motion makes, in the joint's frame at coordinate 0."""
    x, y, z = joint[AXIS], joint[AXIS + 1], joint[AXIS + 2]
    if joint[SLIDES] != 0.0:
        motion[0], motion[1], motion[2] = q * x, q * y, q * z
        s, c = 0.0, 1.0
    else:
        motion[0], motion[1], motion[2] = 0.0, 0.0, 0.0
        s, c = sincos(q)
    put_turn(x, y, z, s, c, motion)


@law
def axis_of(chain: Array, joints: Array, i: int) -> tuple[float, float, float]:
    """Return the axis of joint `i` in L, which the joint's own motion does not change."""
    x, y, z = chain[i, AXIS], chain[i, AXIS + 1], chain[i, AXIS + 2]
    row = joints[i]
    return (
        row[3] * x + row[4] * y + row[5] * z,
        row[6] * x + row[7] * y + row[8] * z,
        row[9] * x + row[10] * y + row[11] * z,
    )


@law
def write_jacobian(chain: Array, joints: Array, tip: Array, matrix: Array) -> None:
    """Write the Jacobian: the tip's twist in L for a unit rate of each joint.

    Args:
        chain: (n, 16) the chain.
        joints: (n, 12) poses of the joints in L.
        tip: (12,) pose of the tip in L.
        matrix: (6, n) output: three rows for the angular velocity, then three for the translational velocity.
    """
    for i in range(chain.shape[0]):
        x, y, z = axis_of(chain, joints, i)
        if chain[i, SLIDES] != 0.0:
            matrix[0, i], matrix[1, i], matrix[2, i] = 0.0, 0.0, 0.0
            matrix[3, i], matrix[4, i], matrix[5, i] = x, y, z
        else:
            a, b, c = tip[0] - joints[i, 0], tip[1] - joints[i, 1], tip[2] - joints[i, 2]
            matrix[0, i], matrix[1, i], matrix[2, i] = x, y, z
            matrix[3, i], matrix[4, i], matrix[5, i] = y * c - z * b, z * a - x * c, x * b - y * a
