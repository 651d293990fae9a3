"""Conversion of the remaining motion to the axes of the sticks, and to the scene."""

from __future__ import annotations

from aftdeck.scene.everything import ScenePoses
from aftdeck.simulation.frame import Frame
from aftdeck.station.messages.frame import ToGo
from aftdeck.task.along_sticks import along_sticks
from aftdeck.task.remaining import Remaining
from aftdeck.tuples import Rows


def to_go(
    remaining: Remaining, frame: Frame, scene: ScenePoses, axes: tuple[Rows, Rows], closing: float | None = None
) -> ToGo:
    """Return the message about the remaining motion in a frame.

    Args:
        remaining: the remaining motion.
        frame: the frame.
        scene: poses in the scene.
        axes: axes of the THC and of the RHC, in L, in columns.
        closing: speed at which the distance becomes smaller [m/s]; None if it is not known.
    """
    translation, rotation = along_sticks(remaining, frame, axes) or (None, None)
    shift = () if remaining.motion is None else scene.motion(remaining.motion)
    return ToGo(
        remaining.to, translation, rotation, remaining.distance, remaining.angle, remaining.near, closing, shift
    )
