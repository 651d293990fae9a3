"""Plain values of objects of any type: numbers, texts and switches as Python's own types.

NumPy's scalars and arrays have the method `tolist`; so have the arrays of learning libraries. Each function raises an
exception of any type if the object has no plain value, because methods of foreign objects may raise anything.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice
from numbers import Integral, Real
from operator import index
from typing import Any

_TEXTS = (str, bytes, bytearray, memoryview)


def number(value: Any) -> float:
    """Return a real number of any type, or an array without dimensions, as a float; a bool is not a number."""
    if type(value) is float:
        return value
    if not isinstance(value, Real) or hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, bool) or not isinstance(value, Real):
        raise TypeError(f"{type(value).__name__} is not a number")
    return float(value)


def whole_number(value: Any) -> int:
    """Return an integer of any type, or an array without dimensions, as an int; a bool is not an integer."""
    if not isinstance(value, Integral):
        value = value.tolist()
    if isinstance(value, bool) or not isinstance(value, Integral):
        raise TypeError(f"{type(value).__name__} is not an integer")
    return index(value)


def text(value: Any) -> str:
    """Return a text of a subclass of str, or an array without dimensions, as a str."""
    if not isinstance(value, str):
        value = value.tolist()
    return str.__str__(value)


def flag(value: Any) -> bool:
    """Return a bool of any type, or an integer that is 0 or 1, as a bool."""
    if isinstance(value, bool):
        return value
    if not isinstance(value, Integral):
        value = value.tolist()
    number_of_it = index(value)
    if number_of_it not in (0, 1):
        raise ValueError(f"{number_of_it} is not a position of a switch")
    return bool(number_of_it)


def items(values: Any, shape: tuple[int, ...]) -> list[Any]:
    """Return the items of a sequence, or of an array of a certain shape; their number is `shape[0]`.

    Sets, dictionaries, generators, texts and bytes are not sequences of numbers.
    """
    if not isinstance(values, Sequence):
        if values.shape != shape:
            raise ValueError(f"the shape is {values.shape}")
        values = values.tolist()
    if isinstance(values, _TEXTS):
        raise TypeError("a text is not a sequence of numbers")
    found = list(islice(iter(values), shape[0] + 1))
    if len(found) != shape[0]:
        raise ValueError(f"the number of items is not {shape[0]}")
    return found


def numbers(values: Any, count: int) -> tuple[float, ...]:
    """Return `count` real numbers of any types, in a sequence or an array, as a tuple of floats."""
    return tuple(number(value) for value in items(values, (count,)))


def few_numbers(values: Any, most: int) -> tuple[float, ...]:
    """Return at most `most` real numbers of any types, in a sequence or an array with one dimension, as floats."""
    if not 0 < len(values) <= most:
        raise ValueError(f"the number of items is {len(values)}")
    return numbers(values, len(values))
