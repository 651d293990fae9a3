"""Cache of the arm with its shoulder at the present height, which a telescope changes."""

from __future__ import annotations

from functools import lru_cache

from aftdeck.arms.load import ArmModel
from aftdeck.kinematics.arm import Arm
from aftdeck.kinematics.linkage import L1
from aftdeck.state_part import Cache


class Standing(Cache):
    """Cache of the arm with its shoulder at the height that was requested last.

    Attributes:
        height: height of the shoulder above L's origin according to the steering's rules [m].
    """

    def __init__(self, arm: Arm) -> None:
        self._arm = arm
        self._at = self.height = float(arm.model.links[L1])

    def at(self, height: float) -> Arm:
        """Return the arm with its shoulder at this height [m]."""
        if self._at != height:
            self._arm, self._at = _standing(self._arm.model, height), height
        return self._arm

    def copied(self) -> Standing:
        """Return a copy that can cache another height."""
        copy = Standing(self._arm)
        copy.height = self.height
        return copy


@lru_cache(maxsize=8)
def _standing(model: ArmModel, height: float) -> Arm:
    """Return an arm with its shoulder at this height [m]: the same for each episode of an environment."""
    return Arm(model.standing(height))
