"""Poses as rows of twelve numbers, for laws: the origin [m], then the rotation row by row."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.frames import Pose
from aftdeck.law import law

POSE = 12
"""Length of a row."""
HERE = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
"""The row of a frame in itself."""


def row_of(pose: Pose) -> Array:
    """A pose as a row."""
    return np.concatenate([pose.position, np.ravel(pose.rotation)])


def inverse(row: Array) -> Array:
    """(12,) the pose of a frame in a body whose pose (12,) in that frame is given."""
    found = np.empty(POSE)
    relative(row, np.array(HERE), found)
    return found


def pose_of(row: Array) -> Pose:
    """A row as a pose."""
    return Pose(row[:3].copy(), row[3:].reshape(3, 3).copy())


@law
def compose(outer: Array, inner: Array, out: Array) -> None:
    """A pose given in a frame, where that frame has the pose `outer`; rows (12,), `out` is neither of the two."""
    for i in range(3):
        a, b, c = outer[3 + 3 * i], outer[4 + 3 * i], outer[5 + 3 * i]
        out[i] = outer[i] + a * inner[0] + b * inner[1] + c * inner[2]
        for j in range(3):
            out[3 + 3 * i + j] = a * inner[3 + j] + b * inner[6 + j] + c * inner[9 + j]


@law
def relative(frame: Array, body: Array, out: Array) -> None:
    """The pose of a body in a frame, both given in a third; rows (12,), `out` is neither of the two."""
    x, y, z = body[0] - frame[0], body[1] - frame[1], body[2] - frame[2]
    for i in range(3):
        a, b, c = frame[3 + i], frame[6 + i], frame[9 + i]
        out[i] = a * x + b * y + c * z
        for j in range(3):
            out[3 + 3 * i + j] = a * body[3 + j] + b * body[6 + j] + c * body[9 + j]
