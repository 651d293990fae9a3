"""Curved bodies covered from outside by hexahedra, so that no clearance is ever overstated.

Each function says how far its hexahedra stand out beyond the body at most: by that much, and no more, a clearance from
the body may come out too small. The clearance of several hexahedra is the least of them. Where it is negative, it is
the shortest way out of one of them, which can be less than the way out of all.
"""

from __future__ import annotations

from math import cos, inf, pi, sin, tau
from typing import Literal

import numpy as np

from aftdeck.arrays import Array
from aftdeck.errors import InputError

Axis = Literal["x", "y", "z"]

FEWEST_WALLS = 8
"""Hexahedra of a tube's wall: of the bay's half tube, with 2.31 m inside, they stand 0.044 m into the bay."""
SIDES = 12
"""Of a prism round a circle: it stands out by 3.5 % of the radius."""
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
    """Hexahedra round the wall of a tube or a truncated cone about its centre, placed as a `shapes.Shell`.

    With h = sweep / (2 count), they stand into the tube by (radius - thickness) (1 - cos h) at most, and out of it by
    radius (1 / cos h - 1). Their axes are the tube's axis, against the turn, and outwards: face c looks inside.

    Args:
        radius: outer radius at the end of smaller axis coordinate [m].
        thickness: of the wall, less than the radius [m].
        length: along the axis [m].
        radius_end: outer radius at the other end [m]; as `radius` where not given.
        axis: which axis it lies along.
        start: where the wall begins [rad]; from y to z about x, from z to x about y, from x to y about z.
        sweep: how far it goes round [rad].
        count: how many hexahedra, at least 8.

    Returns:
        (count, 8, 3) vertices [m].

    Raises:
        InputError: sizes that make no tube, or too few hexahedra.
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
        raise InputError(f"the wall is to be {count} hexahedra; a whole number, {FEWEST_WALLS} or more, is allowed")
    half = sweep / (2 * count)
    walls = np.empty((count, 8, 3))
    for k in range(count):
        for v in range(8):
            away = start + 2.0 * half * (k if v & 4 else k + 1)
            outer = end if v & 2 else radius
            r = outer / cos(half) if v & 1 else outer - thickness
            walls[k, v] = length * (0.5 if v & 2 else -0.5), r * cos(away), r * sin(away)
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
    """A regular prism round a circle, or round a truncated cone, about its centre, cut into sides/2 - 1 hexahedra.

    It stands out of the circle by radius (1 / cos(pi / sides) - 1), at its edges. The cuts are parallel.

    Args:
        radius: of the circle, the distance of a side from the axis, at the end of smaller axis coordinate [m].
        length: along the axis [m].
        radius_end: of the circle at the other end [m]; as `radius` where not given.
        axis: which axis it lies along.
        sides: how many, an even number of at least 4.
        turn: where the middle of a side stands [rad]; angles as in `tube_wall`.

    Returns:
        (sides/2 - 1, 8, 3) vertices [m].

    Raises:
        InputError: sizes that make no prism, or an odd number of sides.
    """
    end = radius if radius_end is None else radius_end
    _above_zero(radius=radius, radius_end=end, length=length)
    if not float(sides).is_integer() or sides < FEWEST_SIDES or sides % 2:
        raise InputError(f"the prism has {sides} sides; an even number, {FEWEST_SIDES} or more, is allowed")
    if not abs(turn) < inf:
        raise InputError(f"the prism's turn is {turn:g}; it has to be finite")
    half = pi / sides
    slices = np.empty((sides // 2 - 1, 8, 3))
    for k in range(len(slices)):
        for v in range(8):
            away = half * (2 * (k if v & 4 else k + 1) + 1) * (1.0 if v & 1 else -1.0)
            r = (end if v & 2 else radius) / cos(half)
            slices[k, v] = length * (0.5 if v & 2 else -0.5), r * cos(turn + away), r * sin(turn + away)
    return _along(slices, axis)


def _along(bodies: Array, axis: Axis) -> Array:
    """Bodies made along x, along another axis."""
    if axis not in ("x", "y", "z"):
        raise InputError(f"the axis is {axis!r}; it has to be x, y or z")
    return np.roll(bodies, "xyz".index(axis), axis=-1)


def _above_zero(**sizes: float) -> None:
    for name, size in sizes.items():
        if not 0.0 < size < inf:
            raise InputError(f"the {name} is {size:g}; it has to be above 0")
