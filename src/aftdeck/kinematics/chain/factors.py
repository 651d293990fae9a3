"""Singular values of a Jacobian, by Jacobi's method with rotations of one side.

The method gives also small singular values with all their digits. Source: Demmel and Veselic, "Jacobi's method is more
accurate than QR", SIAM Journal on Matrix Analysis and Applications 13 (1992).
"""

from __future__ import annotations

from math import copysign, sqrt
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.law import law

ORTHOGONAL = 1e-15
"""Cosine of the angle between two columns below which they count as orthogonal [1]."""
SWEEPS = 40
"""Greatest number of sweeps over all pairs of columns; six to nine are usual."""


class Factors(NamedTuple):
    """Factors of a matrix A (6, n): A = left diag(values) right^T.

    Attributes:
        left: (6, k) orthonormal columns; k is the smaller of 6 and n. A column whose value is 0 can be 0.
        right: (n, k) as `left`.
        values: (k,) singular values, greatest first.
    """

    left: Array
    right: Array
    values: Array


@law
def factorise(matrix: Array) -> Factors:
    """Return the factors of a matrix (6, n), n at most 8."""
    rows, columns = matrix.shape
    wide = columns >= rows
    # the columns of `work` become orthogonal: those of A, or of its transpose, whichever are fewer
    work = np.empty((columns, rows) if wide else (rows, columns))
    for i in range(rows):
        for j in range(columns):
            if wide:
                work[j, i] = matrix[i, j]
            else:
                work[i, j] = matrix[i, j]
    count = work.shape[1]
    turns, values = np.zeros((count, count)), np.empty(count)
    for j in range(count):
        turns[j, j] = 1.0
    for _ in range(SWEEPS):
        if not _sweep(work, turns):
            break
    _sort(work, turns, values)
    for j in range(count):
        per = 1.0 / values[j] if values[j] > 0.0 else 0.0
        for i in range(work.shape[0]):
            work[i, j] *= per
    return Factors(turns, work, values) if wide else Factors(work, turns, values)


@law
def _sweep(work: Array, turns: Array) -> bool:
    """Make each pair of columns orthogonal once; return whether a pair was not."""
    turned = False
    for p in range(work.shape[1] - 1):
        for q in range(p + 1, work.shape[1]):
            a = b = dot = 0.0
            for i in range(work.shape[0]):
                a += work[i, p] * work[i, p]
                b += work[i, q] * work[i, q]
                dot += work[i, p] * work[i, q]
            if abs(dot) <= ORTHOGONAL * sqrt(a) * sqrt(b):
                continue
            turned = True
            half = (b - a) / (2.0 * dot)
            t = copysign(1.0, half) / (abs(half) + sqrt(1.0 + half * half))
            c = 1.0 / sqrt(1.0 + t * t)
            _turn(work, p, q, c, c * t)
            _turn(turns, p, q, c, c * t)
    return turned


@law
def _turn(matrix: Array, p: int, q: int, c: float, s: float) -> None:
    """Turn two columns in their plane, by an angle with the cosine `c` and the sine `s`."""
    for i in range(matrix.shape[0]):
        x, y = matrix[i, p], matrix[i, q]
        matrix[i, p], matrix[i, q] = c * x - s * y, s * x + c * y


@law
def _sort(work: Array, turns: Array, values: Array) -> None:
    """Write the lengths of the columns of `work`, and put the longest columns first, in both matrices."""
    count = work.shape[1]
    for j in range(count):
        square = 0.0
        for i in range(work.shape[0]):
            square += work[i, j] * work[i, j]
        values[j] = sqrt(square)
    for j in range(count - 1):
        most = j
        for k in range(j + 1, count):
            if values[k] > values[most]:
                most = k
        if most != j:
            values[j], values[most] = values[most], values[j]
            for i in range(work.shape[0]):
                work[i, j], work[i, most] = work[i, most], work[i, j]
            for i in range(count):
                turns[i, j], turns[i, most] = turns[i, most], turns[i, j]
