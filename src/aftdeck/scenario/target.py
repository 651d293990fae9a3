"""A final tip pose for an automatic mode, as plain values."""

from __future__ import annotations

import msgspec
import numpy as np

from aftdeck.frames import Pose
from aftdeck.tuples import Joints, Rows, Vec3


class Target(msgspec.Struct, frozen=True):
    """Target of an automatic mode: pose of frame 7 in L."""

    position: Vec3
    """Position [m]."""
    rotation: Rows
    """Rows of the matrix whose columns are frame 7's axes."""
    joints: Joints | None = None
    """Final joint angles [rad] for mode 1, if the target was given by joint angles. If None, mode 1 uses the set of
    joint angles that is nearest to the present angles.

    The angles put the tip at `position` and `rotation`; a keyed-in target whose angles give another pose is rejected.
    """

    @property
    def pose(self) -> Pose:
        """Pose as arrays."""
        return Pose(np.array(self.position), np.array(self.rotation))


class AtPayload(msgspec.Struct, frozen=True, tag=True):
    """A target that is computed when its phase begins: the pose at which the end effector captures a payload."""

    payload: int
    """Index of the payload in the scenario's `payloads`."""
    above: float = 0.0
    """Distance from the capture pose back to the target, along the end effector's axis [m]."""
    offset: Vec3 = (0.0, 0.0, 0.0)
    """Further displacement along the payload's axes [m]."""


class AtBerth(msgspec.Struct, frozen=True, tag=True):
    """A target that is computed when its phase begins: the pose at which the held payload is in a berth."""

    berth: str
    """Name of the berth."""
    above: float = 0.0
    """Distance from the pose in the berth to the target: up out of the bay, or out from the port [m]."""
    offset: Vec3 = (0.0, 0.0, 0.0)
    """Further displacement along the berth's axes [m]."""


class InFrame(msgspec.Struct, frozen=True, tag=True):
    """A target that is computed when its phase begins: a tip pose relative to the orbiter, to space or to a payload."""

    frame: str
    """Name of the coordinate frame in which the pose is given: ``orbiter``, ``space``, or a payload's name."""
    position: Vec3
    """Position [m]."""
    rotation: Rows
    """Rows of the matrix whose columns are frame 7's axes."""

    @property
    def pose(self) -> Pose:
        """Position and rotation as arrays."""
        return Pose(np.array(self.position), np.array(self.rotation))


RelativeTarget = AtPayload | AtBerth | InFrame
"""A target that depends on the pose of an object at the time when a phase begins."""


def target_at(pose: Pose, joints: Joints | None = None) -> Target:
    """Return the target at a pose in L."""
    x, y, z = pose.position.tolist()
    a, b, c = (tuple(row) for row in pose.rotation.tolist())
    return Target((x, y, z), (a, b, c), joints)
