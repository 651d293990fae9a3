"""Axes along which the hand controllers act."""

from __future__ import annotations

import numpy as np

from aftdeck.bodies.placed import matrix_product, rows_of, transposed
from aftdeck.frames import rotation_x
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.steering.mode import MODES, ORB_LD_TURNING
from aftdeck.tuples import UNTURNED, Rows


class StickAxes:
    """Axes along which the sticks of a scenario act."""

    def __init__(self, scenario: Scenario) -> None:
        self._mount = rows_of(scenario.arm.model.mount.rotation)
        self._to_l = transposed(self._mount)
        self._hand = rows_of(np.eye(3) if scenario.strict else rotation_x(scenario.arm.model.end_effector_roll))

    def in_panel(self, frame: Frame) -> Rows:
        """Return the axes, in columns, in panel components: the THC's X, Y, Z."""
        along = MODES[frame.mode].axes
        if along == "end effector axes":
            return matrix_product(self._mount, matrix_product(frame.orientation, self._hand))
        if along == "payload axes" and frame.payload is not None:
            return matrix_product(self._mount, frame.payload.orientation)
        return UNTURNED

    def in_l(self, frame: Frame) -> tuple[Rows, Rows]:
        """Return the axes of the THC and of the RHC, in columns, in L; they differ in mode 7 only."""
        axes = self.in_panel(frame)
        moving = self._to_l if axes is UNTURNED else matrix_product(self._to_l, axes)
        if frame.law == ORB_LD_TURNING and frame.payload is not None:
            return moving, frame.payload.orientation
        return moving, moving
