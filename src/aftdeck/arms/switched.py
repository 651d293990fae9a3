"""Joints that switches of the panel drive: a telescope that carries the arm, and the prong of an end effector.

They are not among the joints that steering moves, and have no joint angles.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from aftdeck.arms.geometry import frame_of, frozen
from aftdeck.arms.joints import Slide, Switch
from aftdeck.arms.model import ArmFile
from aftdeck.arrays import Array
from aftdeck.matrices import length

TELESCOPE: Switch = "telescope"
"""Switch that drives the joint under the arm, `ArmModel.telescope`; `Inputs.telescope` is its position."""
PRONG: Switch = "prong"
"""Switch of the end effector, which drives the joint `ArmModel.prong`."""


class Drive(NamedTuple):
    """Drive of a joint that slides.

    Attributes:
        gain: force for each m/s of speed error [N s/m].
        force: greatest force [N].
    """

    gain: float
    force: float


class SwitchedJoint(NamedTuple):
    """Joint that slides along its axis, driven by a switch.

    The coordinate of a telescope is the height of the shoulder above L's origin; that of a prong is y2 of its inner
    face, which is 0 at the palm's centre line.

    Attributes:
        name: name of the joint.
        driver: the switch.
        frame: name of the frame that moves with the joint.
        carrier: name of the frame that carries the joint. At coordinate 0, both frames coincide.
        axis: (3,) unit vector in which the frame moves, in the carrier's frame. Read-only.
        least: least coordinate [m].
        greatest: greatest coordinate [m].
        start: coordinate with which a run begins [m].
        rate: speed at full drive [m/s].
        facing: coordinate of the fixed face towards which a prong closes [m]; infinite if there is none.
        drive: its drive; None if the file does not describe it.
    """

    name: str
    driver: Switch
    frame: str
    carrier: str
    axis: Array
    least: float
    greatest: float
    start: float
    rate: float
    facing: float
    drive: Drive | None


def switched_of(file: ArmFile) -> tuple[SwitchedJoint, ...]:
    """Return the joints of a file's arm that switches drive, in the order of the file."""
    return tuple(_switched(file, joint, joint.driver) for joint in file.switched if joint.driver is not None)


def carrier_of(file: ArmFile, joint: Slide) -> str | None:
    """Return the name of the joint that carries a joint; None for the foot."""
    before = [other.name for other in file.joint[: file.joint.index(joint)]]
    return joint.on or (before[-1] if before else None)


def _switched(file: ArmFile, joint: Slide, driver: Switch) -> SwitchedJoint:
    drive = None
    if joint.gain is not None and joint.force is not None:
        drive = Drive(float(joint.gain.value), float(joint.force.value))
    return SwitchedJoint(
        joint.name,
        driver,
        frame_of(joint.name),
        frame_of(carrier_of(file, joint)),
        frozen(frozen(joint.axis) / length(joint.axis)),
        *joint.travel(),
        math.inf if joint.facing is None else float(joint.facing.value),
        drive,
    )
