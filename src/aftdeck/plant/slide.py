"""What moves along a line by stop, one way, the other way: the telescope that the concept arm stands on, its prong."""

from __future__ import annotations

from aftdeck.arms.load import ArmModel
from aftdeck.kinematics.linkage import L1


class Slide:
    """A place on a line, moved at one rate between two ends. It takes up its rate at once.

    Attributes:
        position: [m]
        velocity: of the last step [m/s].
        low: least position [m].
        high: greatest position [m].
        rate: of full drive [m/s].
    """

    def __init__(self, position: float, low: float, high: float, rate: float) -> None:
        self.position, self.velocity = position, 0.0
        self.low, self.high, self.rate = low, high, rate

    def move(self, drive: float, period: float) -> None:
        """Go for one control period [s]: drive +1 towards `high`, -1 towards `low`, 0 stop."""
        before = self.position
        self.position = self.after(drive, period)
        self.velocity = (self.position - before) / period

    def after(self, drive: float, period: float) -> float:
        """Where it would then be [m]."""
        return min(max(self.position + drive * self.rate * period, self.low), self.high)

    def save(self) -> list[float]:
        """Everything that its future depends on."""
        return [self.position, self.velocity]

    def restore(self, saved: list[float]) -> None:
        """Go on from what `save` gave."""
        self.position, self.velocity = saved


def stand_of(model: ArmModel) -> Slide:
    """The height of an arm's shoulder above L's origin: its telescope, + longer; fixed on an arm without one."""
    height = float(model.links[L1])
    telescope = model.equipment.telescope
    return Slide(height, height, height, 0.0) if telescope is None else Slide(height, *telescope)
