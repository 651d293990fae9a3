"""Kinematic plant: joints that follow their commanded rates exactly."""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.law import law
from aftdeck.plant.linear_actuator import Slide, Travel
from aftdeck.state_part import StatePart


@law
def follow(commanded_rates: Array, period: float, stops: Array, angles: Array, rates: Array, commanded: Array) -> None:
    """Move the joints at the commanded rates for one control period, as far as the hard stops allow.

    Args:
        commanded_rates: (6,) commanded rates [rad/s].
        period: control period [s].
        stops: (6, 2) hard stops [rad].
        angles: (6,) joint angles [rad]; updated in place.
        rates: (6,) output: actual rates [rad/s].
        commanded: (6,) angles that the joints would have without stops [rad]; updated in place.
    """
    for i in range(6):
        before, after = angles[i], angles[i] + commanded_rates[i] * period
        angles[i] = min(max(after, min(stops[i, 0], before)), max(stops[i, 1], before))
        rates[i] = commanded_rates[i] if angles[i] == after else (angles[i] - before) / period
        commanded[i] += commanded_rates[i] * period


class KinematicPlant(StatePart):
    """Arm without mass. Rates take effect at once and last for the control period; a hard stop stops its joint.

    Not modelled: servos, flexibility, the orbiter's motion, contact.

    Attributes:
        angles: (6,) joint angles [rad].
        rates: (6,) joint rates [rad/s].
        commanded: (6,) angles that the joints would have without stops, from all commanded rates so far [rad].
        stand: telescope; its position is the shoulder's height above L's origin.
    """

    angles: Array
    rates: Array
    commanded: Array
    stand: Slide

    def move(self, stops: Array, travel: Travel, commanded_rates: Array, period: float, drive: float = 0.0) -> None:
        """Move joints and telescope at the commanded rates for one control period.

        Args:
            stops: (6, 2) hard stops [rad].
            travel: range and rate of the telescope.
            commanded_rates: (6,) commanded rates [rad/s].
            period: control period [s].
            drive: drive of the telescope, -1 to +1; + lengthens it.
        """
        follow(commanded_rates, period, stops, self.angles, self.rates, self.commanded)
        self.stand.move(travel, drive, period)
