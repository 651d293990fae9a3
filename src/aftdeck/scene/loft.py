"""Skin over cross-sections, closed at both ends, as triangles."""

from __future__ import annotations

import functools
from decimal import Context, Decimal

import numpy as np

from aftdeck.arrays import Array
from aftdeck.matrices import sines
from aftdeck.scene.mesh import Mesh, mesh
from aftdeck.shapes import Loft, Section


def loft(shape: Loft, points: int) -> Mesh:
    """Return the mesh of a loft in the loft's own frame, with `points` points around each section."""
    vertices = np.concatenate([ring(section, points) for section in shape.sections])
    last = len(vertices) - points
    faces: list[tuple[int, int, int]] = []
    for first in range(0, last, points):
        for k in range(points):
            a, b = first + k, first + (k + 1) % points
            faces += [(a, b, a + points), (a + points, b, b + points)]
    for k in range(2, points):
        faces += [(0, k, k - 1), (last, last + k - 1, last + k)]
    return mesh(vertices, faces)


def ring(section: Section, points: int) -> Array:
    """Return the points (points, 3) of a section, in this order: lowest point, starboard side, top, port side."""
    angles = 2.0 * np.pi * np.arange(points) / points - np.pi / 2.0
    s, c = (np.where(np.abs(x) < 1e-12, 0.0, x) for x in sines(angles))
    upper, lower = section.exponents
    power = np.where(s > 0.0, 2.0 / upper, 2.0 / lower)
    height = np.where(s > 0.0, section.top - section.middle, section.middle - section.bottom)
    y = section.half_width * np.sign(c) * _powers(np.abs(c), power)
    z = section.middle + height * np.sign(s) * _powers(np.abs(s), power)
    return np.stack([np.full(points, section.x), y, z], axis=1)


def _powers(bases: Array, exponents: Array) -> Array:
    return np.array([_power(base, exponent) for base, exponent in zip(bases.tolist(), exponents.tolist(), strict=True)])


@functools.cache
def _power(base: float, exponent: float) -> float:
    """Return a power of a number in [0, 1], with the same digits on every machine; every section needs the same few."""
    return float(Context(prec=30).power(Decimal(base), Decimal(exponent))) if base else 0.0
