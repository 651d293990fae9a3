"""Elements of lanes and strips, for a whole recording or for the last minutes of a live run."""

from __future__ import annotations

from typing import Literal

import msgspec

from aftdeck.worksite.watch.alarm import Level

Quantity = Literal[
    "time",
    "count",
    "share",
    "part of limit",
    "ratio",
    "length",
    "gap",
    "distance",
    "angle",
    "speed",
    "turn rate",
    "milliseconds",
    "words",
]
"""Kind of a number, from which the page chooses its unit.

Where the operator reads inches, a length or a gap is shown in inches and a distance in feet. A share is shown in per
cent.
"""


class Stretch(msgspec.Struct, frozen=True):
    """Stretch of a lane: an interval in which the label and the level do not change."""

    start_s: float
    end_s: float
    label: str
    """State during the stretch; empty if the lane has nothing to show."""
    level: Level


class Lane(msgspec.Struct, frozen=True):
    """Row of consecutive stretches, up to the last frame."""

    name: str
    stretches: tuple[Stretch, ...]


class Curve(msgspec.Struct, frozen=True):
    """Line of a strip, thinned so that no peak is lost."""

    role: Literal["actual", "commanded"]
    times_s: tuple[float, ...]
    values: tuple[float | None, ...]
    """None where the quantity had no value."""


class Strip(msgspec.Struct, frozen=True):
    """Strip chart of one quantity over the run."""

    name: str
    quantity: Quantity
    curves: tuple[Curve, ...]
    low: float
    high: float
    """`low` and `high`: range of all values, including zero if zero means rest."""
    limit: float | None
    """Limit to draw as a line across the strip; None if there is none."""
    caution: float | None
    """Values below this one cause a caution; for a clearance, the scenario's threshold. None if there is none."""
    warning: float | None
    """Values below this one cause a warning; None if there is none."""
    shown: bool
    """True if the strip is drawn until the reader chooses other strips."""
    rests: bool
    """True if zero means rest; the drawn range then includes zero."""
