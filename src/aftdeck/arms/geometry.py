"""Linkage of an arm: the values that laws and pictures use. They are computed from the lengths in the arm's file."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arms.chain import PLACE, packed_chain
from aftdeck.arms.joints import Slide
from aftdeck.arms.model import ArmFile
from aftdeck.arms.rank import Joint
from aftdeck.arrays import Array
from aftdeck.elementary import atan2
from aftdeck.matrices import length

AXES = np.eye(3)
HEADING_PITCH_ROLL, PITCH_YAW_ROLL, GENERAL = 0.0, 1.0, 2.0
"""Kinds of wrist, the last of the eight links; `GENERAL`: any other chain, which has no closed form."""
CLOSED = 8
"""Number of links of a closed form; the packed chain of any other arm begins there."""
NAMED = ("shoulder", "elbow", "wrist")
"""Singularities of the arms that have a closed form."""

FOOT = "arm.base"
"""Name of the frame that is fixed in L."""
_WRISTS = {PITCH_YAW_ROLL: (2, 1, 1, 1, 2, 0), HEADING_PITCH_ROLL: (2, 1, 1, 2, 1, 0)}
"""Numbers of the joints' axes, from the foot to the tip, by the kind of wrist of a closed form."""
_FREE = np.array(
    [[0, 0, 1], [0, 0, 1], [1, 0, 1], [1, 0, 1], [1, 0, 0], [0, 0, 0], [1, 0, 0]],
    dtype=np.bool_,
)
"""Components that can differ from 0 in a chain with a closed form: of the steps to its six joints, and of its tip."""


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
            The axes of a joint's frame are those of L, rotated by this joint and all joints before it; the
            origin is the joint's centre.
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
    singularities: tuple[str, ...]
    slides: tuple[bool, ...]

    @property
    def arms(self) -> tuple[int, ...]:
        """Indices of the frames that carry the two longest links, and of the last frame: ARM 0, ARM 1 and ARM 2."""
        links = sorted(range(1, len(self.steps)), key=lambda k: -length(self.steps[k].tolist()))
        return (*sorted(links[:2]), len(self.steps))


def linkage_of(file: ArmFile) -> Linkage:
    """Return the linkage that a file describes, with a closed form if the chain of its joints has one.

    The array of any other chain begins as that of a closed form; it has only the height of a telescope.
    """
    steered, tip = file.steered, frozen(file.tip.value)
    axes = frozen([frozen(joint.axis) / length(joint.axis) for joint in steered])
    steps = np.array([joint.step for joint in steered], dtype=np.float64)
    first = file.joint[0]
    height = first.travel().start if isinstance(first, Slide) and first.driver else 0.0  # of a telescope
    steps[0, 2] -= height
    hard = frozen([joint.hard for joint in steered]).tolist()
    closed = not any(file.slides) and all(joint.weight == 1.0 for joint in steered)
    links = closed_form(steps, axes, tip) if closed else None
    if links is None:
        joints = tuple(
            Joint(frozen(step), axis, slides, joint.weight, (low, high))
            for step, axis, slides, joint, (low, high) in zip(steps, axes, file.slides, steered, hard, strict=True)
        )
        links = np.concatenate([[height], [0.0] * 6, [GENERAL], packed_chain(joints, tip, file.turning)])
    return Linkage(
        frozen(links),
        frozen(steps),
        axes,
        tip,
        (FOOT, *(frame_of(joint.name) for joint in steered)),
        0.0 if file.end_effector_roll is None else float(file.end_effector_roll.value),
        ("rank",) if links[7] == GENERAL else NAMED,
        file.slides,
    )


def closed_form(steps: Array, axes: Array, tip: Array) -> Array | None:
    """Return what the laws of a closed form need, as `Linkage.links`; None if they cannot serve this chain.

    They serve a yaw (or heading) on L's axis 3 and two pitches, whose links lie in one plane; then a wrist with pitch,
    yaw and roll, or one with heading, pitch and roll whose axes meet in one point.

    Args:
        steps: (n, 3) as `Linkage.steps`.
        axes: (n, 3) unit vectors along the joints' axes.
        tip: (3,) vector from the last joint to the tip [m].
    """
    wrist = next((kind for kind, numbers in _WRISTS.items() if np.array_equal(axes, AXES[list(numbers)])), None)
    if wrist is None or np.any(np.vstack([steps, tip])[~_FREE]):
        return None
    height, wrist_link, hand = -(steps[0, 2] + steps[1, 2]), steps[4, 0], tip[0]
    (along2, _, drop2), (along3, _, drop3) = steps[2].tolist(), steps[3].tolist()
    if min(height, wrist_link, hand) < 0.0 or min(along2, along3) <= 0.0:
        return None
    if wrist == HEADING_PITCH_ROLL and (drop2 or drop3 or wrist_link):
        return None
    lifts = [-atan2(drop2, along2), -atan2(drop3, along3)] if wrist == PITCH_YAW_ROLL else [0.0, 0.0]
    lengths = [height, length((along2, drop2)), length((along3, drop3)), wrist_link, hand]
    return np.array([*lengths, *lifts, wrist])


def raised(linkage: Linkage, height: float) -> Linkage:
    """Return the linkage with its first joint, which a telescope carries, at a height above L's origin [m]."""
    links, steps = linkage.links.copy(), linkage.steps.copy()
    links[0], steps[0, 2] = height, -height
    if links[7] == GENERAL:
        links[CLOSED + PLACE + 2] = -height
    return linkage._replace(links=frozen(links), steps=frozen(steps))


def frozen(values: object) -> Array:
    """Return a read-only array of floats."""
    array = np.array(values, dtype=np.float64)
    array.setflags(write=False)
    return array


def frame_of(joint: str | None) -> str:
    """Return the name of the frame behind a joint; None: of the foot's frame."""
    return FOOT if joint is None else f"arm.{joint}"
