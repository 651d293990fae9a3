"""Linkage of an arm: the values that laws and pictures use. They are computed from the lengths in the arm's file."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arms.model import ArmFile, HeadingArmFile, YawArmFile
from aftdeck.arrays import Array
from aftdeck.elementary import atan2
from aftdeck.matrices import length

Axes = tuple[int, int, int, int, int, int]
Names = tuple[str, str, str, str, str, str, str]

STAND, PRONG = "arm.stand", "arm.prong"
"""Names of two additional frames of an arm with a telescope and a prong. The frame of the telescope's moving tube has
L's axes; its origin is on L's axis 3 at the shoulder's height. The prong's frame has the axes of the last joint's
frame; its origin is moved along Y2 to the prong's inner face."""


class Linkage(NamedTuple):
    """An arm's joints, from the foot to the tip. Arrays are read-only.

    Attributes:
        links: (8,) in the order of `kinematics.linkage`: L1 to L5 [m]; two angles at zero joint angles [rad], from the
            boom line to the upper arm and from the boom line to the lower arm, positive upwards; and the kind of wrist.
        steps: (6, 3) vectors to each joint's centre at zero angles, in L [m]: the vector to the first joint begins at
            L's origin, and each other vector begins at the preceding joint.
        axes: for each joint, the axis of L, 1 to 3, about which the joint rotates at zero angles.
        frames: names of the frames that carry the arm's bodies: the foot (fixed in L), then one frame for each joint.
            The axes of a joint's frame are those of L, rotated by this joint and all joints before it. The
            origin is the joint's centre; for the last joint it is the centre of the preceding joint.
        end_effector_roll: the angle r in R_E = R_7 Rx(r) [rad].
    """

    links: Array
    steps: Array
    axes: Axes
    frames: Names
    end_effector_roll: float


def linkage_of(file: ArmFile) -> Linkage:
    """Return the linkage that a file describes."""
    return _of_yaw_arm(file) if isinstance(file, YawArmFile) else _of_heading_arm(file)


def raised(linkage: Linkage, height: float) -> Linkage:
    """Return the linkage with the shoulder pitch joint at the given height above L's origin [m]."""
    links, steps = linkage.links.copy(), linkage.steps.copy()
    links[0], steps[1, 2] = height, -height
    return linkage._replace(links=frozen(links), steps=frozen(steps))


def frozen(values: object) -> Array:
    """Return a read-only array of floats."""
    array = np.array(values, dtype=np.float64)
    array.setflags(write=False)
    return array


def _of_yaw_arm(file: YawArmFile) -> Linkage:
    """Return the linkage of an arm with the joints yaw, pitch, pitch, pitch, yaw, roll.

    The elbow may be above or below the boom line.
    """
    g = file.geometry
    height, wrist = g.shoulder_yaw_to_pitch.value, g.wrist_pitch_to_yaw.value
    (along2, drop2), (along3, drop3) = g.upper_arm.value, g.lower_arm.value
    upper, lower = length((along2, drop2)), length((along3, drop3))
    lift2, lift3 = -atan2(drop2, along2), -atan2(drop3, along3)
    return Linkage(
        frozen([height, upper, lower, wrist, g.wrist_yaw_to_tip.value, lift2, lift3, 1.0]),
        _steps(height, (along2, drop2), (along3, drop3), wrist),
        (3, 2, 2, 2, 3, 1),
        _frames("shoulder_yaw", "shoulder_pitch", "elbow_pitch", "wrist_pitch", "wrist_yaw", "wrist_roll"),
        float(g.end_effector_roll.value),
    )


def _of_heading_arm(file: HeadingArmFile) -> Linkage:
    """Return the linkage of an arm with the joints heading, pitch, pitch, heading, pitch, roll.

    The wrist's axes intersect in one point; the tip is on the palm's outer face.
    """
    height, palm = file.stand.start.value, file.effector.palm.value[1]
    upper, lower = file.geometry.upper_arm.value, file.geometry.lower_arm.value
    return Linkage(
        frozen([height, upper, lower, 0.0, palm, 0.0, 0.0, 0.0]),
        _steps(height, (upper, 0.0), (lower, 0.0), 0.0),
        (3, 2, 2, 3, 2, 1),
        _frames("shoulder_heading", "shoulder_pitch", "elbow_pitch", "wrist_heading", "wrist_pitch", "wrist_roll"),
        0.0,
    )


def _frames(a: str, b: str, c: str, d: str, e: str, f: str) -> Names:
    return "arm.base", f"arm.{a}", f"arm.{b}", f"arm.{c}", f"arm.{d}", f"arm.{e}", f"arm.{f}"


def _steps(height: float, upper: tuple[float, float], lower: tuple[float, float], wrist: float) -> Array:
    """Return `Linkage.steps` (6, 3), the vectors from joint to joint [m]; components: along the arm, 0, down."""
    vectors = [(0.0, 0.0), (0.0, -height), upper, lower, (wrist, 0.0), (0.0, 0.0)]
    return frozen([[along, 0.0, down] for along, down in vectors])
