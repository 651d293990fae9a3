"""The kinematic plant: joints that follow their commanded rates exactly."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from aftdeck.plant.slide import Slide

Array = NDArray[np.float64]


class KinematicPlant:
    """An arm without mass: rates take effect at once and are held for the control period.

    Not modelled: servos, flexibility, the orbiter's motion, contact.

    Attributes:
        angles: (6,) joint angles [rad].
        rates: (6,) joint rates [rad/s].
        stand: height of the shoulder above L's origin.
    """

    def __init__(self, angles: Array, rates: Array, stand: Slide) -> None:
        self.angles = np.array(angles, dtype=np.float64)
        self.rates = np.array(rates, dtype=np.float64)
        self.stand = stand

    def move(self, commanded: Array, period: float, stand: float = 0.0) -> None:
        """Fly the commanded rates (6,) [rad/s], and drive the stand (-1 to +1), for one control period [s]."""
        self.rates[:] = commanded
        self.angles += self.rates * period
        self.stand.move(stand, period)

    def save(self) -> tuple[list[float], ...]:
        """Everything that the plant's future depends on."""
        return self.angles.tolist(), self.rates.tolist(), self.stand.save()

    def restore(self, saved: tuple[list[float], ...]) -> None:
        """Go on from what `save` gave."""
        self.angles[:], self.rates[:], stand = saved
        self.stand.restore(stand)
