"""Misalignment and speed of the end effector relative to a payload at capture."""

from __future__ import annotations

import math
from typing import NamedTuple

from aftdeck.simulation.frame import Frame
from aftdeck.worksite.report import Cargo

_OFFSETS = ("pin off axis", "palm along bar")
"""Conditions that measure the end effector's offset from the grapple pin (snares) or from the bar's middle (prong)."""


class CaptureMisalignment(NamedTuple):
    """Misalignment and speed of the end effector relative to the payload at capture.

    Attributes:
        offset: distance off centre [m]; None if no capture condition of this end effector measures a distance.
        angle: largest angle between end effector and payload [rad]; None if no capture condition measures an angle.
        rate: speed of the tip relative to the payload [m/s].
    """

    offset: float | None = None
    angle: float | None = None
    rate: float = 0.0


def capture_misalignment(before: Frame, cargo: Cargo) -> CaptureMisalignment:
    """Return the misalignment at a capture.

    Args:
        before: last frame before the capture.
        cargo: the payload in that frame.
    """
    conditions = before.work.conditions
    return CaptureMisalignment(
        next((abs(c.value) for c in conditions if c.name in _OFFSETS), None),
        max((abs(c.value) for c in conditions if c.unit == "rad"), default=None),
        math.dist(before.twist[3:], cargo.velocity),
    )
