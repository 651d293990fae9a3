"""Slide with a drive in both directions along a line: the concept arm's telescope and its prong."""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.arms.equipment import Prong
from aftdeck.arms.load import ArmModel
from aftdeck.kinematics.linkage import L1
from aftdeck.state_part import StatePart


class Travel(NamedTuple):
    """Range and rate of a slide.

    Attributes:
        low: least position [m].
        high: greatest position [m].
        rate: rate at full drive [m/s].
    """

    low: float
    high: float
    rate: float


class Slide(StatePart):
    """Position on a line, moved at one rate between two ends. The rate takes effect at once.

    Attributes:
        position: position [m].
        velocity: velocity of the last step [m/s].
    """

    position: float
    velocity: float = 0.0

    def move(self, travel: Travel, drive: float, period: float) -> None:
        """Move for one control period [s]: drive +1 towards `high`, -1 towards `low`, 0 stop."""
        before = self.position
        self.position = self.after(travel, drive, period)
        self.velocity = (self.position - before) / period

    def after(self, travel: Travel, drive: float, period: float) -> float:
        """Return the position that `move` would reach [m], without moving."""
        return min(max(self.position + drive * travel.rate * period, travel.low), travel.high)


def travel_of_stand(model: ArmModel) -> Travel:
    """Return the travel of the shoulder's height above L's origin: + lengthens the telescope.

    The height is fixed on an arm without a telescope.
    """
    height, telescope = float(model.links[L1]), model.equipment.telescope
    return Travel(height, height, 0.0) if telescope is None else Travel(*telescope)


def travel_of_prong(prong: Prong | None) -> Travel:
    """Return the travel of the prong: y2 of its inner face [m], + closes, - opens; fixed at 0 if there is no prong."""
    return Travel(0.0, 0.0, 0.0) if prong is None else Travel(prong.opened, prong.closed, prong.rate)
