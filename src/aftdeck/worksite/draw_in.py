"""Drawing in: a misalignment that goes to nothing while a mechanism pulls a body into its seat.

Both the end effector's carriage and a retention latch do so. Not modelled: forces, and what gives way to them.
"""

from __future__ import annotations

import math

import numpy as np

from aftdeck.frames import Pose, Rows, angle_between, quaternion, rotation_of


def remaining(misalignment: Pose, fraction: float) -> Pose:
    """What is left of a misalignment: that fraction of its offset, and of its turn about the turn's own axis.

    Args:
        misalignment: of the body in its seat's frame, (3,) [m] and (3, 3); no turn when it is seated.
        fraction: 1 all of it, 0 nothing.
    """
    w, x, y, z = quaternion(misalignment.rotation)
    size = math.sqrt(x * x + y * y + z * z)
    if size == 0.0:
        return Pose(misalignment.position * fraction, np.eye(3))
    half = math.atan2(size, w) * fraction
    per = math.sin(half) / size
    turn = rotation_of((math.cos(half), x * per, y * per, z * per))
    return Pose(misalignment.position * fraction, np.array(turn))


def relative(body: Pose, seat: Pose) -> Pose:
    """A body's pose in the frame of a seat, both given in one frame."""
    return Pose((body.position - seat.position) @ seat.rotation, seat.rotation.T @ body.rotation)


def placed(seat: Pose, within: Pose) -> Pose:
    """The pose of what stands so within a seat, in the frame that the seat is given in."""
    return Pose(seat.position + seat.rotation @ within.position, seat.rotation @ within.rotation)


def turned_by(misalignment: Pose) -> float:
    """The angle of a misalignment's turn [rad]."""
    rows: Rows = tuple(tuple(row) for row in misalignment.rotation.tolist())  # type: ignore[assignment]
    return angle_between(rows, ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)))
