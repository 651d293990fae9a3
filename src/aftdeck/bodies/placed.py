"""Poses as a frame has them: a position and the rows of a rotation, as tuples.

Python calls these laws several times for a frame. A call with tuples takes less than a microsecond; arrays would first
have to be made, which takes longer.
"""

from __future__ import annotations

from math import sqrt

from aftdeck.arrays import Array
from aftdeck.frames import Pose, angle_between
from aftdeck.law import law
from aftdeck.quaternions import rotation_vector
from aftdeck.tuples import Rows, Six, Vec3

Place = tuple[Vec3, Rows]
"""Position [m], and the rows of a rotation matrix."""


def place_of(pose: Pose) -> Place:
    """Return a pose as tuples."""
    x, y, z = pose.position.tolist()
    return (x, y, z), rows_of(pose.rotation)


def rows_of(rotation: Array) -> Rows:
    """Return the rows of a rotation matrix (3, 3)."""
    (a, b, c), (d, e, f), (g, h, i) = rotation.tolist()
    return (a, b, c), (d, e, f), (g, h, i)


@law
def turned(rotation: Rows, v: Vec3) -> Vec3:
    """Return the product of a rotation matrix and a vector."""
    (a, b, c), (d, e, f), (g, h, i) = rotation
    x, y, z = v
    return a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z


@law
def components(v: Vec3, axes: Rows) -> Vec3:
    """Return the components of a vector along the columns of a rotation matrix."""
    (a, b, c), (d, e, f), (g, h, i) = axes
    x, y, z = v
    return x * a + y * d + z * g, x * b + y * e + z * h, x * c + y * f + z * i


@law
def matrix_product(left: Rows, right: Rows) -> Rows:
    """Return the product of two rotation matrices."""
    return components(left[0], right), components(left[1], right), components(left[2], right)


@law
def transposed(rotation: Rows) -> Rows:
    """Return the transposed matrix."""
    (a, b, c), (d, e, f), (g, h, i) = rotation
    return (a, d, g), (b, e, h), (c, f, i)


@law
def composed(outer_at: Vec3, outer: Rows, inner_at: Vec3, inner: Rows) -> Place:
    """Return the composed pose: the outer one is that of the frame in which the inner one is given."""
    x, y, z = turned(outer, inner_at)
    return (outer_at[0] + x, outer_at[1] + y, outer_at[2] + z), matrix_product(outer, inner)


@law
def inverted(at: Vec3, rotation: Rows) -> Place:
    """Return the inverse pose."""
    back = transposed(rotation)
    x, y, z = turned(back, at)
    return (-x, -y, -z), back


@law
def carried(seat_at: Vec3, seat: Rows, payload_at: Vec3, payload: Rows, tip_at: Vec3, tip: Rows) -> Place:
    """Return the pose of the tip that puts the payload in its grasp at a seat."""
    from_at, back = inverted(payload_at, payload)
    in_payload_at, in_payload = composed(from_at, back, tip_at, tip)
    return composed(seat_at, seat, in_payload_at, in_payload)


@law
def motion_left(to_at: Vec3, to: Rows, tip_at: Vec3, tip: Rows, point: Vec3) -> tuple[Place, float, float]:
    """Return the motion that puts the tip at a pose, the distance [m] by which it moves a point, and its angle [rad].

    The motion is that of the space with the tip: x becomes R x + p.
    """
    from_at, back = inverted(tip_at, tip)
    p, r = composed(to_at, to, from_at, back)
    x, y, z = shift(p, r, point)
    return (p, r), sqrt(x * x + y * y + z * z), angle_between(to, tip)


@law
def shift(p: Vec3, r: Rows, point: Vec3) -> Vec3:
    """Return the displacement of a point by the motion x to R x + p."""
    x, y, z = turned(r, point)
    return x + p[0] - point[0], y + p[1] - point[1], z + p[2] - point[2]


@law
def along_axes(p: Vec3, r: Rows, point: Vec3, moving: Rows, turning: Rows) -> tuple[Vec3, Vec3]:
    """Return the components of the motion x to R x + p: displacement of a point [m], and rotation vector [rad].

    The displacement is along the columns of `moving`, the rotation about those of `turning`.
    """
    (a, b, c), (d, e, f), (g, h, i) = r
    return components(shift(p, r, point), moving), components(rotation_vector(a, b, c, d, e, f, g, h, i), turning)


@law
def motions_along(
    p: Vec3, r: Rows, point: Vec3, twist: Six, moving: Rows, turning: Rows
) -> tuple[Vec3, Vec3, Vec3, Vec3]:
    """Return the results of `along_axes` and of `twist_along`; one call takes less time than two."""
    to_go, rotation_to_go = along_axes(p, r, point, moving, turning)
    velocity, rate = twist_along(twist, moving, turning)
    return to_go, rotation_to_go, velocity, rate


@law
def twist_along(twist: Six, moving: Rows, turning: Rows) -> tuple[Vec3, Vec3]:
    """Return the components of a twist: velocity along the columns of `moving`, angular velocity along `turning`."""
    turn, move = (twist[0], twist[1], twist[2]), (twist[3], twist[4], twist[5])
    return components(move, moving), components(turn, turning)
