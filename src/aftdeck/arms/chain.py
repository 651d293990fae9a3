"""Chain of an arm's joints as packed numbers, for the laws of the general solver (`kinematics.chain`).

A packed chain has room for `MOST_JOINTS` joints. It is the end of the array of an arm with a chain of its own, and of
the steering's rules for such an arm. L is the arm's base frame.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from aftdeck.arms.rank import Joint, best_of
from aftdeck.arrays import Array
from aftdeck.matrices import length
from aftdeck.tuples import MOST_JOINTS

PLACE = 0
"""Index of a joint's pose at coordinate 0 in the frame of the joint before it, or in L: a row of `bodies.pose`."""
AXIS = 12
"""Index of the unit vector along the joint's axis, in the joint's own frame."""
SLIDES = 15
"""Index of the kind of joint: 0 if it turns about its axis, 1 if it slides along it."""
JOINT = 16
"""Number of values of a joint; the joints' rows are the beginning of a packed chain, from the foot to the tip."""
HAND = MOST_JOINTS * JOINT
"""(12,) pose of the tip in the last joint's frame."""
WEIGHTS = HAND + 12
"""(8,) weights of the joints: a joint with twice the weight takes twice the share of a motion; slides have the square
of `SCALE` besides."""
FOLLOW = WEIGHTS + MOST_JOINTS
"""Weight of an angular velocity, in comparison with a velocity divided by `SCALE` [1]. It matters only for a
chain that cannot make every twist."""
SCALE = FOLLOW + 1
"""Length that counts as much as an angle of 1 rad [m]: a third of the sum of the distances from joint to joint and to
the tip. Arms of the usual shape then turn and move their tips about equally well."""
COUNT = SCALE + 1
"""Number of joints."""
RANK = COUNT + 1
"""Number of independent twists that the chain can make in most postures."""
EVEN = RANK + 1
"""Last singular value of the rank as a share of the first, in the best posture: the distance is 1 there."""
CHAIN = EVEN + 1
"""Number of values in a packed chain."""

TWIST = 6
"""Number of components of a twist: the greatest rank."""
_UNTURNED = np.eye(3).ravel()


def chain_length(steps: Sequence[Sequence[float]], tip: Sequence[float]) -> float:
    """Return the sum of the distances from joint to joint and to the tip [m], at coordinates 0.

    Args:
        steps: vector from the joint before to each joint, or from L's origin to the first, which does not count [m].
        tip: vector from the last joint to the tip [m].
    """
    total = length(tip)
    for step in steps[1:]:
        total += length(step)
    return total


def packed_chain(joints: tuple[Joint, ...], tip: Array, turning: float) -> Array:
    """Return a chain as a packed array (CHAIN,).

    Args:
        joints: the joints, from the foot to the tip.
        tip: (3,) vector from the last joint to the tip, at coordinates 0 [m]. At coordinates 0, the tip has L's axes.
        turning: `FOLLOW`, for a chain that cannot make every twist.
    """
    packed = np.zeros(CHAIN)
    scale = chain_length([joint.step.tolist() for joint in joints], tip.tolist()) / 3.0
    for k, joint in enumerate(joints):
        row = packed[k * JOINT : (k + 1) * JOINT]
        row[PLACE : PLACE + 3], row[PLACE + 3 : PLACE + 12] = joint.step, _UNTURNED
        row[AXIS : AXIS + 3], row[SLIDES] = joint.axis, joint.slides
        packed[WEIGHTS + k] = joint.weight * (scale * scale if joint.slides else 1.0)
    packed[HAND : HAND + 3], packed[HAND + 3 : HAND + 12] = tip, _UNTURNED
    packed[SCALE], packed[COUNT], (packed[RANK], packed[EVEN]) = scale, len(joints), best_of(joints, tip, scale)
    packed[FOLLOW] = 1.0 if packed[RANK] == TWIST else turning
    return packed
