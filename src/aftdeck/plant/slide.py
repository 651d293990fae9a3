"""What moves along a line by stop, one way, the other way: the telescope that the concept arm stands on, its prong."""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.arms.equipment import Prong
from aftdeck.arms.load import ArmModel
from aftdeck.kinematics.linkage import L1
from aftdeck.state_part import StatePart


class Travel(NamedTuple):
    """Where a slide can go.

    Attributes:
        low: least position [m].
        high: greatest position [m].
        rate: of full drive [m/s].
    """

    low: float
    high: float
    rate: float


class Slide(StatePart):
    """A place on a line, moved at one rate between two ends. It takes up its rate at once.

    Attributes:
        position: [m]
        velocity: of the last step [m/s].
    """

    position: float
    velocity: float = 0.0

    def move(self, travel: Travel, drive: float, period: float) -> None:
        """Go for one control period [s]: drive +1 towards `high`, -1 towards `low`, 0 stop."""
        before = self.position
        self.position = self.after(travel, drive, period)
        self.velocity = (self.position - before) / period

    def after(self, travel: Travel, drive: float, period: float) -> float:
        """Where it would then be [m]."""
        return min(max(self.position + drive * travel.rate * period, travel.low), travel.high)


def travel_of_stand(model: ArmModel) -> Travel:
    """The height of an arm's shoulder above L's origin: its telescope, + longer; fixed on an arm without one."""
    height, telescope = float(model.links[L1]), model.equipment.telescope
    return Travel(height, height, 0.0) if telescope is None else Travel(*telescope)


def travel_of_prong(prong: Prong | None) -> Travel:
    """The prong: y2 of its inner face [m], + close, - open; at rest at 0 of a hand that has none."""
    return Travel(0.0, 0.0, 0.0) if prong is None else Travel(prong.opened, prong.closed, prong.rate)
