"""Penetration depth of convex hexahedra.

It is computed in plain NumPy, because checks of files must not wait for compilation.

Method: the theorem of separating axes over all face normals and all pairs of edges. Compiled code uses
`bodies.pair_check`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import CORNERS, ENDS

_SHORT = 1e-12
"""Limit [1]: two edges count as parallel if the squared length of their unit vectors' cross product is at most this."""


def overlap(a: Array, b: Array) -> float:
    """Return the length of the shortest move that separates two hexahedra (8, 3) [m]; 0 if they do not overlap."""
    normals = np.concatenate([_normals(a), _normals(b)])
    if (depth := _least_overlap(normals, a, b)) <= 0.0:
        return 0.0
    crossed = np.cross(_edges(a)[:, None], _edges(b)[None]).reshape(-1, 3)
    size = (crossed**2).sum(axis=1)
    not_parallel = size > _SHORT
    return max(0.0, min(depth, _least_overlap(crossed[not_parallel] / np.sqrt(size[not_parallel])[:, None], a, b)))


def deepest(some: Sequence[Array], others: Sequence[Array]) -> float:
    """Return the greatest penetration depth [m] of two bodies, one of `some` and one of `others`; 0 if none overlap."""
    return max((overlap(a, b) for a, b in _pairs_with_overlapping_boxes(some, others)), default=0.0)


def _pairs_with_overlapping_boxes(some: Sequence[Array], others: Sequence[Array]) -> Iterator[tuple[Array, Array]]:
    """Yield the pairs whose axis-aligned bounding boxes overlap."""
    if not len(some) or not len(others):
        return
    a, b = np.array(some), np.array(others)
    low, high = np.maximum(a.min(axis=1)[:, None], b.min(axis=1)), np.minimum(a.max(axis=1)[:, None], b.max(axis=1))
    for i, j in np.argwhere((low < high).all(axis=2)).tolist():
        yield a[i], b[j]


def _least_overlap(directions: Array, a: Array, b: Array) -> float:
    """Return the least overlap of two bodies along any of the unit directions (n, 3) [m].

    The overlap is negative along a direction that separates the bodies, and infinite if there are no directions.
    """
    if not len(directions):
        return np.inf
    along_a, along_b = directions @ a.T, directions @ b.T
    overlaps = np.minimum(along_a.max(axis=1) - along_b.min(axis=1), along_b.max(axis=1) - along_a.min(axis=1))
    return float(overlaps.min())


def _normals(body: Array) -> Array:
    """Return the (6, 3) unit normals of the faces; the normals of faces b, c and f point inwards."""
    corners = body[CORNERS]
    normals = np.cross(corners[:, 3] - corners[:, 0], corners[:, 2] - corners[:, 1])
    return np.asarray(normals / np.linalg.norm(normals, axis=1)[:, None])


def _edges(body: Array) -> Array:
    """Return (12, 3) unit vectors along the edges."""
    ends = body[ENDS]
    edges = ends[:, 1] - ends[:, 0]
    return np.asarray(edges / np.linalg.norm(edges, axis=1)[:, None])
