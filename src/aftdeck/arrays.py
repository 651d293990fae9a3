"""Array types used throughout the package, and conversion to arrays; each use states the shape and the unit."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice
from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import NDArray

from aftdeck.errors import InputError
from aftdeck.units import short

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Mask = NDArray[np.uint8]

_FLOAT = np.dtype(np.float64)
_NUMBERS, _OBJECTS = "iuf", "O"
"""Kinds of NumPy types: real numbers, and objects of any type."""


def floats_of(values: object, what: str) -> Array:
    """Return real numbers of any types as an array of float64, finite or not.

    Args:
        values: numbers, sequences or arrays; texts and bools are not numbers.
        what: description of the values, for the error message.

    Raises:
        InputError: the values are anything else.
    """
    if type(values) is np.ndarray and values.dtype is _FLOAT:
        return values
    given: Any = values
    try:
        array = np.asarray(_lists(given) if isinstance(given, Sequence) else given)
        kind = array.dtype.kind
        if kind not in _NUMBERS and not (kind == _OBJECTS and all(isinstance(x, Real) for x in array.flat)):
            raise TypeError(f"an array of {array.dtype}")
        return np.asarray(array, dtype=np.float64)
    except Exception as error:  # methods of a foreign object may raise anything
        raise InputError(f"{what}: expected numbers, got {short(values)}") from error


def _lists(values: Sequence[Any]) -> Sequence[Any]:
    """Return a sequence of numbers or sequences as lists.

    NumPy would read a sequence of a foreign class to its end, even if it has none; here its length is the limit.
    """
    if isinstance(values, str | bytes | bytearray | memoryview):
        raise TypeError("a text or bytes instead of numbers")
    if type(values) in (list, tuple) and set(map(type, values)) <= _PLAIN_NUMBERS:
        return values
    return [_lists(item) if isinstance(item, Sequence) else item for item in islice(iter(values), len(values))]


_PLAIN_NUMBERS = {float, int, np.float64}
Flags = NDArray[np.bool_]
