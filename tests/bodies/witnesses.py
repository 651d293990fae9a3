"""Checks of the witnesses in a packed pair: planes, features and closest points."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import NX
from aftdeck.bodies.pair import CLEARANCE, CONTACT, DISTANCE, FEATURE_A, FEATURE_B, NORMAL, POINT_A, POINT_B, WHOLE
from tests.bodies.shapes import EDGES, FACES, normals

Bools = NDArray[np.bool_]

ROUNDING = 1e-12
"""Allowed error of a clearance [m]."""


def vertices(packed: Array) -> Array:
    """Return the vertices (n, 8, 3) of packed bodies (n, 48)."""
    return packed[:, :NX].reshape(-1, 3, 8).transpose(0, 2, 1)


def planes_hold(a: Array, b: Array, pairs: Array) -> Bools:
    """Return for each pair (n,) whether its plane separates `a` (n, 8, 3) from `b` by more than CONTACT."""
    normal = pairs[:, NORMAL : NORMAL + 3]
    reach = np.einsum("nvk,nk->nv", a, normal).max(axis=1)
    begin = np.einsum("nvk,nk->nv", b, normal).min(axis=1)
    unit = np.abs(np.linalg.norm(normal, axis=1) - 1.0) <= 1e-14
    distance = pairs[:, DISTANCE]
    return np.asarray(unit & (reach < distance) & (distance < begin) & (begin - reach > CONTACT))


def features_penetrate(a: Array, b: Array, pairs: Array) -> Bools:
    """Return for each pair (n,) whether its features are a vertex inside the other body, or an edge through a face."""
    of_a, of_b = pairs[:, FEATURE_A].astype(int), pairs[:, FEATURE_B].astype(int)
    return np.asarray(_enters(a, b, of_a, of_b) | _enters(b, a, of_b, of_a))


def _enters(a: Array, b: Array, of_a: NDArray[np.int64], of_b: NDArray[np.int64]) -> Bools:
    above = _heights(a, b)
    inside = above.max(axis=2) <= ROUNDING
    vertex = (of_b == WHOLE)[:, None] & (of_a[:, None] == 1 << np.arange(8)) & inside
    found = vertex.any(axis=1)
    for i, j in EDGES:
        start, end = above[:, i], above[:, j]
        with np.errstate(divide="ignore", invalid="ignore"):
            crossing = start / (start - end)
        enters = np.where((start > 0.0) & (end <= 0.0), crossing, np.where(start > 0.0, np.inf, 0.0))
        leaves = np.where((start <= 0.0) & (end > 0.0), crossing, 1.0)
        passes = enters.max(axis=1) <= leaves.min(axis=1) + ROUNDING
        face = np.array([(1 << rim).sum() for rim in FACES])[enters.argmax(axis=1)]
        back = np.array([(1 << rim).sum() for rim in FACES])[leaves.argmin(axis=1)]
        found |= passes & (of_a == 1 << i | 1 << j) & ((of_b == face) | (of_b == back))
    return np.asarray(found)


def points_hold(a: Array, b: Array, pairs: Array) -> Bools:
    """Return for each pair (n,) whether its closest points are in `a` and `b`, and |clearance| is their distance."""
    p, q = pairs[:, POINT_A : POINT_A + 3], pairs[:, POINT_B : POINT_B + 3]
    apart = np.abs(np.linalg.norm(p - q, axis=1) - np.abs(pairs[:, CLEARANCE])) <= ROUNDING
    on_a = _heights(p[:, None], a).max(axis=(1, 2)) <= ROUNDING
    on_b = _heights(q[:, None], b).max(axis=(1, 2)) <= ROUNDING
    return np.asarray(apart & on_a & on_b)


def _heights(points: Array, bodies: Array) -> Array:
    """Return the heights (n, m, 6) of points (n, m, 3) over the faces of bodies (n, 8, 3) [m]."""
    outward, first = normals(bodies), bodies[:, FACES[:, 0]]
    return np.asarray(np.einsum("nmk,nfk->nmf", points, outward) - np.einsum("nfk,nfk->nf", first, outward)[:, None])
