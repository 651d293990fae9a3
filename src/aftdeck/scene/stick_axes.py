"""Axes along which the hand controllers act."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.frames import rotation_x
from aftdeck.matrices import product
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.steering.mode import MODES

MIXED = 7
"""Number of the steering law in which the RHC acts about the payload's axes, and the THC along the orbiter's."""


class StickAxes:
    """Axes along which the sticks of a scenario act."""

    def __init__(self, scenario: Scenario) -> None:
        self._mount = scenario.arm.model.mount.rotation
        self._hand: Array = np.eye(3) if scenario.strict else rotation_x(scenario.arm.model.end_effector_roll)

    def in_panel(self, frame: Frame) -> Array:
        """Return the axes (3, 3), in columns, in panel components: the THC's X, Y, Z."""
        along = MODES[frame.mode].axes
        if along == "end effector axes":
            return product(self._mount, product(np.array(frame.orientation), self._hand))
        if along == "payload axes" and frame.payload is not None:
            return product(self._mount, np.array(frame.payload[1]))
        return np.eye(3)

    def in_l(self, frame: Frame) -> tuple[Array, Array]:
        """Return the axes of the THC and of the RHC, each (3, 3), in columns, in L; they differ in mode 7 only."""
        moving = product(self._mount.T, self.in_panel(frame))
        if frame.law == MIXED and frame.payload is not None:
            return moving, np.array(frame.payload[1])
        return moving, moving
