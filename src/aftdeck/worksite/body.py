"""Data model of a body of a worksite."""

from __future__ import annotations

from typing import Literal

import msgspec
import numpy as np

from aftdeck.frames import Pose, endori
from aftdeck.shapes import Shape
from aftdeck.tuples import Vec3

Frame = Literal["orbiter", "space"]


class Body(msgspec.Struct, frozen=True):
    """A rigid body of the worksite."""

    name: str
    """Name by which cameras and the scene refer to the body, for example ``orbiter``."""
    shapes: tuple[Shape, ...]
    """Shapes that draw the body, in its own frame."""
    details: tuple[Shape, ...] = ()
    """Shapes that only decorate the body, in its own frame. The station's page draws them. Nothing else uses them:
    neither contacts, nor what cameras see, nor the pictures without a depth buffer."""
    fixed_to: Frame = "orbiter"
    """Coordinate frame to which the body is fixed."""
    position: Vec3 = (0.0, 0.0, 0.0)
    """Position of the body's own frame in the scene at the start [m]."""
    rotation: Vec3 = (0.0, 0.0, 0.0)
    """Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]."""

    @property
    def pose(self) -> Pose:
        """Pose of the body's own frame in the scene at the start."""
        return Pose(np.array(self.position), endori(*self.rotation))
