"""Compiled check for finite numbers, and its error.

NumPy's own check, if called from Python, takes as long as a kinematics law.
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.errors import InputError
from aftdeck.law import law


@law
def finite(values: Array) -> bool:
    """Return whether all numbers of an array (n,) are finite."""
    total = 0.0
    for i in range(values.shape[0]):
        total += 0.0 * values[i]
    return total == 0.0


def not_finite(what: str, values: Array) -> InputError:
    """Return the error for numbers of which some are not finite."""
    return InputError(f"{what}: expected finite numbers, got {values.squeeze()}")
