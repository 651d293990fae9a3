"""Rounding of all numbers of a message at once: the results of Python's `round`, in a quarter of its time.

A number times 10**decimals is rounded to the nearest whole number, which divided by 10**decimals gives the double that
is nearest to the decimal number. The product may be wrong in its last bit; numbers that are too near to a tie for it,
or too large, are left to `round`.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

_POWERS = np.array([float(10**decimals) for decimals in range(16)])
_LARGE = 2.0**40
"""Product from which `round` decides; the error of smaller products is below `_NEAR`."""
_NEAR = 2.0**-12
"""Distance of a product from a tie within which `round` decides."""


class Rounding:
    """Numbers to be rounded, each with its decimals and its place in a list or an object of the message."""

    def __init__(self) -> None:
        self._numbers: list[float] = []
        self._decimals = bytearray()  # one byte for each number
        self._places: list[tuple[Any, Any, int]] = []

    def add(self, box: Any, numbers: Iterable[tuple[Any, bytes]], lists: Iterable[tuple[Any, bytes]]) -> None:
        """Round items of a list or a dictionary later, in their places.

        Args:
            box: the list or dictionary.
            numbers: indices or keys of items that are numbers, each with the number of decimals as one byte.
            lists: likewise, of items that are lists or tuples of numbers.
        """
        waiting, decimals, places = self._numbers, self._decimals, self._places
        for key, digits in numbers:
            waiting.append(box[key])
            decimals += digits
            places.append((box, key, -1))
        for key, digits in lists:
            items = box[key]
            waiting += items
            decimals += digits * len(items)
            places.append((box, key, len(items)))

    def finish(self) -> None:
        """Round all numbers, and set all items."""
        results, at = self._rounded() if self._numbers else [], 0
        for box, key, count in self._places:
            if count < 0:
                box[key] = results[at]
                at += 1
            else:
                box[key] = results[at : at + count]
                at += count

    @np.errstate(invalid="ignore", over="ignore")
    def _rounded(self) -> list[float]:
        power = _POWERS.take(np.frombuffer(self._decimals, np.uint8))
        product = np.fromiter(self._numbers, np.float64, len(self._numbers)) * power
        whole = np.rint(product)
        results: list[float] = (whole / power).tolist()
        certain = (np.abs(product - whole) < 0.5 - _NEAR) & (np.abs(product) < _LARGE)
        if not certain.all():
            for n in np.flatnonzero(~certain).tolist():
                results[n] = round(self._numbers[n], self._decimals[n])
        return results
