"""Linear actuator with a drive in both directions: the concept arm's telescope, and the prong of its end effector."""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.arms.load import ArmModel
from aftdeck.arms.switched import SwitchedJoint
from aftdeck.kinematics.linkage import L1
from aftdeck.state_part import StatePart


class Travel(NamedTuple):
    """Range and rate of a linear actuator.

    Attributes:
        low: least position [m].
        high: greatest position [m].
        rate: rate at full drive [m/s].
    """

    low: float
    high: float
    rate: float


class Slide(StatePart):
    """State of a linear actuator. A drive moves it between two ends; the rate takes effect at once.

    Attributes:
        position: position [m].
        velocity: velocity of the last step [m/s].
    """

    position: float
    velocity: float = 0.0

    def move(self, travel: Travel, drive: float, period: float) -> None:
        """Move for one control period [s]: drive +1 towards `high`, -1 towards `low`, both at `rate`; 0 stops."""
        if drive == 0.0 and self.velocity == 0.0:
            return
        before = self.position
        self.position = self.after(travel, drive, period)
        self.velocity = (self.position - before) / period

    def after(self, travel: Travel, drive: float, period: float) -> float:
        """Return the position that `move` would reach [m], without moving."""
        return min(max(self.position + drive * travel.rate * period, travel.low), travel.high)


def travel_of_stand(model: ArmModel) -> Travel:
    """Return range and rate of the shoulder's height above L's origin; drive + lengthens the telescope."""
    return _travel(model.telescope, float(model.links[L1]))


def travel_of_prong(model: ArmModel) -> Travel:
    """Return range and rate of the prong's inner face, in coordinate y2; drive + closes the prong, - opens it."""
    return _travel(model.prong, 0.0)


def _travel(joint: SwitchedJoint | None, fixed: float) -> Travel:
    """Return range and rate of a joint that a switch drives; without the joint, its coordinate is fixed."""
    return Travel(fixed, fixed, 0.0) if joint is None else Travel(joint.least, joint.greatest, joint.rate)
