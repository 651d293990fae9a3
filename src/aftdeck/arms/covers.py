"""Hexahedra of the covers and blocks that a file lists. Their coordinates are in the frame of the body."""

from __future__ import annotations

import numpy as np

from aftdeck.arms.body_file import BlockBody, BoxCover, Cover
from aftdeck.arrays import Array
from aftdeck.bodies.cover import prism
from aftdeck.bodies.hexahedron_check import hexahedra as checked
from aftdeck.errors import InputError
from aftdeck.frames import endori
from aftdeck.matrices import product


def hexahedra(cover: Cover | BlockBody, part: str) -> Array:
    """Return the vertices (n, 8, 3) [m] of a part's cover, with its rotation and position applied, or of a block.

    Raises:
        InputError: the sizes are invalid.
    """
    if isinstance(cover, BlockBody):
        found = corners(cover.low, cover.high, cover.axes)[None]
        checked(found, [part])
        return found
    if isinstance(cover, BoxCover):
        found = corners((-0.5, -0.5, -0.5), (0.5, 0.5, 0.5))[None] * cover.size
    else:
        found = prism(cover.radius, cover.length, axis=cover.axis, sides=cover.sides)
    checked(found, [part] * len(found))
    return np.asarray(product(found, endori(*cover.rotation).T) + cover.position)


def cover_problem(cover: Cover | BlockBody, part: str) -> str:
    """Return the error message about the sizes of a cover or block, or an empty string if the sizes are valid."""
    try:
        hexahedra(cover, part)
    except InputError as error:
        return str(error)
    return ""


def corners(
    low: tuple[float, float, float], high: tuple[float, float, float], axes: tuple[int, int, int] = (1, 2, 3)
) -> Array:
    """Return the vertices (8, 3) [m] of a box from its least and greatest coordinates.

    Args:
        low: least x, y, z [m].
        high: greatest x, y, z [m].
        axes: for each of the box's own axes x, y and z, the number (1 to 3) of the parallel coordinate axis; negative
            if the two directions are opposite. The box's own axes define the numbers of its vertices.

    Raises:
        InputError: two of the axes are parallel.
    """
    if sorted(map(abs, axes)) != [1, 2, 3]:
        raise InputError(f"expected the numbers 1, 2 and 3 as axes, each with or without a sign; got {axes}")
    ends = (low, high)
    vertices = np.empty((8, 3))
    for v in range(8):
        for axis, far in zip(axes, (v >> 1 & 1, v >> 2 & 1, v & 1), strict=True):
            k = abs(axis) - 1
            vertices[v, k] = ends[far if axis > 0 else 1 - far][k]
    return vertices
