"""Surfaces of revolution of a profile about an axis: cylinders, shells, rings, spheres, a lamp's face."""

from __future__ import annotations

import math

import numpy as np

from aftdeck.arrays import Array
from aftdeck.matrices import sines
from aftdeck.scene.mesh import Mesh, mesh
from aftdeck.shapes import Axis, Vec2

ON_AXIS = 1e-9
"""Distance from the axis below which a point of a profile counts as on the axis [m]."""
FULL = math.tau - 1e-3
"""Least sweep that counts as a full turn [rad]."""
_ORDER: dict[Axis, tuple[int, int, int]] = {"x": (0, 1, 2), "y": (2, 0, 1), "z": (1, 2, 0)}
"""For each axis, the columns that hold x, y and z. The columns are the coordinates along the axis, in the first
direction and in the second direction. Angles run from the first direction to the second: from y to z about x, from z to
x about y, from x to y about z."""


def revolve(
    profile: list[Vec2],
    axis: Axis,
    segments: int,
    start: float = 0.0,
    sweep: float = math.tau,
    *,
    closed: bool = False,
) -> Mesh:
    """Return the surface swept by a profile.

    A closed profile, or one that begins and ends on the axis, gives a closed surface.

    Args:
        profile: points (coordinate along the axis, distance from the axis) [m]. In a drawing with
            the axis to the right and the distance upwards, the outside is to the left of the path from point to point.
        axis: axis of revolution.
        segments: number of segments of the sweep.
        start: angle at which the sweep begins [rad].
        sweep: angle of the sweep [rad].
        closed: whether the last point is joined to the first.
    """
    whole = sweep >= FULL
    columns = segments if whole else segments + 1
    angles = start + (math.tau if whole else sweep) * np.arange(columns) / segments
    vertices: list[Array] = []
    rows: list[list[int]] = []
    count = 0
    for along, away in profile:
        single = abs(away) < ON_AXIS
        turned = angles[:1] if single else angles
        radius = 0.0 if single else away
        sine, cosine = sines(turned)
        flat = np.stack([np.full(len(turned), along), radius * cosine, radius * sine], axis=1)
        vertices.append(flat[:, _ORDER[axis]])
        rows.append([count] * columns if single else list(range(count, count + columns)))
        count += len(turned)
    faces: list[tuple[int, int, int]] = []
    after = [*rows[1:], rows[0]] if closed else rows[1:]
    for row, following in zip(rows, after, strict=False):
        for k in range(segments):
            n = (k + 1) % columns
            faces += [(row[k], row[n], following[k]), (following[k], row[n], following[n])]
    if not whole:
        for i in range(2, len(rows)):
            (a, b, c), (d, e, f) = ((rows[0][k], rows[i - 1][k], rows[i][k]) for k in (0, -1))
            faces += [(a, b, c), (d, f, e)]
    return mesh(np.concatenate(vertices), faces)
