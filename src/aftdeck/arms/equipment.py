"""Equipment of an arm besides its joints: telescope, prong of the end effector, and axes of the master arm.

Simulation, drawing and checks use this description of the equipment. They need not know the family of the arm.
"""

from __future__ import annotations

from typing import Literal, NamedTuple

from aftdeck.arms.model import ArmFile, HeadingArmFile

Axis = Literal["RHC roll", "RHC pitch", "RHC yaw", "THC X", "THC Y", "THC Z"]


class Telescope(NamedTuple):
    """Telescope under an arm. Its length is the height of the shoulder above L's origin.

    Attributes:
        least: least length [m].
        greatest: greatest length [m].
        rate: rate at full drive [m/s].
    """

    least: float
    greatest: float
    rate: float


class Prong(NamedTuple):
    """Prong that closes towards a fixed finger.

    Each position is the coordinate y2 of an inner face; y2 is 0 at the palm's centre line.

    Attributes:
        opened: position of the open prong [m].
        closed: position of the closed prong [m].
        fixed_finger: position of the fixed finger [m].
        rate: speed of the prong [m/s].
    """

    opened: float
    closed: float
    fixed_finger: float
    rate: float


class Equipment(NamedTuple):
    """Equipment of an arm besides its joints.

    Attributes:
        telescope: telescope under the arm; None if the arm has no telescope.
        prong: prong of the end effector; None if the end effector has snares.
        master: for each joint of the master arm, the axis of the hand controllers that moves the joint; None if no axis
            moves it. These axes are used if no other device gives the master arm's angles. Each RHC axis moves the
            wrist joint that rotates about the same axis.
        covered: whether the arm's solids are covers that enclose round parts. If so, neighbouring solids overlap at
            joints.
    """

    telescope: Telescope | None
    prong: Prong | None
    master: tuple[Axis | None, ...]
    covered: bool


def equipment_of(file: ArmFile) -> Equipment:
    """Return the equipment of a file's arm."""
    shoulder_and_elbow: tuple[Axis, ...] = ("THC Y", "THC X", "THC Z")
    if not isinstance(file, HeadingArmFile):
        return Equipment(None, None, (*shoulder_and_elbow, "RHC pitch", "RHC yaw", "RHC roll"), covered=True)
    stand, hand = file.stand, file.effector
    return Equipment(
        Telescope(float(stand.least.value), float(stand.greatest.value), float(stand.rate.value)),
        Prong(
            float(hand.prong_open.value),
            float(hand.prong_closed.value),
            float(hand.fixed_finger.value),
            float(hand.prong_rate.value),
        ),
        (*shoulder_and_elbow, "RHC yaw", "RHC pitch", "RHC roll"),
        covered=False,
    )
