"""Kinematic plant: joints that follow their commanded rates exactly."""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.law import law
from aftdeck.plant.linear_actuator import Travel
from aftdeck.plant.plant import Accuracy, Surroundings
from aftdeck.plant.spread import NO_SPREAD, Spread
from aftdeck.plant.state import PlantState
from aftdeck.steering.mode import LawChoice


@law
def follow(commanded_rates: Array, period: float, stops: Array, angles: Array, rates: Array, commanded: Array) -> None:
    """Move the joints at the commanded rates for one control period, as far as the hard stops allow.

    Args:
        commanded_rates: (n,) commanded rates [rad/s].
        period: control period [s].
        stops: (n, 2) hard stops [rad].
        angles: (n,) joint angles [rad]; updated in place.
        rates: (n,) output: actual rates [rad/s].
        commanded: (n,) angles that the joints would have without stops [rad]; updated in place.
    """
    for i in range(angles.shape[0]):
        before, after = angles[i], angles[i] + commanded_rates[i] * period
        angles[i] = min(max(after, min(stops[i, 0], before)), max(stops[i, 1], before))
        rates[i] = commanded_rates[i] if angles[i] == after else (angles[i] - before) / period
        commanded[i] += commanded_rates[i] * period


class KinematicPlant(NamedTuple):
    """Arm without mass. Rates take effect at once and last for the control period; a hard stop stops its joint.

    Not modelled: servos, brakes that slip, flexibility, the orbiter's motion, contact forces.

    Attributes:
        stops: (n, 2) hard stops [rad].
        travel: range and rate of the telescope.
        period: control period [s].
    """

    stops: Array
    travel: Travel
    period: float

    @property
    def readings(self) -> None:
        """None: nothing has a mass."""

    @property
    def accuracy(self) -> Accuracy:
        """Differences of rounding only."""
        return Accuracy(1e-9, 5e-8, 1e-9)

    @property
    def has_servos(self) -> bool:
        """False: joints follow their commanded rates exactly."""
        return False

    @property
    def has_contact_forces(self) -> bool:
        """False: nothing has a mass."""
        return False

    def spread(self, law: LawChoice, *, loaded: bool) -> Spread:
        """Return no difference: the rehearsal is the motion."""
        return NO_SPREAD

    def begin(self, state: PlantState, attached: int, poses: Array, motions: Array, prong: float) -> None:
        """Do nothing: there are no bodies."""

    def move(
        self,
        state: PlantState,
        rates: Array,
        drive: float,
        around: Surroundings,
        *,
        brakes: bool,
        attached: int,
        by_angle: bool,
    ) -> None:
        """Move joints and telescope at the commanded rates for one control period (`Plant.move`)."""
        follow(rates, self.period, self.stops, state.angles, state.rates, state.commanded)
        state.stand.move(self.travel, drive, self.period)
