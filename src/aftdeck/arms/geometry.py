"""Linkage of an arm: the values that laws and pictures use. They are computed from the lengths in the arm's file."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arms.chain import packed_chain
from aftdeck.arms.joints import Slide
from aftdeck.arms.model import ArmFile, ChainArmFile, HeadingArmFile, YawArmFile
from aftdeck.arms.rank import Joint
from aftdeck.arrays import Array
from aftdeck.elementary import atan2
from aftdeck.matrices import length

AXES = np.eye(3)
HEADING_PITCH_ROLL, PITCH_YAW_ROLL, GENERAL = 0.0, 1.0, 2.0
"""Kinds of wrist, the last of the eight links; `GENERAL`: any other chain, which has no closed form."""
NAMED = ("shoulder", "elbow", "wrist")
"""Singularities of the arms that have a closed form."""

FOOT = "arm.base"
"""Name of the frame that is fixed in L."""
STAND, PRONG = "arm.stand", "arm.prong"
"""Names of two additional frames of an arm with a telescope and a prong. The frame of the telescope's moving tube has
L's axes; its origin is on L's axis 3 at the shoulder's height. The prong's frame has the axes of the last joint's
frame; its origin is moved along Y2 to the prong's inner face."""


class Linkage(NamedTuple):
    """An arm's joints, from the foot to the tip. Arrays are read-only.

    Attributes:
        links: what the laws of the arm's solver need. With a closed form (8,), in the order of `kinematics.linkage`: L1
            to L5 [m]; two angles at zero joint angles [rad], from the boom line to the upper arm and from the boom line
            to the lower arm, positive upwards; and the kind of wrist.
        steps: (n, 3) vectors to each joint's centre at zero angles, in L [m]: the vector to the first joint begins at
            L's origin, and each other vector begins at the preceding joint.
        axes: (n, 3) unit vectors along the joints' axes at zero angles, in L.
        tip: (3,) vector from the last joint to the tip at zero angles, in L [m].
        frames: names of the frames that carry the arm's bodies: the foot (fixed in L), then one frame for each joint.
            The axes of a joint's frame are those of L, rotated by this joint and all joints before it. The
            origin is the joint's centre; for the last joint it is the centre of the preceding joint.
        end_effector_roll: the angle r in R_E = R_7 Rx(r) [rad].
        singularities: names of the singularities that the arm's solver tells apart.
        slides: for each joint, whether it slides along its axis; otherwise it turns about it.
    """

    links: Array
    steps: Array
    axes: Array
    tip: Array
    frames: tuple[str, ...]
    end_effector_roll: float
    singularities: tuple[str, ...] = NAMED
    slides: tuple[bool, ...] = (False,) * 6

    @property
    def arms(self) -> tuple[int, ...]:
        """Indices of the frames that carry the two longest links, and of the last frame: ARM 0, ARM 1 and ARM 2."""
        links = sorted(range(1, len(self.steps)), key=lambda k: -length(self.steps[k].tolist()))
        return (*sorted(links[:2]), len(self.steps))


def linkage_of(file: ArmFile) -> Linkage:
    """Return the linkage that a file describes."""
    if isinstance(file, ChainArmFile):
        return _of_chain(file)
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
        frozen([height, upper, lower, wrist, g.wrist_yaw_to_tip.value, lift2, lift3, PITCH_YAW_ROLL]),
        _steps(height, (along2, drop2), (along3, drop3), wrist),
        _axes(3, 2, 2, 2, 3, 1),
        frozen([g.wrist_yaw_to_tip.value, 0.0, 0.0]),
        frames_of("shoulder_yaw", "shoulder_pitch", "elbow_pitch", "wrist_pitch", "wrist_yaw", "wrist_roll"),
        float(g.end_effector_roll.value),
    )


def _of_heading_arm(file: HeadingArmFile) -> Linkage:
    """Return the linkage of an arm with the joints heading, pitch, pitch, heading, pitch, roll.

    The wrist's axes intersect in one point; the tip is on the palm's outer face.
    """
    height, palm = file.stand.start.value, file.effector.palm.value[1]
    upper, lower = file.geometry.upper_arm.value, file.geometry.lower_arm.value
    return Linkage(
        frozen([height, upper, lower, 0.0, palm, 0.0, 0.0, HEADING_PITCH_ROLL]),
        _steps(height, (upper, 0.0), (lower, 0.0), 0.0),
        _axes(3, 2, 2, 3, 2, 1),
        frozen([palm, 0.0, 0.0]),
        frames_of("shoulder_heading", "shoulder_pitch", "elbow_pitch", "wrist_heading", "wrist_pitch", "wrist_roll"),
        0.0,
    )


def _of_chain(file: ChainArmFile) -> Linkage:
    """Return the linkage of an arm without a closed form.

    Its array begins as that of an arm with a closed form, whose lengths it does not have.
    """
    tip = frozen(file.tip.value)
    joints = tuple(
        Joint(
            frozen(joint.step),
            frozen(joint.axis) / length(joint.axis),
            isinstance(joint, Slide),
            joint.weight,
            joint.hard,
        )
        for joint in file.joint
    )
    return Linkage(
        frozen(np.concatenate([[0.0] * 7, [GENERAL], packed_chain(joints, tip, file.turning)])),
        frozen([joint.step for joint in joints]),
        frozen([joint.axis for joint in joints]),
        tip,
        frames_of(*file.joints),
        0.0 if file.end_effector_roll is None else float(file.end_effector_roll.value),
        ("rank",),
        tuple(joint.slides for joint in joints),
    )


def frames_of(*joints: str) -> tuple[str, ...]:
    """Return the names of the frames of a linkage: the foot's, and one for each joint."""
    return FOOT, *(f"arm.{joint}" for joint in joints)


def _axes(*numbers: int) -> Array:
    """Return axes of L, numbered from 1, as unit vectors."""
    return frozen(AXES[[number - 1 for number in numbers]])


def _steps(height: float, upper: tuple[float, float], lower: tuple[float, float], wrist: float) -> Array:
    """Return `Linkage.steps` (6, 3), the vectors from joint to joint [m]; components: along the arm, 0, down."""
    vectors = [(0.0, 0.0), (0.0, -height), upper, lower, (wrist, 0.0), (0.0, 0.0)]
    return frozen([[along, 0.0, down] for along, down in vectors])
