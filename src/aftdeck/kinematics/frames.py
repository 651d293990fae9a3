"""Poses of all frames of an arm, in L. Each solid, drawn shape and camera of the arm belongs to one of these frames."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arms.geometry import frozen
from aftdeck.arms.load import ArmModel
from aftdeck.arrays import Array
from aftdeck.elementary import sincos
from aftdeck.kinematics.linkage import Three
from aftdeck.law import law

POSE = 12
"""Number of values in a frame's row: position [m], then the rotation matrix row by row. The matrix's columns are the
frame's axes in L."""
_CHAINED = 7
"""Number of frames in the chain of joints, including the frame of the foot."""


class Frames(NamedTuple):
    """Frames of an arm, in the form that `place_frames` uses.

    Attributes:
        names: names of the frames, `ArmModel.frames`.
        joints: (6, 4) one row for each joint: the vector to it from the previous joint, at zero angles [m], then the
            number of its axis of rotation, 1 to 3. The first joint's vector begins at L's origin.
    """

    names: tuple[str, ...]
    joints: Array

    def rows(self) -> Array:
        """Return an array with a row of zeros for each frame, as output for `place_frames`."""
        return np.zeros((len(self.names), POSE))


def frames_of(model: ArmModel) -> Frames:
    """Return the frames of an arm."""
    axes = np.array(model.linkage.axes, dtype=np.float64)
    return Frames(model.frames, frozen(np.column_stack([model.linkage.steps, axes])))


@law
def place_frames(joints: Array, angles: Array, stand: float, prong: float, rows: Array) -> None:
    """Write the poses of all frames: LNKAGE joint by joint, then telescope and prong.

    Args:
        joints: (6, 4) as `Frames.joints`.
        angles: (6,) joint angles [rad].
        stand: height of the shoulder above L's origin [m]: the telescope's length, or L1 for an arm without telescope.
        prong: y2 of the prong's inner face [m]; unused if there are seven rows.
        rows: (7 or 9, 12) output: the row of each frame, in L.
    """
    at: Three = (0.0, 0.0, 0.0)
    a: Three = (1.0, 0.0, 0.0)  # the frame's axes 1, 2, 3
    b: Three = (0.0, 1.0, 0.0)
    c: Three = (0.0, 0.0, 1.0)
    for i in range(_CHAINED):
        if i > 0:
            joint = joints[i - 1]
            at = _moved(at, a, joint[0])
            at = _moved(at, b, joint[1])
            at = _moved(at, c, -stand if i == 2 else joint[2])
            sine, cosine = sincos(angles[i - 1])
            if joint[3] == 1.0:
                b, c = _turned(b, c, sine, cosine)
            elif joint[3] == 2.0:
                c, a = _turned(c, a, sine, cosine)
            else:
                a, b = _turned(a, b, sine, cosine)
        _write(rows[i], at, a, b, c)
    if rows.shape[0] > _CHAINED:
        _write(rows[_CHAINED], (0.0, 0.0, -stand), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
        place_prong(prong, rows)


@law
def _moved(at: Three, axis: Three, by: float) -> Three:
    """Return a point moved along an axis [m]."""
    return at[0] + by * axis[0], at[1] + by * axis[1], at[2] + by * axis[2]


@law
def _turned(p: Three, q: Three, s: float, c: float) -> tuple[Three, Three]:
    """Return two axes p and q, rotated in their plane from p towards q; the angle has the sine s and the cosine c."""
    return (
        (c * p[0] + s * q[0], c * p[1] + s * q[1], c * p[2] + s * q[2]),
        (c * q[0] - s * p[0], c * q[1] - s * p[1], c * q[2] - s * p[2]),
    )


@law
def _write(row: Array, at: Three, a: Three, b: Three, c: Three) -> None:
    """Write a frame's row from its origin and its axes."""
    row[0], row[1], row[2] = at
    row[3], row[4], row[5] = a[0], b[0], c[0]
    row[6], row[7], row[8] = a[1], b[1], c[1]
    row[9], row[10], row[11] = a[2], b[2], c[2]


@law
def place_prong(prong: float, rows: Array) -> None:
    """Write the prong's pose, if the arm has one, from the pose of the last joint's frame.

    Args:
        prong: y2 of the prong's inner face [m].
        rows: (7 or 9, 12) as in `place_frames`; the last row is written.
    """
    if rows.shape[0] > _CHAINED:
        hand, row = rows[_CHAINED - 1], rows[_CHAINED + 1]
        for k in range(POSE):
            row[k] = hand[k]
        for i in range(3):
            row[i] += prong * hand[4 + 3 * i]
