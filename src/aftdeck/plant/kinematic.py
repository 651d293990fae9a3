"""The kinematic plant: joints that follow their commanded rates exactly."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class KinematicPlant:
    """An arm without mass: rates take effect at once and are held for the control period.

    Not modelled: servos, flexibility, the orbiter's motion, contact.

    Attributes:
        angles: (6,) joint angles [rad].
        rates: (6,) joint rates [rad/s].
    """

    def __init__(self, angles: Array, rates: Array) -> None:
        self.angles = np.array(angles, dtype=np.float64)
        self.rates = np.array(rates, dtype=np.float64)

    def move(self, commanded: Array, period: float) -> None:
        """Fly the commanded rates (6,) [rad/s] for one control period [s]."""
        self.rates[:] = commanded
        self.angles += self.rates * period

    def save(self) -> tuple[list[float], ...]:
        """Everything that the plant's future depends on."""
        return self.angles.tolist(), self.rates.tolist()

    def restore(self, saved: tuple[list[float], ...]) -> None:
        """Go on from what `save` gave."""
        self.angles[:], self.rates[:] = saved
