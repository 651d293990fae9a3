"""The kinematic plant: joints that follow their commanded rates exactly."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.law import law
from aftdeck.plant.slide import Slide


@law
def follow(asked: Array, period: float, stops: Array, angles: Array, rates: Array, commanded: Array) -> None:
    """Take up the rates that are asked for, as far as the hard stops let the joints go.

    Args:
        asked: (6,) commanded rates [rad/s].
        period: [s].
        stops: (6, 2) hard stops [rad].
        angles: (6,) joint angles, changed [rad].
        rates: (6,) actual rates, changed [rad/s].
        commanded: (6,) where the commanded rates would have brought the joints, changed [rad].
    """
    for i in range(6):
        before, after = angles[i], angles[i] + asked[i] * period
        angles[i] = min(max(after, min(stops[i, 0], before)), max(stops[i, 1], before))
        rates[i] = asked[i] if angles[i] == after else (angles[i] - before) / period
        commanded[i] += asked[i] * period


class KinematicPlant:
    """An arm without mass: rates take effect at once and are held for the control period; a hard stop ends them.

    Not modelled: servos, flexibility, the orbiter's motion, contact.

    Attributes:
        angles: (6,) joint angles [rad].
        rates: (6,) joint rates [rad/s].
        commanded: (6,) where the rates commanded so far would have brought the joints [rad].
        stand: height of the shoulder above L's origin.
        stops: (6, 2) hard stops [rad].
    """

    def __init__(self, angles: Array, rates: Array, stand: Slide, stops: Array) -> None:
        self.angles = np.array(angles, dtype=np.float64)
        self.rates = np.array(rates, dtype=np.float64)
        self.commanded = self.angles.copy()
        self.stand = stand
        self.stops = stops

    def move(self, asked: Array, period: float, stand: float = 0.0) -> None:
        """Fly the commanded rates (6,) [rad/s], and drive the stand (-1 to +1), for one control period [s]."""
        follow(asked, period, self.stops, self.angles, self.rates, self.commanded)
        self.stand.move(stand, period)

    def save(self) -> tuple[list[float], ...]:
        """Everything that the plant's future depends on."""
        return self.angles.tolist(), self.rates.tolist(), self.commanded.tolist(), self.stand.save()

    def restore(self, saved: tuple[list[float], ...]) -> None:
        """Go on from what `save` gave."""
        self.angles[:], self.rates[:], self.commanded[:], stand = saved
        self.stand.restore(stand)
