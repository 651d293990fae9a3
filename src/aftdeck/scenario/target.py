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


class Place(msgspec.Struct, frozen=True):
    """A target that is found when it is flown to: the hand at a payload, or the held payload at a seat."""

    cargo: int | None
    """Where the hand takes this payload of the scenario; None: it is a place at a seat."""
    seat: str
    """Where what is held is in its place in this seat; empty: it is a place at a payload."""
    above: float
    """How far short of it: back along the hand, up out of the bay, out from the port [m]."""


def target_at(pose: Pose, joints: Six | None = None) -> Target:
    """The target at a pose in L."""
    x, y, z = pose.position.tolist()
    a, b, c = (tuple(row) for row in pose.rotation.tolist())
    return Target((x, y, z), (a, b, c), joints)
