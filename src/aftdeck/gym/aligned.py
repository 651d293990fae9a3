"""Arrays for observations, which other libraries take without a copy.

JAX copies an array whose memory does not begin at a multiple of 64 bytes; NumPy's own arrays begin at multiples of 16.
"""

from __future__ import annotations

import math

import numpy as np

from aftdeck.gym.terms import Floats32

ALIGNMENT = 64
"""Number of bytes of which the address is a multiple."""
_FLOAT = np.dtype(np.float32)


def aligned_floats(*shape: int) -> Floats32:
    """Return a new array of this shape, whose values are not set."""
    memory = np.empty(math.prod(shape) * _FLOAT.itemsize + ALIGNMENT, np.uint8)
    return np.ndarray(shape, _FLOAT, memory, -memory.ctypes.data % ALIGNMENT)
