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

_THREE = (3, 3)
_SMALL = (_THREE, (3,))


def product(a: Array, b: Array) -> Array:
    """Return the matrix product of a (..., m) or (..., l, m) and b (m,) or (..., m, n), as `a @ b` does."""
    if b.shape == _THREE and a.shape in _SMALL:
        return _by_matrix(a, b)
    if a.shape == _THREE and b.shape == (3,):
        return _by_vector(a, b)
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


def _by_matrix(a: Array, b: Array) -> Array:
    """Return the product of a (3, 3) or (3,) and b (3, 3), in half the time that NumPy needs for nine numbers."""
    (x, y, z), (s, t, u), (v, w, o) = b.tolist()
    rows = a.tolist()
    if a.ndim == 1:
        c, d, e = rows
        return np.array((c * x + d * s + e * v, c * y + d * t + e * w, c * z + d * u + e * o))
    (c, d, e), (f, g, h), (i, j, k) = rows
    return np.array(
        (
            c * x + d * s + e * v, c * y + d * t + e * w, c * z + d * u + e * o,
            f * x + g * s + h * v, f * y + g * t + h * w, f * z + g * u + h * o,
            i * x + j * s + k * v, i * y + j * t + k * w, i * z + j * u + k * o,
        )
    ).reshape(3, 3)  # fmt: skip


def _by_vector(a: Array, b: Array) -> Array:
    """Return the product of a (3, 3) and b (3,)."""
    (p, q, r), (s, t, u), (v, w, o) = a.tolist()
    x, y, z = b.tolist()
    return np.array((p * x + q * y + r * z, s * x + t * y + u * z, v * x + w * y + o * z))


def dots(a: Array, b: Array) -> Array:
    """Return the dot products of vectors: of a (..., 3) and b (..., 3), which are broadcast against each other."""
    return np.asarray(a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1] + a[..., 2] * b[..., 2])


def cross(a: Array, b: Array) -> Array:
    """Return the cross products (..., 3) of vectors (..., 3), as NumPy's `cross` does in several times the time."""
    (x, y, z), (u, v, w) = np.moveaxis(a, -1, 0), np.moveaxis(b, -1, 0)
    return np.stack([y * w - z * v, z * u - x * w, x * v - y * u], axis=-1)


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
