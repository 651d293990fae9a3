"""A final tip pose for an automatic mode, as plain values."""

from __future__ import annotations

import msgspec
import numpy as np

from aftdeck.frames import Pose, Rows

Vec3 = tuple[float, float, float]
Six = tuple[float, float, float, float, float, float]


class Target(msgspec.Struct, frozen=True):
    """Where an automatic mode goes: frame 7 in L."""

    position: Vec3
    """[m]"""
    rotation: Rows
    """Rows of the matrix whose columns are frame 7's axes."""
    joints: Six | None = None
    """Final joint angles [rad], where the target was given by them: mode 1 flies to these; else to the nearest.

    They put the tip at the pose above: keyed in, a target whose angles lead elsewhere is refused.
    """

    @property
    def pose(self) -> Pose:
        """The same as arrays."""
        return Pose(np.array(self.position), np.array(self.rotation))


class AtCargo(msgspec.Struct, frozen=True, tag=True):
    """A target that is found when it is flown to: the hand where it takes a payload."""

    cargo: int
    """Which of the scenario's."""
    above: float = 0.0
    """How far short of it, back along the hand [m]."""
    offset: Vec3 = (0.0, 0.0, 0.0)
    """How far aside of that, along the payload's axes [m]."""


class AtSeat(msgspec.Struct, frozen=True, tag=True):
    """A target that is found when it is flown to: the hand where what it holds is in its place in a seat."""

    seat: str
    above: float = 0.0
    """How far short of it: up out of the bay, out from the port [m]."""
    offset: Vec3 = (0.0, 0.0, 0.0)
    """How far aside of that, along the seat's axes [m]."""


class InFrame(msgspec.Struct, frozen=True, tag=True):
    """A target that is found when it is flown to: the tip at a pose in what a body, a seat or a payload moves with."""

    frame: str
    """``orbiter``, ``space``, or a payload's name."""
    position: Vec3
    """[m]"""
    rotation: Rows
    """Rows of the matrix whose columns are frame 7's axes."""

    @property
    def pose(self) -> Pose:
        """Position and rotation as arrays."""
        return Pose(np.array(self.position), np.array(self.rotation))


Place = AtCargo | AtSeat | InFrame
"""A target that depends on where something is as a phase begins."""


def target_at(pose: Pose, joints: Six | None = None) -> Target:
    """The target at a pose in L."""
    x, y, z = pose.position.tolist()
    a, b, c = (tuple(row) for row in pose.rotation.tolist())
    return Target((x, y, z), (a, b, c), joints)
