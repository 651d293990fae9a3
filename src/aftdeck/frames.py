"""Coordinate frames, poses, and the angles that describe orientations.

- **L**, the longeron frame: the arm's base, origin at the shoulder yaw joint; all laws use it.
- **orbiter** (B): origin at the orbiter's centre of mass, x forward, y starboard, z down; orientation by
  ENDORI angles (azimuth about 3, elevation about 2, roll about 1, in that order) or by a matrix.
- **panel**: X = -Xo, Y = Yo, Z = -Zo from the structural origin; orientation by pitch about 2, yaw about 3, roll about
  1, in that order. The panel displays the attitude of the end effector's own axes E.
- **scene**: x aft, y starboard, z up, origin at the worksite's origin; for pictures only.

A transform's name gives both frames: ``T_orbiter_L`` converts components in L to components in orbiter.
"""

from __future__ import annotations

import math
from typing import Literal, NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.elementary import atan2, sincos
from aftdeck.law import elementary_law
from aftdeck.matrices import length, product
from aftdeck.quaternions import unit_quaternion
from aftdeck.tuples import Rows
from aftdeck.units import INCH

FrameName = Literal["L", "orbiter", "panel"]

SCENE_ORIGIN = np.array([942.0, 0.0, 400.0]) * INCH
"""Origin of the Shuttle's scene in structural coordinates Xo, Yo, Zo [m]."""
SCENE_FROM_PANEL_AXES = np.diag([-1.0, 1.0, -1.0])
"""Rotation from panel to scene axes: scene x aft, y starboard, z up; panel x forward, y starboard, z down."""


class Pose(NamedTuple):
    """Position and orientation of a coordinate frame, relative to a reference frame.

    Attributes:
        position: (..., 3) the frame's origin, in the reference frame [m].
        rotation: (..., 3, 3) columns are the frame's axes, in the reference frame.
    """

    position: Array
    rotation: Array


IDENTITY = Pose(np.zeros(3), np.eye(3))
"""Pose of a frame in itself."""


class Mount(NamedTuple):
    """Position and orientation of an arm's base frame L on the orbiter.

    Attributes:
        origin: (3,) L's origin in panel coordinates [m].
        rotation: (3, 3) columns are L's axes in orbiter (and panel) components; T_LB transposed.
        orbiter_origin: (3,) origin of the orbiter frame B in panel coordinates [m].
    """

    origin: Array
    rotation: Array
    orbiter_origin: Array

    def to(self, frame: FrameName, pose: Pose) -> Pose:
        """Convert a pose from L to another coordinate frame."""
        if frame == "L":
            return pose
        rotation = product(self.rotation, pose.rotation)
        position = product(pose.position, self.rotation.T) + self.origin
        return Pose(position if frame == "panel" else position - self.orbiter_origin, rotation)

    def from_(self, frame: FrameName, pose: Pose) -> Pose:
        """Convert a pose from another coordinate frame to L."""
        if frame == "L":
            return pose
        position = pose.position if frame == "panel" else pose.position + self.orbiter_origin
        return Pose(product(position - self.origin, self.rotation), product(self.rotation.T, pose.rotation))


def rotation_x(angle: float) -> Array:
    """Return the (3, 3) active rotation about axis 1 by angle [rad]: the report's T1(angle) transposed."""
    s, c = sincos(angle)
    return np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])


def rotation_y(angle: float) -> Array:
    """Return the (3, 3) active rotation about axis 2 by angle [rad]: the report's T2(angle) transposed."""
    s, c = sincos(angle)
    return np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])


def rotation_z(angle: float) -> Array:
    """Return the (3, 3) active rotation about axis 3 by angle [rad]: the report's T3(angle) transposed."""
    s, c = sincos(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def endori(roll: float, elevation: float, azimuth: float) -> Array:
    """Return the orientation for ENDORI's Euler angles [rad]; JSC-12628, subroutine ENDORI.

    Returns:
        (3, 3) the rotated frame's axes as columns: azimuth about 3, then elevation about the new 2, then
        roll about the new 1.
    """
    return product(product(rotation_z(azimuth), rotation_y(elevation)), rotation_x(roll))


def oriend(rotation: Array) -> tuple[float, float, float]:
    """Return roll, elevation and azimuth [rad] of an orientation; JSC-12628, subroutine ORIEND.

    Elevation lies in [-pi/2, pi/2]. At elevation +-pi/2 only azimuth -+ roll is determined; roll is then set to 0.
    """
    return oriend_rows(rotation.tolist())


def oriend_rows(rows: Rows) -> tuple[float, float, float]:
    """Return the angles of `oriend` for an orientation that is given as the rows of its rotation matrix."""
    (a, b, _), (d, e, _), (g, h, i) = rows
    return oriend_elements(a, b, d, e, g, h, i)


@elementary_law
def oriend_elements(a: float, b: float, d: float, e: float, g: float, h: float, i: float) -> tuple[float, float, float]:
    """Return the angles of `oriend` for a rotation matrix with the rows (a, b, _), (d, e, _) and (g, h, i)."""
    cosine = math.sqrt(a * a + d * d)
    elevation = atan2(-g, cosine)
    if cosine < _GIMBAL:
        return 0.0, elevation, atan2(-b, e)
    return atan2(h, i), elevation, atan2(d, a)


def panel_rotation(pitch: float, yaw: float, roll: float) -> Array:
    """Return the orientation for a panel attitude [rad]: pitch about 2, yaw about the new 3, roll about the new 1."""
    return product(product(rotation_y(pitch), rotation_z(yaw)), rotation_x(roll))


def panel_attitude(rotation: Array) -> tuple[float, float, float]:
    """Return pitch, yaw and roll [rad] of an orientation, each in [0, 2 pi), as on the panel's display.

    At yaw +-90 deg only pitch +- roll is determined; roll is then set to 0 (the display's known singularity).
    """
    sine = rotation[1, 0]
    cosine = math.sqrt(rotation[0, 0] * rotation[0, 0] + rotation[2, 0] * rotation[2, 0])
    yaw = atan2(sine, cosine)
    if cosine < _GIMBAL:
        pitch, roll = atan2(rotation[0, 2], rotation[2, 2]), 0.0
    else:
        pitch = atan2(-rotation[2, 0], rotation[0, 0])
        roll = atan2(-rotation[1, 2], rotation[1, 1])
    return _turn(pitch), _turn(yaw), _turn(roll)


@elementary_law
def angle_between(rows: Rows, other: Rows) -> float:
    """Return the angle [rad] of the rotation between two orientations, accurate from 0 to pi.

    Each orientation is given as the rows of its rotation matrix.
    """
    (a, b, c), (d, e, f), (g, h, i) = rows
    (p, q, r), (s, t, u), (v, w, o) = other
    x = g * s + h * t + i * u - d * v - e * w - f * o  # x, y, z: vector along the axis, of length 2 sin(angle)
    y = a * v + b * w + c * o - g * p - h * q - i * r
    z = d * p + e * q + f * r - a * s - b * t - c * u
    trace = a * p + b * q + c * r + d * s + e * t + f * u + g * v + h * w + i * o
    return atan2(0.5 * math.sqrt(x * x + y * y + z * z), 0.5 * (trace - 1.0))


def quaternion(rotation: Array) -> tuple[float, float, float, float]:
    """Return the unit quaternion (w, x, y, z), w >= 0, of a rotation matrix."""
    return quaternion_of_rows(rotation.tolist())


def quaternion_of_rows(rotation: Rows) -> tuple[float, float, float, float]:
    """Return the quaternion of a rotation matrix that is given by its rows, as `quaternion` does."""
    return unit_quaternion(*rotation[0], *rotation[1], *rotation[2])


def rotation_of(quaternion: tuple[float, float, float, float]) -> Rows:
    """Return the rotation matrix, as rows, of a quaternion (w, x, y, z). The quaternion need not be normalised."""
    size = length(quaternion)
    w, x, y, z = quaternion
    w, x, y, z = w / size, x / size, y / size, z / size
    return (
        (1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)),
        (2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)),
        (2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)),
    )


_GIMBAL = 1e-9
"""Limit of the middle angle's cosine; below it, only the sum or difference of the other two angles is determined."""


def _turn(angle: float) -> float:
    """Return an angle reduced to [0, 2 pi)."""
    turned = angle % math.tau
    return 0.0 if turned >= math.tau else turned
