"""What an arm has besides its six joints: a telescope under it, what its hand takes hold with, a master arm's axes.

What is flown, drawn and checked asks for these, not for the family of the arm.
"""

from __future__ import annotations

from typing import Literal, NamedTuple

from aftdeck.arms.model import ArmFile, HeadingArmFile

Axis = Literal["RHC roll", "RHC pitch", "RHC yaw", "THC X", "THC Y", "THC Z"]


class Telescope(NamedTuple):
    """The telescope that an arm stands on; its length is the height of the shoulder above L's origin.

    Attributes:
        least: length [m].
        greatest: length [m].
        rate: of full drive [m/s].
    """

    least: float
    greatest: float
    rate: float


class Prong(NamedTuple):
    """A prong that closes towards a fixed finger; y2 of their inner faces, 0 at the palm's centre line.

    Attributes:
        opened: of the prong, open [m].
        closed: of the prong, closed [m].
        fixed_finger: of the fixed finger [m].
        rate: of the prong [m/s].
    """

    opened: float
    closed: float
    fixed_finger: float
    rate: float


class Equipment(NamedTuple):
    """What an arm has besides its joints.

    Attributes:
        telescope: None: it stands on none.
        prong: of its hand; None: the hand has snares.
        master: the axis of the hand controllers that turns each joint of the master arm, where no device gives its
            angles. The RHC's turn the wrist's joints that move as they do.
        covered: whether its solids cover round parts from outside, so that they overlap where a joint holds them.
    """

    telescope: Telescope | None
    prong: Prong | None
    master: tuple[Axis, ...]
    covered: bool


def equipment_of(file: ArmFile) -> Equipment:
    """Return what the arm of a file has."""
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
