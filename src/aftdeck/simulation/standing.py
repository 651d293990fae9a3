"""The arm on its telescope: the same arm with its shoulder as high as the stand is now."""

from __future__ import annotations

from aftdeck.kinematics.arm import Arm
from aftdeck.kinematics.linkage import L1
from aftdeck.state_part import Cache


class Standing(Cache):
    """An arm at the height asked for last; of an arm without a telescope, the arm.

    Attributes:
        height: of the shoulder above L's origin as the steering's rules have it [m].
    """

    def __init__(self, arm: Arm) -> None:
        self._arm = arm
        self.height = float(arm.model.links[L1])

    def at(self, height: float) -> Arm:
        """Return the arm with its shoulder so high [m]."""
        if self._arm.model.links[L1] != height:
            self._arm = self._arm.at(stand=height)
        return self._arm

    def copied(self) -> Standing:
        """Return a copy that may be asked for another height."""
        copy = Standing(self._arm)
        copy.height = self.height
        return copy
