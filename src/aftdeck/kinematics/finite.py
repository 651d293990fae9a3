"""Compiled check for finite numbers. NumPy's own check, if called from Python, takes as long as a kinematics law."""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.law import law


@law
def finite(values: Array) -> bool:
    """Return whether all numbers of an array (n,) are finite."""
    total = 0.0
    for i in range(values.shape[0]):
        total += 0.0 * values[i]
    return total == 0.0
