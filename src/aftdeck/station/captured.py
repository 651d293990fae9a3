"""How the hand stood to a payload when it took hold of it."""

from __future__ import annotations

import math
from typing import NamedTuple

from aftdeck.simulation.frame import Frame
from aftdeck.worksite.report import Cargo

_OFF = ("pin off axis", "palm along bar")
"""The conditions of snares and of the prong that say how far beside its middle the hand takes hold."""


class Captured(NamedTuple):
    """How the hand stood to what it took.

    Attributes:
        offset: how far it was beside its middle [m]; None: this hand has no such condition.
        angle: the largest of its angles to it [rad]; None: likewise.
        rate: of the tip against it [m/s].
    """

    offset: float | None = None
    angle: float | None = None
    rate: float = 0.0


def captured(before: Frame, cargo: Cargo) -> Captured:
    """How the hand stood, of the frame before a cargo was held and the cargo in it."""
    conditions = before.work.conditions
    return Captured(
        next((abs(c.value) for c in conditions if c.name in _OFF), None),
        max((abs(c.value) for c in conditions if c.unit == "rad"), default=None),
        math.dist(before.twist[3:], cargo.velocity),
    )
