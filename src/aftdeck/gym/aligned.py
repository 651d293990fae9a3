"""Arrays for observations, which other libraries take without a copy.

JAX copies an array whose memory does not begin at a multiple of 64 bytes; NumPy's own arrays begin at multiples of 16.
"""

from __future__ import annotations

import math

import numpy as np

from aftdeck.gym.terms import Floats32

ALIGNMENT = 64
"""Number of bytes of which each address is a multiple."""
_CHUNK = 4096
"""Memory that is asked for at a time, if the arrays are small [bytes]: to ask for its address takes microseconds."""
_FLOAT = np.dtype(np.float32)


class AlignedFloats:
    """Source of arrays of one shape."""

    def __init__(self, *shape: int) -> None:
        self._shape = shape
        self._each = -(-math.prod(shape) * _FLOAT.itemsize // ALIGNMENT) * ALIGNMENT
        self._memory = np.empty(0, np.uint8)
        self._next = self._end = 0

    def __reduce__(self) -> tuple[type[AlignedFloats], tuple[int, ...]]:
        """Return how a copy is made: without the memory, which a copy would not align."""
        return AlignedFloats, self._shape

    def new(self) -> Floats32:
        """Return a new array, whose values are not set."""
        if self._next == self._end:
            size = max(1, _CHUNK // max(self._each, 1)) * self._each
            self._memory = np.empty(size + ALIGNMENT, np.uint8)
            self._next = -self._memory.ctypes.data % ALIGNMENT
            self._end = self._next + size
        array: Floats32 = np.ndarray(self._shape, _FLOAT, self._memory, self._next)
        self._next += self._each
        return array
