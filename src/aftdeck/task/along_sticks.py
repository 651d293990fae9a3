"""Remaining motion, along and about the axes in which the hand controllers act."""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.bodies.placed import along_axes, motions_along, twist_along
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.readings.reading import Along
from aftdeck.steering.mode import MODES
from aftdeck.task.remaining import Remaining
from aftdeck.tuples import Rows, Vec3


class AlongSticks(NamedTuple):
    """Remaining motion.

    Attributes:
        translation: displacement of the point of resolution along the THC's axes [m].
        rotation: rotation vector about the RHC's axes [rad].
    """

    translation: Vec3
    rotation: Vec3


def along_sticks(remaining: Remaining, frame: Frame, axes: tuple[Rows, Rows]) -> AlongSticks | None:
    """Return the remaining motion along the sticks; None if a joint has to move, or the mode has no sticks.

    Args:
        remaining: the remaining motion.
        frame: the frame.
        axes: axes of the THC and of the RHC, in L, in columns.
    """
    if remaining.motion is None or MODES[frame.mode].kind != "manual":
        return None
    return AlongSticks(*along_axes(*remaining.motion, frame.resolution, *axes))


def seen_along(frame: Frame, remaining: Remaining | None, axes: tuple[Rows, Rows]) -> Along:
    """Return what a policy sees of the motion, whatever the mode; arguments as for `along_sticks`."""
    if remaining is None or remaining.motion is None:
        return Along(_NONE, _NONE, *twist_along(frame.twist, *axes))
    return Along(*motions_along(*remaining.motion, frame.resolution, frame.twist, *axes))


_NONE = (0.0, 0.0, 0.0)
