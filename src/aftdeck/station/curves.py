"""What lanes and strips are made of: of a whole recording, or of a flight's last minutes."""

from __future__ import annotations

from typing import Literal

import msgspec

from aftdeck.worksite.alarm import Level

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
"""What a number is, from which the page takes its unit: a length or a gap in inches where the operator reads inches, a
distance in feet; a share in per cent."""


class Stretch(msgspec.Struct, frozen=True):
    """A part of a lane through which one thing was so."""

    start_s: float
    end_s: float
    label: str
    """What was so; empty: nothing that this lane tells of."""
    level: Level


class Lane(msgspec.Struct, frozen=True):
    """A row of stretches that follow one another from the run's beginning to its end."""

    name: str
    stretches: tuple[Stretch, ...]


class Curve(msgspec.Struct, frozen=True):
    """A line of a strip, thinned so that no peak is lost."""

    role: Literal["actual", "commanded"]
    times_s: tuple[float, ...]
    values: tuple[float | None, ...]
    """None: there was no such thing."""


class Strip(msgspec.Struct, frozen=True):
    """A quantity over the run."""

    name: str
    quantity: Quantity
    curves: tuple[Curve, ...]
    low: float
    high: float
    """Range of all values, with zero in it where zero means rest."""
    limit: float | None
    """A bound to draw across it."""
    caution: float | None
    """Values below this are cautioned of; of a clearance, as the scenario has it."""
    warning: float | None
    """Values below this are warned of."""
    shown: bool
    """Drawn until the reader chooses others."""
    rests: bool
    """Zero means rest, and belongs into the picture."""
