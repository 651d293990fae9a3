"""Random hexahedra, and pairs of hexahedra near contact. The clearance of most pairs is known from their placement."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from aftdeck.arrays import Array

Ints = NDArray[np.int64]

CUBE = np.array([(x, y, z) for y in (-1, 1) for x in (-1, 1) for z in (-1, 1)]) / 2.0
"""(8, 3) unit cube about the origin, vertices 1 to 8."""
FACES = np.array([(1, 2, 6, 5), (1, 3, 4, 2), (1, 5, 7, 3), (2, 4, 8, 6), (5, 6, 8, 7), (3, 7, 8, 4)]) - 1
"""(6, 4) vertices of faces a to f, counterclockwise seen from outside."""
EDGES = (
    np.array(
        [(1, 2), (3, 4), (5, 6), (7, 8), (1, 3), (2, 4), (5, 7), (6, 8), (1, 5), (2, 6), (3, 7), (4, 8)],
    )
    - 1
)


def moved(body: Array, x: float, y: float, z: float) -> Array:
    """Return a body (8, 3) moved by (x, y, z) [m]."""
    return np.asarray(body + np.array([x, y, z]))


def boxes(rng: np.random.Generator, count: int) -> Array:
    """Return random boxes (count, 8, 3) with edges of 0.05 to 2 m."""
    return CUBE * np.exp(rng.uniform(np.log(0.05), np.log(2.0), (count, 1, 3)))


def skewed(rng: np.random.Generator, count: int) -> Array:
    """Return random hexahedra (count, 8, 3): boxes whose faces are tilted independently."""
    normals = np.zeros((count, 6, 3))
    for face, (axis, sign) in enumerate([(0, -1), (1, -1), (2, -1), (2, 1), (1, 1), (0, 1)]):
        normals[:, face] = rng.uniform(-0.25, 0.25, (count, 3))
        normals[:, face, axis] = sign
    vertices = np.empty((count, 8, 3))
    for v, (x, y, z) in enumerate(CUBE > 0.0):
        three = [5 if x else 0, 4 if y else 1, 3 if z else 2]
        vertices[:, v] = np.linalg.solve(normals[:, three], np.ones((count, 3, 1)))[..., 0]
    return vertices * np.exp(rng.uniform(np.log(0.05), np.log(2.0), (count, 1, 3))) / 2.0


def rotations(rng: np.random.Generator, count: int) -> Array:
    """Return random rotations (count, 3, 3)."""
    w, x, y, z = (q := rng.normal(size=(4, count))) / np.linalg.norm(q, axis=0)
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), 2, 0)


def normals(bodies: Array) -> Array:
    """Return the outward unit normals (n, 6, 3) of bodies (n, 8, 3)."""
    p, q, r, s = np.moveaxis(bodies[:, FACES], 2, 0)
    found = np.cross(r - p, s - q)
    return np.asarray(found / np.linalg.norm(found, axis=2, keepdims=True))


class Placing(NamedTuple):
    """Translations (n, 3) [m] of the second bodies, and the resulting clearances (n,) [m]; NaN if unknown."""

    shift: Array
    clearance: Array


def near_contact(rng: np.random.Generator, a: Array, b: Array) -> Placing:
    """Return translations that move each body of `b` (n, 8, 3) near the body of `a` with the same index.

    An eighth of the positions are random. At the others, the body of `b` is 1e-10 to 0.3 m outside or inside the body
    of `a`, and the closest features are two vertices, a vertex and a face, or two edges. If the bodies do not
    overlap, their closest points are on two parallel planes that separate the bodies. The clearance is then the
    distance between the closest points.
    """
    n, rows = len(a), np.arange(len(a))
    kind = rng.integers(8, size=n)
    face, edge_a, edge_b = rng.integers(6, size=n), rng.integers(12, size=n), rng.integers(12, size=n)
    along_a = a[rows, EDGES[edge_a, 1]] - a[rows, EDGES[edge_a, 0]]
    along_b = b[rows, EDGES[edge_b, 1]] - b[rows, EDGES[edge_b, 0]]
    square = np.cross(along_a, along_b)
    middle = a[rows[:, None], EDGES[edge_a]].mean(axis=1) - a.mean(axis=1)
    square *= np.where((square * middle).sum(axis=1) < 0.0, -1.0, 1.0)[:, None]
    choices = [rng.normal(size=(n, 3)), normals(a)[rows, face], -normals(b)[rows, face], square]
    direction = np.choose(np.minimum(kind // 2, 3)[:, None], choices)
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    start = _support(rng, a, direction)
    end = _support(rng, b, -direction)
    gap = 10.0 ** rng.uniform(-10.0, -0.5, n) * rng.choice([1.0, -1.0], n)
    shift = start + gap[:, None] * direction - end
    anywhere = rng.random(n) < 0.125
    shift[anywhere] = rng.normal(size=(n, 3))[anywhere]
    return Placing(shift, np.where(anywhere | (gap < 0.0), np.nan, gap))


def _support(rng: np.random.Generator, bodies: Array, direction: Array) -> Array:
    """Return a random point (n, 3) of each body's feature that is farthest along a direction (n, 3)."""
    height = np.einsum("nvk,nk->nv", bodies, direction)
    share = rng.random(height.shape) * (height >= height.max(axis=1, keepdims=True) - 1e-12)
    return np.asarray(np.einsum("nv,nvk->nk", share / share.sum(axis=1, keepdims=True), bodies))
