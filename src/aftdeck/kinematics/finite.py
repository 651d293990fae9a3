"""Whether numbers are finite, in a law: NumPy's own check costs as much from Python as a law of the kinematics does."""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.law import law


@law
def finite(values: Array) -> bool:
    """Whether all of (n,) numbers are finite."""
    total = 0.0
    for i in range(values.shape[0]):
        total += 0.0 * values[i]
    return total == 0.0
