"""What an observer sees of the arm at an instant, in one compiled call: tip, twist, singularities."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from aftdeck.kinematics.jacobian import Rates, erates, jacobi
from aftdeck.kinematics.linkage import sines, tip
from aftdeck.kinematics.singular import distances
from aftdeck.law import law

Array = NDArray[np.float64]

OBSERVED = 21
"""Tip position (3) and rotation (9, row by row), twist (6), distances from the singularities (3)."""


@law
def observe(arm: Array, angles: Array, rates: Array, seen: Array) -> None:
    """LNKAGE and ERATES at joint angles (6,) [rad] and rates (6,) [rad/s], in L, into `seen` (21,)."""
    a = sines(arm, angles[0], angles[1], angles[2], angles[3], angles[4], angles[5])
    t = tip(arm, a)
    for i in range(12):
        seen[i] = t[i]
    w = erates(a, jacobi(arm, a), Rates(rates[0], rates[1], rates[2], rates[3], rates[4], rates[5]))
    for i in range(6):
        seen[12 + i] = w[i]
    seen[18], seen[19], seen[20] = distances(arm, a)
