"""Yardsticks of the machine: plain loops that are measured in the same run as the program that they are compared with.

They contain none of Aftdeck's code, so that a change of Aftdeck does not change them.
"""

from __future__ import annotations

import hashlib
import math
import time
from collections.abc import Callable

import numba
import numpy as np

from aftdeck.arrays import Array
from benchmarks.measure import Call, Figure, Timing, microseconds

NUMBERS = np.linspace(0.1, 1.2, 12)
"""Numbers in of the compiled loop."""
_TURN = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]])
_STEP = np.array([0.1, 0.2, 0.3])


def _arithmetic(numbers: Array, out: Array, turns: int, products: int) -> None:
    """Compute `turns` sines and cosines, and `products` products and sums for each of six results."""
    total = 0.0
    for k in range(turns):
        angle = numbers[k % 12] + 1e-3 * k
        total += math.sin(angle) * math.cos(angle)
    a = b = c = d = e = f = total
    for k in range(products):
        x = numbers[k % 12]
        a, b, c, d, e, f = a * x + 0.1, b * x + 0.2, c * x + 0.3, d * x + 0.4, e * x + 0.5, f * x + 0.6
    out[0], out[1], out[2], out[3], out[4], out[5] = a, b, c, d, e, f


def arithmetic(turns: int, products: int) -> Call:
    """Return the call of a compiled loop of plain arithmetic, with arrays as a law has them.

    Args:
        turns: number of sines and cosines.
        products: number of products and sums for each of six results.
    """
    names: dict[str, object] = {"f": numba.njit(_arithmetic), "numbers": NUMBERS, "out": np.empty(6)}
    return f"f(numbers, out, {turns}, {products})", names


def _projected(first: Array, second: Array, normals: Array) -> int:
    """Return the number of pairs (n, 8, 3) of corners that lie on different sides along their normal (n, 3)."""
    apart = 0
    for k in range(len(normals)):
        x, y, z = normals[k, 0], normals[k, 1], normals[k, 2]
        most, least = -1e300, 1e300
        for corner in range(8):
            here = x * first[k, corner, 0] + y * first[k, corner, 1] + z * first[k, corner, 2]
            there = x * second[k, corner, 0] + y * second[k, corner, 1] + z * second[k, corner, 2]
            most, least = max(most, here), min(least, there)
        if least > most:
            apart += 1
    return apart


def projections(timing: Timing) -> Figure:
    """Measure a compiled loop that projects the 16 corners of a pair of hexahedra, each on a normal."""
    rng = np.random.default_rng(1)
    first, second, normals = rng.normal(size=(128, 8, 3)), rng.normal(size=(128, 8, 3)), rng.normal(size=(128, 3))
    names = {"f": numba.njit(_projected), "first": first, "second": second, "normals": normals}
    time = microseconds("f(first, second, normals)", names, timing) / len(normals)
    return Figure("plain loop, 16 corners on a normal", time, "us", None, "compiled by Numba, for a pair")


def comparisons(count: int) -> Call:
    """Return the call of a compiled loop that compares each of `count` rectangles with each other one."""
    rectangles = np.sort(np.random.default_rng(1).uniform(0.0, 1.0, (count, 2, 2)), axis=1)
    return "f(rectangles)", {"f": numba.njit(_overlapping), "rectangles": rectangles}


def _overlapping(rectangles: Array) -> int:
    """Return the number of pairs of rectangles (n, 2, 2) that overlap."""
    count = 0
    for i in range(len(rectangles)):
        for k in range(i):
            if (
                rectangles[i, 0, 0] < rectangles[k, 1, 0]
                and rectangles[k, 0, 0] < rectangles[i, 1, 0]
                and rectangles[i, 0, 1] < rectangles[k, 1, 1]
                and rectangles[k, 0, 1] < rectangles[i, 1, 1]
            ):
                count += 1
    return count


def _python_work() -> bytes:
    """Do by plain Python and NumPy the kinds of work of a control step: sums, small arrays, a digest."""
    total, numbers = 0.0, (0.1, 0.2, 0.3, 0.4)
    for k in range(200):
        total = 0.5 * total + numbers[k & 3]
    moved = [_TURN @ np.array((total, float(k), 1.0)) + _STEP for k in range(10)]
    lengths = [math.dist(array.tolist(), (0.0, 0.0, 0.0)) for array in moved]
    data = b"".join(array.tobytes() for array in moved) * 8
    return hashlib.sha256(data + repr(lengths).encode()).digest()


WORK = "200 sums, 10 products of a matrix and a vector by NumPy, SHA-256 of 2 kB"
"""Description of the work of `plain_python`."""


def plain_python(calls: int = 5, clock: Callable[[], float] = time.perf_counter) -> float:
    """Return the mean time of some calls of plain Python and NumPy that do the kinds of work of a control step [s].

    Call it in turn with control steps: then other work of the machine delays both.
    """
    begin = clock()
    for _ in range(calls):
        _python_work()
    return (clock() - begin) / calls
