"""Structs for lanes and strips. They cover a whole recording, or the last minutes of a live run."""

from __future__ import annotations

from typing import Literal

import msgspec

from aftdeck.simulation.readings.quantity import Quantity
from aftdeck.worksite.watch.alarm import Level


class Stretch(msgspec.Struct, frozen=True):
    """Interval of a lane in which the label and the level do not change."""

    start_s: float
    end_s: float
    label: str
    """State in this interval; empty if the lane shows nothing."""
    level: Level


class Lane(msgspec.Struct, frozen=True):
    """Row of consecutive intervals, up to the last frame."""

    name: str
    stretches: tuple[Stretch, ...]


class Curve(msgspec.Struct, frozen=True):
    """Curve of a strip, with fewer points than steps; it keeps every peak."""

    role: Literal["actual", "commanded"]
    times_s: tuple[float, ...]
    values: tuple[float | None, ...]
    """Values at `times_s`; null where the quantity had no value."""


class Strip(msgspec.Struct, frozen=True):
    """Strip chart of one quantity over the run."""

    name: str
    quantity: Quantity
    curves: tuple[Curve, ...]
    low: float
    high: float
    """`low` and `high`: least and greatest value; the range includes zero if `rests` is true."""
    limit: float | None
    """Limit that the page draws as a line across the strip; null if the quantity has no limit."""
    caution: float | None
    """Threshold below which a value causes a caution, such as a clearance threshold; null if not applicable."""
    warning: float | None
    """Threshold below which a value causes a warning; null if not applicable."""
    shown: bool
    """True if the page draws the strip before the user selects strips."""
    rests: bool
    """True if zero is the value at rest; the drawn range then includes zero."""
