"""Sliding along what is touched: a commanded twist, less what would go into a wall.

Remote Manipulator Simulation, final report, section VII.4: the payload shall slide up or down while it touches a side
wall during extraction. The points of contact keep their way along the wall and lose that into it. Turning is kept as
commanded where the tip can make room for it, else left out; where nothing else is left, the arm stands still.
"""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Twist
from aftdeck.law import law

POINT, OUTWARD, LEAST = 0, 3, 6
"""In a contact's row: the point [m]; the wall's unit normal towards what slides [1]; how fast at least the point goes
along it [m/s]: 0 does not let it into the wall, less lets it come nearer, more makes it come out."""
TOUCH = 7
"""Length of a contact's row."""
SLACK = 1e-9
"""How much slower than that a point may come out by rounding [m/s]."""
_SAME = 1e-20
"""Squared difference of two normals that count as one [1]: it moves speeds by less than SLACK."""
_PARALLEL = 1e-8
"""Sine of the angle below which two walls, or a wall and the line that two others leave, are parallel [1]."""


class Velocity(NamedTuple):
    """The tip's velocity [m/s], and how far it is from what was wanted, inf where there is none."""

    x: float
    y: float
    z: float
    off: float


@law
def slide(touches: Array, x: float, y: float, z: float, wanted: Twist) -> Twist:
    """The twist of the tip that is nearest to the one wanted and takes no touching point into its wall.

    Args:
        touches: (k, 7) contacts, in L.
        x: the tip's place, with y and z [m].
        y: see x.
        z: see x.
        wanted: twist of the tip, in L.

    Returns:
        The twist: as wanted where nothing is in its way; else its turning with the nearest velocity that makes room for
        it; else the nearest velocity without turning; else zero, as with walls all round, or where points that have to
        come out cannot.
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
    """Add a wall that the tip has to leave with at least some speed [m/s], or make that of one like it greater."""
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
    """The velocity nearest to (x, y, z) that leaves every wall with at least its speed.

    It lies where one, two or three walls are left at just their speed, or none is: all of these are tried, and each
    is looked at with every wall.
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
            # along wall i, square to the line that the two leave
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
    """The velocity v if it is nearer to (x, y, z) than the best so far and leaves every wall fast enough."""
    dx, dy, dz = vx - x, vy - y, vz - z
    off = sqrt(dx * dx + dy * dy + dz * dz)
    if off >= best.off:
        return best
    for i in range(len(walls)):
        if walls[i, 0] * vx + walls[i, 1] * vy + walls[i, 2] * vz < least[i] - SLACK:
            return best
    return Velocity(vx, vy, vz, off)
