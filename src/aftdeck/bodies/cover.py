"""Hexahedra that cover curved bodies from outside. The clearance of a covered body is therefore never overstated.

The docstring of each function states the greatest distance by which its hexahedra extend beyond the body. The body's
clearance is understated by at most that distance. The clearance of several hexahedra is the least of their
clearances. If the clearance is negative, its magnitude is the length of the shortest move out of one hexahedron. That
move can be shorter than the shortest move that leads out of every hexahedron.
"""

from __future__ import annotations

from math import inf, pi, tau
from typing import Literal

import numpy as np

from aftdeck.arrays import Array
from aftdeck.elementary import sincos
from aftdeck.errors import InputError

Axis = Literal["x", "y", "z"]

FEWEST_WALLS = 8
"""Least number of hexahedra of a tube's wall. Eight hexahedra for the bay's half tube, with a radius of 2.31 m, extend
into the tube by 0.044 m."""
SIDES = 12
"""Default number of sides of a prism around a circle. The prism's edges are then outside the circle by 3.5 % of the
radius."""
FEWEST_SIDES = 4


def tube_wall(
    radius: float,
    thickness: float,
    length: float,
    *,
    radius_end: float | None = None,
    axis: Axis = "x",
    start: float = 0.0,
    sweep: float = tau,
    count: int = FEWEST_WALLS,
) -> Array:
    """Return hexahedra that cover the wall of a tube or truncated cone.

    The tube's centre is the origin; the angles are those of a `shapes.Shell`. Let h = sweep / (2 count), and R the
    greater of the two radii. The hexahedra extend into the tube by at most (R - thickness) (1 - cos h), and out of it
    by at most R (1 / cos h - 1). Each hexahedron has its own axes: x along the tube's axis, y against the sweep, z
    outwards. Face c therefore faces inwards.

    Args:
        radius: outer radius at the end with the lesser coordinate along the axis [m].
        thickness: thickness of the wall, less than both radii [m].
        length: length along the axis [m].
        radius_end: outer radius at the other end [m]; None if it equals `radius`.
        axis: axis of the tube.
        start: angle at which the wall begins [rad]: from y to z about x, from z to x about y, from x to y about z.
        sweep: angle that the wall spans [rad].
        count: number of hexahedra, at least 8.

    Returns:
        (count, 8, 3) vertices [m].

    Raises:
        InputError: the sizes do not define a tube, or there are too few hexahedra.
    """
    end = radius if radius_end is None else radius_end
    _above_zero(radius=radius, radius_end=end, thickness=thickness, length=length, sweep=sweep)
    if not thickness < min(radius, end):
        raise InputError(f"the wall's thickness is {thickness:g} m; it has to be less than its radius")
    if not sweep <= tau * 1.001:
        raise InputError(f"the wall's sweep is {sweep:g}; it has to be at most 2 pi")
    if not abs(start) < inf:
        raise InputError(f"the wall's start is {start:g}; it has to be finite")
    if not float(count).is_integer() or count < FEWEST_WALLS:
        raise InputError(f"the wall's count is {count}; it has to be a whole number, at least {FEWEST_WALLS}")
    half = sweep / (2 * count)
    walls = np.empty((count, 8, 3))
    for k in range(count):
        for v in range(8):
            away = start + 2.0 * half * (k if v & 4 else k + 1)
            outer = end if v & 2 else radius
            r = outer / sincos(half)[1] if v & 1 else outer - thickness
            s, c = sincos(away)
            walls[k, v] = length * (0.5 if v & 2 else -0.5), r * c, r * s
    return _along(walls, axis)


def prism(
    radius: float,
    length: float,
    *,
    radius_end: float | None = None,
    axis: Axis = "x",
    sides: int = SIDES,
    turn: float = 0.0,
) -> Array:
    """Return a regular prism that encloses a cylinder or truncated cone, cut into sides/2 - 1 hexahedra.

    The prism's centre is the origin. At each end, its edges are outside the circle by the circle's radius times
    (1 / cos(pi / sides) - 1). The cuts are parallel.

    Args:
        radius: radius of the circle at the end with the lesser coordinate along the axis [m]. At this end, it is also
            the distance of each side from the axis.
        length: length along the axis [m].
        radius_end: radius of the circle at the other end [m]; None if it equals `radius`.
        axis: axis of the prism.
        sides: number of sides, even and at least 4.
        turn: angle of the middle of a side [rad], counted as in `tube_wall`.

    Returns:
        (sides/2 - 1, 8, 3) vertices [m].

    Raises:
        InputError: the sizes do not define a prism, or the number of sides is odd or too small.
    """
    end = radius if radius_end is None else radius_end
    _above_zero(radius=radius, radius_end=end, length=length)
    if not float(sides).is_integer() or sides < FEWEST_SIDES or sides % 2:
        raise InputError(f"the prism has {sides} sides; it has to be an even number, at least {FEWEST_SIDES}")
    if not abs(turn) < inf:
        raise InputError(f"the prism's turn is {turn:g}; it has to be finite")
    half = pi / sides
    slices = np.empty((sides // 2 - 1, 8, 3))
    for k in range(len(slices)):
        for v in range(8):
            away = half * (2 * (k if v & 4 else k + 1) + 1) * (1.0 if v & 1 else -1.0)
            r = (end if v & 2 else radius) / sincos(half)[1]
            s, c = sincos(turn + away)
            slices[k, v] = length * (0.5 if v & 2 else -0.5), r * c, r * s
    return _along(slices, axis)


def _along(bodies: Array, axis: Axis) -> Array:
    """Rotate bodies from the x axis to `axis`."""
    if axis not in ("x", "y", "z"):
        raise InputError(f"the axis is {axis!r}; it has to be x, y or z")
    return np.roll(bodies, "xyz".index(axis), axis=-1)


def _above_zero(**sizes: float) -> None:
    for name, size in sizes.items():
        if not 0.0 < size < inf:
            raise InputError(f"the {name} is {size:g}; it has to be above 0")
