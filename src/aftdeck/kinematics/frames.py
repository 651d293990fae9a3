"""Poses of all frames of an arm, in L. Each solid, drawn shape and camera of the arm belongs to one of these frames."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arms.geometry import frozen
from aftdeck.arms.load import ArmModel
from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, put_turn
from aftdeck.elementary import sincos
from aftdeck.kinematics.linkage import Three
from aftdeck.law import law

AXIS, DIRECTION, SLIDES, RAISED = 3, 4, 7, 8
"""Indices in a joint's row of `Frames.joints`, which begins with the vector to the joint."""


class Frames(NamedTuple):
    """Frames of an arm, in the form that `place_frames` uses.

    Attributes:
        names: names of the frames, `ArmModel.frames`.
        joints: (n, 9) one row for each joint: the vector to it from the previous joint, at zero angles [m]; the number
            of its axis of rotation, 1 to 3, or 0 for any other axis, and for a slide; the unit vector along its axis;
            1 if it slides; 1 if a telescope raises it. The first joint's vector begins at L's origin.
    """

    names: tuple[str, ...]
    joints: Array

    def rows(self) -> Array:
        """Return an array with a row of zeros for each frame, as output for `place_frames` (rows of `bodies.pose`)."""
        return np.zeros((len(self.names), POSE))


def frames_of(model: ArmModel) -> Frames:
    """Return the frames of an arm."""
    linkage = model.linkage
    joints = np.zeros((len(linkage.steps), 9))
    joints[:, :AXIS], joints[:, DIRECTION:SLIDES], joints[:, SLIDES] = linkage.steps, linkage.axes, linkage.slides
    for row in joints:
        named = np.flatnonzero((row[DIRECTION:SLIDES] == np.eye(3)).all(axis=1))
        row[AXIS] = 0.0 if row[SLIDES] or not len(named) else 1.0 + named[0]
    if model.telescope is not None:
        joints[0, RAISED] = 1.0
    return Frames(model.frames, frozen(joints))


@law
def place_frames(joints: Array, angles: Array, stand: float, prong: float, rows: Array) -> None:
    """Write the poses of all frames: LNKAGE joint by joint, then telescope and prong.

    Args:
        joints: (n, 9) as `Frames.joints`.
        angles: (n,) coordinates of the joints [rad or m].
        stand: height of the shoulder above L's origin, the telescope's length [m]; unused without a telescope.
        prong: y2 of the prong's inner face [m]; unused without a prong.
        rows: (n + 1 or n + 3, 12) output: the row of each frame, in L.
    """
    at: Three = (0.0, 0.0, 0.0)
    a: Three = (1.0, 0.0, 0.0)  # the frame's axes 1, 2, 3
    b: Three = (0.0, 1.0, 0.0)
    c: Three = (0.0, 0.0, 1.0)
    count = joints.shape[0]
    _write(rows[0], at, a, b, c)
    for i in range(count):
        joint = joints[i]
        at = _moved(at, a, joint[0])
        at = _moved(at, b, joint[1])
        at = _moved(at, c, -stand if joint[RAISED] != 0.0 else joint[2])
        if joint[SLIDES] != 0.0:
            at = _moved(at, a, angles[i] * joint[DIRECTION])
            at = _moved(at, b, angles[i] * joint[DIRECTION + 1])
            at = _moved(at, c, angles[i] * joint[DIRECTION + 2])
        else:
            sine, cosine = sincos(angles[i])
            if joint[AXIS] == 1.0:
                b, c = _turned(b, c, sine, cosine)
            elif joint[AXIS] == 2.0:
                c, a = _turned(c, a, sine, cosine)
            elif joint[AXIS] == 3.0:
                a, b = _turned(a, b, sine, cosine)
            else:
                a, b, c = _turned_about(joint, a, b, c, sine, cosine)
        _write(rows[1 + i], at, a, b, c)
    if rows.shape[0] > 1 + count:
        _write(rows[1 + count], (0.0, 0.0, -stand), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
        place_prong(prong, count, rows)


@law
def _turned_about(joint: Array, a: Three, b: Three, c: Three, s: float, t: float) -> tuple[Three, Three, Three]:
    """Return axes a, b and c after a rotation about a joint's axis by an angle with the sine s and the cosine t."""
    turn = np.empty(POSE)
    put_turn(joint[DIRECTION], joint[DIRECTION + 1], joint[DIRECTION + 2], s, t, turn)
    return _combined(turn, 3, a, b, c), _combined(turn, 4, a, b, c), _combined(turn, 5, a, b, c)


@law
def _combined(turn: Array, column: int, a: Three, b: Three, c: Three) -> Three:
    """Return the sum of a, b and c, each times its element of a column of a rotation."""
    x, y, z = turn[column], turn[column + 3], turn[column + 6]
    return x * a[0] + y * b[0] + z * c[0], x * a[1] + y * b[1] + z * c[1], x * a[2] + y * b[2] + z * c[2]


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
def place_prong(prong: float, count: int, rows: Array) -> None:
    """Write the prong's pose, if the arm has one, from the pose of the last joint's frame.

    Args:
        prong: y2 of the prong's inner face [m].
        count: number of joints.
        rows: (n + 1 or n + 3, 12) as in `place_frames`; the last row is written.
    """
    if rows.shape[0] > 1 + count:
        hand, row = rows[count], rows[count + 2]
        for k in range(POSE):
            row[k] = hand[k]
        for i in range(3):
            row[i] += prong * hand[4 + 3 * i]
