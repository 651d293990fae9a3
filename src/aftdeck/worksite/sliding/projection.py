"""Sliding along walls: removal of the part of a commanded twist that would penetrate a wall.

Remote Manipulator Simulation, final report, section VII.4: during extraction, the payload has to slide up or down while
it touches a side wall. The points of contact keep their velocity along the wall and lose the velocity into the wall.
With a given rotation, a velocity of the tip is possible if no point of contact then moves into a wall. If a velocity is
possible with the commanded rotation, the rotation does not change. Otherwise, the rotation is set to zero. If no
velocity is possible with zero rotation either, the arm stops.
"""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.vector import Vector, cross, dot, minus, moved_along, put_vector, vector_at
from aftdeck.kinematics.jacobian import Twist
from aftdeck.law import law

POINT, OUTWARD, LEAST = 0, 3, 6
"""Indices in the row of a touch: the point [m]; the wall's unit normal towards the sliding body [1]; the least speed,
a lower limit of the component of the point's velocity along this normal [m/s]. If it is 0, the point stays out of the
wall. If it is negative, the point may approach the wall. If it is positive, the point moves out of the wall."""
TOUCH = 7
"""Length of the row of a touch."""
SLACK = 1e-9
"""Amount by which a point may be slower than its least speed, to allow for rounding [m/s]."""
_SAME = 1e-20
"""Greatest squared difference of two normals that count as equal [1]. Such a difference changes speeds by less than
SLACK."""
_PARALLEL = 1e-8
"""Sine of the greatest angle at which two walls, or a wall and the line common to two other walls, count as parallel
[1]."""


class Velocity(NamedTuple):
    """A velocity of the tip, and its difference from the demanded velocity [m/s].

    Attributes:
        v: the velocity.
        off: magnitude of the difference; inf if no velocity is possible.
    """

    v: Vector
    off: float


@law
def slide(touches: Array, tip: Vector, demanded: Twist) -> Twist:
    """Return a twist of the tip that is near to the demanded twist and moves no touching point into its wall.

    Args:
        touches: (k, 7) rows of touches, in L.
        tip: position of the tip, in L [m].
        demanded: demanded twist of the tip, in L.

    Returns:
        The first possible one of these twists: the demanded twist; the demanded angular velocity with the nearest
        possible velocity; zero angular velocity with the nearest possible velocity; zero. For example, the result is
        zero if there are walls on all sides, or if a point cannot come out of a wall as fast as it has to.
    """
    walls, least = np.empty((len(touches), 3)), np.empty(len(touches))
    for share in (1.0, 0.0):
        w = Vector(share * demanded.wx, share * demanded.wy, share * demanded.wz)
        count = 0
        for row in touches:
            n = vector_at(row, OUTWARD)
            by_turn = dot(n, cross(w, minus(vector_at(row, POINT), tip)))
            count = _add(walls, least, count, n, row[LEAST] - by_turn)
        best = _kept_off(walls[:count], least[:count], Vector(demanded.vx, demanded.vy, demanded.vz))
        if best.off < np.inf:
            return Twist(w.x, w.y, w.z, best.v.x, best.v.y, best.v.z)
    return Twist(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@law
def _add(walls: Array, least: Array, count: int, normal: Vector, speed: float) -> int:
    """Add a wall, with the least speed at which the tip has to leave it [m/s]; return the number of walls.

    If an equal wall is already listed, only its least speed is raised.
    """
    for i in range(count):
        d = minus(normal, vector_at(walls[i], 0))
        if dot(d, d) <= _SAME:
            least[i] = max(least[i], speed)
            return count
    put_vector(walls[count], 0, normal)
    least[count] = speed
    return count + 1


@law
def _kept_off(walls: Array, least: Array, demanded: Vector) -> Velocity:
    """Return the possible velocity of the tip that is nearest to the demanded velocity.

    A velocity is possible if its component along each wall's normal is at least the wall's least speed. At the
    solution, this component equals the least speed for 0, 1, 2 or 3 walls. The function tries all these cases, and
    checks each candidate against every wall.
    """
    best = _judged(walls, least, Velocity(demanded, np.inf), demanded, demanded)
    if best.off == 0.0:
        return best
    for i in range(len(walls)):
        n = vector_at(walls[i], 0)
        v1 = moved_along(demanded, least[i] - dot(n, demanded), n)
        best = _judged(walls, least, best, demanded, v1)
        for j in range(i + 1, len(walls)):
            m = vector_at(walls[j], 0)
            # along wall i, perpendicular to the line common to both walls
            t = moved_along(m, -dot(n, m), n)
            square = dot(t, t)
            if square < _PARALLEL * _PARALLEL:
                continue
            v2 = moved_along(v1, (least[j] - dot(m, v1)) / square, t)
            best = _judged(walls, least, best, demanded, v2)
            common = cross(n, m)
            for k in range(j + 1, len(walls)):
                wall = vector_at(walls[k], 0)
                along = dot(wall, common)
                if abs(along) < _PARALLEL * sqrt(square):
                    continue
                v3 = moved_along(v2, (least[k] - dot(wall, v2)) / along, common)
                best = _judged(walls, least, best, demanded, v3)
    return best


@law
def _judged(walls: Array, least: Array, best: Velocity, demanded: Vector, v: Vector) -> Velocity:
    """Return the better of two velocities: `v` if it is possible and nearer to the demanded velocity, else `best`.

    A velocity is possible if its component along each wall's normal is at least the wall's least speed minus `SLACK`.
    """
    d = minus(v, demanded)
    off = sqrt(dot(d, d))
    if off >= best.off:
        return best
    for i in range(len(walls)):
        if dot(vector_at(walls[i], 0), v) < least[i] - SLACK:
            return best
    return Velocity(v, off)
