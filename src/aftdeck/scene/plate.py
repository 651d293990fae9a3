"""A flat outline with thickness and rounded rims, as triangles."""

from __future__ import annotations

import math

import numpy as np

from aftdeck.elementary import sincos
from aftdeck.scene.mesh import Mesh, mesh
from aftdeck.scene.polygon import inwards, signed_area, triangles
from aftdeck.shapes import Axis, Plate, Vec2

RIM_STEPS = 2
"""Number of straight steps that approximate the quarter circle of a rim, as on the page."""
_AXIS_ORDER: dict[Axis, tuple[tuple[int, int, int], bool]] = {
    "x": ((2, 0, 1), False),
    "y": ((0, 2, 1), True),
    "z": ((0, 1, 2), False),
}
"""For each normal, the columns that hold x, y and z, and whether this order is a reflection. The columns are the first
and the second coordinate of the outline, and the coordinate across the plate."""


def plate(shape: Plate) -> Mesh:
    """Return the mesh of a plate about its own origin."""
    outline = shape.outline if signed_area(shape.outline) > 0.0 else shape.outline[::-1]
    corners, directions = np.array(outline), inwards(outline)
    levels = _levels(shape)
    layers = [np.column_stack([corners + inset * directions, np.full(len(outline), z)]) for inset, z in levels]
    order, reflected = _AXIS_ORDER[shape.normal]
    vertices = np.concatenate(layers)[:, order]
    n, top = len(outline), (len(levels) - 1) * len(outline)
    fill = triangles(outline)
    faces = [(c, b, a) for a, b, c in fill] + [(top + a, top + b, top + c) for a, b, c in fill]
    for first in range(0, top, n):
        for k in range(n):
            a, b = first + k, first + (k + 1) % n
            faces += [(a, b, b + n), (a, b + n, a + n)]
    return mesh(vertices, [(c, b, a) for a, b, c in faces] if reflected else faces)


def _levels(shape: Plate) -> list[Vec2]:
    """Return the levels, each (distance inside the outline, height across) [m], from the lower face to the upper."""
    half, bevel = shape.thickness / 2.0, shape.bevel
    if bevel == 0.0:
        return [(0.0, -half), (0.0, half)]
    turns = [math.pi / 2.0 * k / RIM_STEPS for k in range(RIM_STEPS + 1)]
    rim = [(bevel * (1.0 - s), half - bevel * (1.0 - c)) for s, c in map(sincos, turns)]
    lower = [(inset, -z) for inset, z in rim]
    upper = rim[::-1] if half > bevel else rim[-2::-1]
    return lower + upper
