"""Common base classes, types and checks of the tables in a worksite's file."""

from __future__ import annotations

from typing import Annotated

import msgspec

from aftdeck.units import Angle, Length, Quantity

Text = Annotated[str, msgspec.Meta(min_length=1)]
Point = tuple[Length, Length, Length]
Turn = tuple[Angle, Angle, Angle]
"""Roll, pitch, yaw about fixed x, y, z, applied in that order."""
Range = tuple[Length, Length]
"""Lower end, then upper end."""


class Table(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A table of a worksite file."""


class Placed(Table, frozen=True, kw_only=True):
    """A table with a pose in the axes of the body to which the table belongs."""

    position: Point = (Length(0.0), Length(0.0), Length(0.0))
    rotation: Turn = (Angle(0.0), Angle(0.0), Angle(0.0))


def positive(**sizes: Quantity | None) -> None:
    """Reject a quantity that is not above zero (ValueError with its name); None is accepted."""
    for name, value in sizes.items():
        if value is not None and not value > 0.0:
            raise ValueError(f"{name} is {value:g} {value.unit}; it has to be above 0")


def ordered(**ranges: Range) -> None:
    """Reject a range whose lower end is not less than its upper end (ValueError with its name)."""
    for name, (low, high) in ranges.items():
        if not low < high:
            raise ValueError(f"{name} is from {low:g} to {high:g} m; the first has to be less")
