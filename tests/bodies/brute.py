"""The clearance of two hexahedra by exhaustive computation, independent of the laws."""

from __future__ import annotations

import numpy as np
from scipy.spatial import ConvexHull

from aftdeck.arrays import Array
from tests.bodies.shapes import EDGES, FACES, normals


def clearance(a: Array, b: Array) -> float:
    """Return the signed clearance of bodies (8, 3) [m].

    The Minkowski difference is the hull of 64 points. If it contains the origin, the penetration depth is the
    distance to its nearest face. If not, the clearance is the minimum over all 144 pairs of edges and all 96 pairs of
    a vertex and a face.
    """
    hull = ConvexHull((a[:, None] - b[None]).reshape(64, 3))
    reach = float(hull.equations[:, 3].max())
    if reach <= 0.0:
        return reach
    return min(_edges(a, b), _vertices(a, b), _vertices(b, a))


def _edges(a: Array, b: Array) -> float:
    """Return the minimum distance between an edge of `a` and an edge of `b`.

    Either both closest points are between the ends of their edges, or at least one of them is an end.
    """
    p, q = (a[ends] for ends in np.repeat(EDGES, 12, axis=0).T)
    r, s = (b[ends] for ends in np.tile(EDGES, (12, 1)).T)
    least = min(_to_segments(r, p, q), _to_segments(s, p, q), _to_segments(p, r, s), _to_segments(q, r, s))
    n = np.cross(q - p, s - r)
    size = np.linalg.norm(n, axis=1)
    crossed = size > 1e-9 * np.linalg.norm(q - p, axis=1) * np.linalg.norm(s - r, axis=1)
    p, q, r, s, n = p[crossed], q[crossed], r[crossed], s[crossed], n[crossed] / size[crossed, None]
    t = _dot(np.cross(r - p, s - r), n) / _dot(np.cross(q - p, s - r), n)
    u = _dot(np.cross(r - p, q - p), n) / _dot(np.cross(q - p, s - r), n)
    inside = (t >= 0.0) & (t <= 1.0) & (u >= 0.0) & (u <= 1.0)
    return min(least, float(np.abs(_dot(r - p, n))[inside].min(initial=np.inf)))


def _to_segments(points: Array, p: Array, q: Array) -> float:
    t = np.clip(_dot(points - p, q - p) / _dot(q - p, q - p), 0.0, 1.0)
    return float(np.linalg.norm(points - p - t[:, None] * (q - p), axis=1).min())


def _vertices(points: Array, body: Array) -> float:
    """Return the minimum distance from a point to a face. A face counts only if the point projects onto it."""
    least = np.inf
    for normal, rim in zip(normals(body[None])[0], body[FACES], strict=True):
        height = (points - rim[0]) @ normal
        inward = np.cross(normal, np.roll(rim, -1, axis=0) - rim)
        over = ((points[:, None] - rim[None]) * inward).sum(axis=2).min(axis=1) >= 0.0
        least = min(least, float(height[over & (height >= 0.0)].min(initial=np.inf)))
    return least


def _dot(a: Array, b: Array) -> Array:
    return np.asarray((a * b).sum(axis=-1))
