"""Poses as rows of twelve numbers, for the laws: the origin [m], then the rotation row by row."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.frames import Pose
from aftdeck.law import law

POSE = 12
"""Length of a row."""
HERE = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
"""Row of the identity pose: a frame in itself."""


def row_of(pose: Pose) -> Array:
    """Return a pose as a row."""
    return np.concatenate([pose.position, np.ravel(pose.rotation)])


def inverse(row: Array) -> Array:
    """Return the inverse (12,) of a body's pose in a frame: the pose of the frame in the body."""
    found = np.empty(POSE)
    relative(row, np.array(HERE), found)
    return found


def pose_of(row: Array) -> Pose:
    """Return a row as a pose."""
    return Pose(row[:3].copy(), row[3:].reshape(3, 3).copy())


@law
def compose(outer: Array, inner: Array, out: Array) -> None:
    """Write into `out` the composed pose: `inner` is given in a frame, and that frame has the pose `outer`.

    All three are rows (12,). `out` must not be `outer` or `inner`.
    """
    for i in range(3):
        a, b, c = outer[3 + 3 * i], outer[4 + 3 * i], outer[5 + 3 * i]
        out[i] = outer[i] + a * inner[0] + b * inner[1] + c * inner[2]
        for j in range(3):
            out[3 + 3 * i + j] = a * inner[3 + j] + b * inner[6 + j] + c * inner[9 + j]


@law
def relative(frame: Array, body: Array, out: Array) -> None:
    """Write into `out` the pose of a body in a frame, with both given in a third frame.

    All three are rows (12,). `out` must not be `frame` or `body`.
    """
    x, y, z = body[0] - frame[0], body[1] - frame[1], body[2] - frame[2]
    for i in range(3):
        a, b, c = frame[3 + i], frame[6 + i], frame[9 + i]
        out[i] = a * x + b * y + c * z
        for j in range(3):
            out[3 + 3 * i + j] = a * body[3 + j] + b * body[6 + j] + c * body[9 + j]
