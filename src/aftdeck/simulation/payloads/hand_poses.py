"""Poses of a payload and of its grapple fixture relative to the end effector, each in one compiled call."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, relative
from aftdeck.law import law


@law
def payload_in_hand(frames: Array, last_joint: int, row: int, hand: Array, packed: Array) -> None:
    """Write a payload's pose in frame 7 to `packed`, in the layout of `HeldPayload.packed`; its POR is its centre.

    Args:
        frames: (F, 12) poses of all frames in L.
        last_joint: row of the frame of the last joint.
        row: row of the payload's frame.
        hand: (12,) pose of frame 7 in the frame of the last joint.
        packed: (15,) output.
    """
    grasp, inside = np.empty(POSE), np.empty(POSE)
    relative(frames[last_joint], frames[row], grasp)
    relative(hand, grasp, inside)
    packed[:9] = inside[3:]
    for i in range(3):
        packed[9 + i] = inside[3 + i] * inside[0] + inside[6 + i] * inside[1] + inside[9 + i] * inside[2]
    packed[12:] = 0.0
