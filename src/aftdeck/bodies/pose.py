"""Poses as rows of twelve numbers, for the laws: the origin [m], then the rotation row by row."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.vector import Vector
from aftdeck.frames import Pose
from aftdeck.law import law
from aftdeck.tuples import Rows, Vec3

POSE = 12
"""Length of a row."""
HERE = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
"""Row of the identity pose."""


def row_of(pose: Pose) -> Array:
    """Return a pose as a row."""
    return np.concatenate([pose.position, np.ravel(pose.rotation)])


def inverse(row: Array) -> Array:
    """Return the inverse (12,): for a body's pose in frame F, the pose of frame F in the body's own frame."""
    found = np.empty(POSE)
    relative(row, np.array(HERE), found)
    return found


def pose_of(row: Array) -> Pose:
    """Return a row as a pose."""
    return Pose(row[:3].copy(), row[3:].reshape(3, 3).copy())


@law
def vec3(values: Array, at: int) -> Vec3:
    """Return three values of an array, from index `at` on, as Python floats, also if the laws are not compiled."""
    return float(values[at]), float(values[at + 1]), float(values[at + 2])


@law
def rows(values: Array, at: int) -> Rows:
    """Return nine values of an array, from index `at` on, as the rows of a matrix."""
    return vec3(values, at), vec3(values, at + 3), vec3(values, at + 6)


@law
def compose(outer: Array, inner: Array, out: Array) -> None:
    """Write into `out` the pose of a body in frame F.

    `outer` is the pose of a second frame in F, and `inner` is the pose of the body in this second frame. All three
    poses are rows (12,). `out` must not be `outer` or `inner`.
    """
    for i in range(3):
        a, b, c = outer[3 + 3 * i], outer[4 + 3 * i], outer[5 + 3 * i]
        out[i] = outer[i] + a * inner[0] + b * inner[1] + c * inner[2]
        for j in range(3):
            out[3 + 3 * i + j] = a * inner[3 + j] + b * inner[6 + j] + c * inner[9 + j]


@law
def relative(frame: Array, body: Array, out: Array) -> None:
    """Write the pose of a body in a frame into `out`; `body` and `frame` are their poses in a third frame.

    All three are rows (12,). `out` must not be `frame` or `body`.
    """
    x, y, z = body[0] - frame[0], body[1] - frame[1], body[2] - frame[2]
    for i in range(3):
        a, b, c = frame[3 + i], frame[6 + i], frame[9 + i]
        out[i] = a * x + b * y + c * z
        for j in range(3):
            out[3 + 3 * i + j] = a * body[3 + j] + b * body[6 + j] + c * body[9 + j]


@law
def put_turn(x: float, y: float, z: float, s: float, c: float, row: Array) -> None:
    """Write the rotation about the unit axis (x, y, z) into a pose (12,); `s` and `c`: the angle's sine and cosine.

    Source: Rodrigues' formula.
    """
    v = 1.0 - c
    row[3], row[4], row[5] = c + v * x * x, v * x * y - s * z, v * x * z + s * y
    row[6], row[7], row[8] = v * x * y + s * z, c + v * y * y, v * y * z - s * x
    row[9], row[10], row[11] = v * x * z - s * y, v * y * z + s * x, c + v * z * z


@law
def turned(pose: Array, v: Vector) -> Vector:
    """Convert a vector from the frame whose pose is `pose` (12,) to the frame in which that pose is given."""
    return Vector(
        pose[3] * v.x + pose[4] * v.y + pose[5] * v.z,
        pose[6] * v.x + pose[7] * v.y + pose[8] * v.z,
        pose[9] * v.x + pose[10] * v.y + pose[11] * v.z,
    )


@law
def turned_back(pose: Array, v: Vector) -> Vector:
    """Convert a vector from the frame in which `pose` (12,) is given to the frame whose pose is `pose`."""
    return Vector(
        pose[3] * v.x + pose[6] * v.y + pose[9] * v.z,
        pose[4] * v.x + pose[7] * v.y + pose[10] * v.z,
        pose[5] * v.x + pose[8] * v.y + pose[11] * v.z,
    )


@law
def moved(pose: Array, p: Vector) -> Vector:
    """Convert a point [m] from the frame whose pose is `pose` (12,) to the frame in which that pose is given."""
    return Vector(
        pose[0] + pose[3] * p.x + pose[4] * p.y + pose[5] * p.z,
        pose[1] + pose[6] * p.x + pose[7] * p.y + pose[8] * p.z,
        pose[2] + pose[9] * p.x + pose[10] * p.y + pose[11] * p.z,
    )
