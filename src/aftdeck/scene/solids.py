"""Triangle meshes of shapes, each in the shape's own frame.

The page has its own numbers of sides (`web/src/scene/shapes.ts`).
"""

from __future__ import annotations

import math
from itertools import product
from typing import assert_never

import numpy as np

from aftdeck.arrays import Array
from aftdeck.elementary import sincos
from aftdeck.scene.loft import loft
from aftdeck.scene.mesh import Mesh, mesh
from aftdeck.scene.placed import Leaf
from aftdeck.scene.plate import plate
from aftdeck.scene.revolve import revolve
from aftdeck.shapes import Box, Cylinder, Hexahedron, Light, Loft, Plate, Ring, Shell, Sphere, Vec2

SIDES = 16
"""Default number of sides of a round body."""
LARGE = 1.0
"""Least radius at which the number of sides of a round body is doubled [m]."""
FEWEST_PIECES = 4
"""Least number of sides of a round body that is swept through only a part of a circle."""
RIMS = ((0, 1, 5, 4), (0, 2, 3, 1), (0, 4, 6, 2), (1, 3, 7, 5), (4, 5, 7, 6), (2, 6, 7, 3))
"""Vertices of a hexahedron's faces a to f, numbered from zero, counter-clockwise as seen from outside."""


def solid(shape: Leaf, sides: int = SIDES) -> Mesh:
    """Return a shape's surface, closed except for a lamp's face.

    Args:
        shape: shape to draw. Its position and rotation are not applied here, but in `scene.placed`.
        sides: number of sides of a small round body, 8 or more. With more sides, the surface is closer to the shape.
    """
    match shape:
        case Box():
            return _box(shape)
        case Cylinder():
            half, end = shape.length / 2.0, shape.radius if shape.radius_end is None else shape.radius_end
            profile = [(-half, 0.0), (-half, shape.radius), (half, end), (half, 0.0)]
            return revolve(profile, shape.axis, _round(max(shape.radius, end), sides))
        case Shell():
            return _shell(shape, sides)
        case Ring():
            bar = [math.tau * k / max(6, sides // 4) for k in range(max(6, sides // 4))]
            profile = [(shape.bar * s, shape.radius + shape.bar * c) for s, c in map(sincos, bar)]
            pieces = _part(shape.sweep, shape.radius, sides)
            return revolve(profile, shape.axis, pieces, shape.start, shape.sweep, closed=True)
        case Sphere():
            around = _round(shape.radius, sides)
            arc = [math.pi * k / (around // 2) for k in range(around // 2 + 1)]
            profile = [(-shape.radius * c, shape.radius * s) for s, c in map(sincos, arc)]
            return revolve(profile, "x", around)
        case Plate():
            return plate(shape)
        case Loft():
            return loft(shape, 2 * sides)
        case Hexahedron():
            return _faced(np.array(shape.vertices))
        case Light():
            return revolve([(0.0, shape.radius), (0.0, 0.0)], "x", _round(shape.radius, sides))
        case _:
            assert_never(shape)


def _box(shape: Box) -> Mesh:
    y, x, z = np.array(list(product((-0.5, 0.5), repeat=3))).T
    return _faced(np.column_stack([x, y, z]) * shape.size)


def _faced(vertices: Array) -> Mesh:
    """Return a hexahedron's faces a to f as two triangles each."""
    return mesh(vertices, [face for a, b, c, d in RIMS for face in ((a, b, c), (a, c, d))])


def _shell(shape: Shell, sides: int) -> Mesh:
    half, end = shape.length / 2.0, shape.radius if shape.radius_end is None else shape.radius_end
    profile: list[Vec2] = [
        (-half, shape.radius),
        (half, end),
        (half, end - shape.thickness),
        (-half, shape.radius - shape.thickness),
    ]
    pieces = _part(shape.sweep, max(shape.radius, end), sides)
    return revolve(profile, shape.axis, pieces, shape.start, shape.sweep, closed=True)


def _round(radius: float, sides: int) -> int:
    """Return the number of flat sides of a complete round body."""
    return sides if radius < LARGE else 2 * sides


def _part(sweep: float, radius: float, sides: int) -> int:
    """Return the number of flat sides of a round body that is swept through only a part of a circle."""
    return max(FEWEST_PIECES, math.ceil(_round(radius, sides) * min(sweep / math.tau, 1.0)))
