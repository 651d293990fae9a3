"""Sliding along walls: a commanded twist without the motion that would penetrate a wall.

Remote Manipulator Simulation, final report, section VII.4: the payload shall slide up or down while it touches a side
wall during extraction. The points of contact keep their velocity along the wall and lose the velocity into it. The
rotation is kept as commanded if the tip's velocity can make room for it, and is left out otherwise. If neither is
possible, the arm stops.
"""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Twist
from aftdeck.law import law

POINT, OUTWARD, LEAST = 0, 3, 6
"""Indices in a contact's row: the point [m]; the wall's unit normal towards the sliding body [1]; the least speed of
the point along the normal [m/s]. 0 keeps the point out of the wall, less lets it approach, more moves it out."""
TOUCH = 7
"""Length of a contact's row."""
SLACK = 1e-9
"""Rounding allowance below the least speed of a point [m/s]."""
_SAME = 1e-20
"""Squared difference of two normals that count as equal [1]: it changes speeds by less than SLACK."""
_PARALLEL = 1e-8
"""Sine of the angle below which two walls, or a wall and the line common to two others, count as parallel [1]."""


class Velocity(NamedTuple):
    """The tip's velocity, and its difference from the wanted one, inf if there is no velocity [m/s]."""

    x: float
    y: float
    z: float
    off: float


@law
def slide(touches: Array, x: float, y: float, z: float, wanted: Twist) -> Twist:
    """Return the twist of the tip that is nearest to the wanted one and moves no touching point into its wall.

    Args:
        touches: (k, 7) contacts, in L.
        x: x of the tip's position, in L; likewise y and z [m].
        y: see x.
        z: see x.
        wanted: wanted twist of the tip, in L.

    Returns:
        The first of these that is possible: the wanted twist; its rotation with the nearest velocity that makes room
        for the rotation; the nearest velocity without rotation; zero. The result is zero with walls on all sides, for
        example, or if points that have to come out of a wall cannot.
    """
    walls, least = np.empty((len(touches), 3)), np.empty(len(touches))
    for share in (1.0, 0.0):
        wx, wy, wz = share * wanted.wx, share * wanted.wy, share * wanted.wz
        count = 0
        for row in touches:
            nx, ny, nz = row[OUTWARD], row[OUTWARD + 1], row[OUTWARD + 2]
            rx, ry, rz = row[POINT] - x, row[POINT + 1] - y, row[POINT + 2] - z
            turned = nx * (wy * rz - wz * ry) + ny * (wz * rx - wx * rz) + nz * (wx * ry - wy * rx)
            count = _add(walls, least, count, nx, ny, nz, row[LEAST] - turned)
        v = _kept_off(walls[:count], least[:count], wanted.vx, wanted.vy, wanted.vz)
        if v.off < np.inf:
            return Twist(wx, wy, wz, v.x, v.y, v.z)
    return Twist(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@law
def _add(walls: Array, least: Array, count: int, nx: float, ny: float, nz: float, speed: float) -> int:
    """Add a wall that the tip has to leave at a least speed [m/s], or raise that of an equal wall; return the count."""
    for i in range(count):
        dx, dy, dz = nx - walls[i, 0], ny - walls[i, 1], nz - walls[i, 2]
        if dx * dx + dy * dy + dz * dz <= _SAME:
            least[i] = max(least[i], speed)
            return count
    walls[count, 0], walls[count, 1], walls[count, 2] = nx, ny, nz
    least[count] = speed
    return count + 1


@law
def _kept_off(walls: Array, least: Array, x: float, y: float, z: float) -> Velocity:
    """Return the velocity nearest to (x, y, z) that leaves every wall at its least speed or faster.

    At the solution none, one, two or three walls are left at exactly their least speed. All these cases are tried, and
    each candidate is checked against every wall.
    """
    best = _judged(walls, least, Velocity(np.inf, np.inf, np.inf, np.inf), x, y, z, x, y, z)
    if best.off == 0.0:
        return best
    for i in range(len(walls)):
        ix, iy, iz = walls[i]
        by = least[i] - (ix * x + iy * y + iz * z)
        x1, y1, z1 = x + by * ix, y + by * iy, z + by * iz
        best = _judged(walls, least, best, x, y, z, x1, y1, z1)
        for j in range(i + 1, len(walls)):
            jx, jy, jz = walls[j]
            # along wall i, perpendicular to the line common to both walls
            cosine = ix * jx + iy * jy + iz * jz
            tx, ty, tz = jx - cosine * ix, jy - cosine * iy, jz - cosine * iz
            square = tx * tx + ty * ty + tz * tz
            if square < _PARALLEL * _PARALLEL:
                continue
            by = (least[j] - (jx * x1 + jy * y1 + jz * z1)) / square
            x2, y2, z2 = x1 + by * tx, y1 + by * ty, z1 + by * tz
            best = _judged(walls, least, best, x, y, z, x2, y2, z2)
            ux, uy, uz = iy * jz - iz * jy, iz * jx - ix * jz, ix * jy - iy * jx
            for k in range(j + 1, len(walls)):
                along = walls[k, 0] * ux + walls[k, 1] * uy + walls[k, 2] * uz
                if abs(along) < _PARALLEL * sqrt(square):
                    continue
                by = (least[k] - (walls[k, 0] * x2 + walls[k, 1] * y2 + walls[k, 2] * z2)) / along
                best = _judged(walls, least, best, x, y, z, x2 + by * ux, y2 + by * uy, z2 + by * uz)
    return best


@law
def _judged(
    walls: Array, least: Array, best: Velocity, x: float, y: float, z: float, vx: float, vy: float, vz: float
) -> Velocity:
    """Return the velocity v if it is nearer to (x, y, z) than `best` and leaves every wall fast enough, else `best`."""
    dx, dy, dz = vx - x, vy - y, vz - z
    off = sqrt(dx * dx + dy * dy + dz * dz)
    if off >= best.off:
        return best
    for i in range(len(walls)):
        if walls[i, 0] * vx + walls[i, 1] * vy + walls[i, 2] * vz < least[i] - SLACK:
            return best
    return Velocity(vx, vy, vz, off)
