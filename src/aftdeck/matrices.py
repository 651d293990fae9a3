"""Products and lengths of small arrays, with every sum in the order of the indices.

NumPy's `@`, `einsum` and `norm` use libraries that choose the order of a sum, and fused operations, by the processor;
`math.hypot` and `math.dist` depend on the version of Python. Every value on which a frame depends is therefore computed
by a law, or by these functions.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from aftdeck.arrays import Array
from aftdeck.elementary import sincos


def product(a: Array, b: Array) -> Array:
    """Return the matrix product of a (..., m) or (..., l, m) and b (m,) or (..., m, n), as `a @ b` does."""
    inner = range(1, a.shape[-1])
    if b.ndim == 1:
        terms = a * b
        total = terms[..., 0]
        for k in inner:
            total = total + terms[..., k]
        return np.asarray(total)
    terms = a[..., None] * (b if a.ndim == 1 else b[..., None, :, :])
    total = terms[..., 0, :]
    for k in inner:
        total = total + terms[..., k, :]
    return total


def dots(a: Array, b: Array) -> Array:
    """Return the dot products of vectors: of a (..., 3) and b (..., 3), which are broadcast against each other."""
    return np.asarray(a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1] + a[..., 2] * b[..., 2])


def lengths(vectors: Array) -> Array:
    """Return the lengths (...) of vectors (..., 3)."""
    return np.asarray(np.sqrt(dots(vectors, vectors)))


def reflects(rotation: Array) -> bool:
    """Return whether an orthonormal matrix (3, 3) contains a reflection: whether its determinant is negative."""
    return bool(dots(np.cross(rotation[0], rotation[1]), rotation[2]) < 0.0)


def sines(angles: Array) -> tuple[Array, Array]:
    """Return the sines and the cosines of angles (n,) [rad]."""
    s, c = np.array([sincos(angle) for angle in angles.tolist()]).reshape(-1, 2).T
    return s, c


def length(vector: Sequence[float]) -> float:
    """Return the length of a vector of any number of components."""
    square = 0.0
    for part in vector:
        square += part * part
    return math.sqrt(square)


def distance(a: Sequence[float], b: Sequence[float]) -> float:
    """Return the distance of two points with equal numbers of coordinates."""
    return length([p - q for p, q in zip(a, b, strict=True)])
