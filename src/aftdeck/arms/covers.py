"""Hexahedra of the covers that a file lists. Their coordinates are in the frame of the covered body."""

from __future__ import annotations

import numpy as np

from aftdeck.arms.model import BoxCover, Cover
from aftdeck.arrays import Array
from aftdeck.bodies.cover import prism
from aftdeck.bodies.hexahedron_check import hexahedron
from aftdeck.errors import InputError
from aftdeck.frames import endori
from aftdeck.matrices import product


def hexahedra(cover: Cover, part: str) -> Array:
    """Return the vertices (n, 8, 3) [m] of a part's cover, with its rotation and position applied.

    Raises:
        InputError: the cover's sizes are invalid.
    """
    if isinstance(cover, BoxCover):
        found = corners((-0.5, -0.5, -0.5), (0.5, 0.5, 0.5))[None] * cover.size
    else:
        found = prism(cover.radius, cover.length, axis=cover.axis, sides=cover.sides)
    for vertices in found:
        hexahedron(vertices, part)
    return np.asarray(product(found, endori(*cover.rotation).T) + cover.position)


def cover_problem(cover: Cover, part: str) -> str:
    """Return the error message about a cover's sizes, or an empty string if the sizes are valid."""
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
    """
    ends = (low, high)
    vertices = np.empty((8, 3))
    for v in range(8):
        for axis, far in zip(axes, (v >> 1 & 1, v >> 2 & 1, v & 1), strict=True):
            k = abs(axis) - 1
            vertices[v, k] = ends[far if axis > 0 else 1 - far][k]
    return vertices
