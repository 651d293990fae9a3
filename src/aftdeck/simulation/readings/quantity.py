"""Kinds of numbers, each with its SI unit."""

from __future__ import annotations

from typing import Literal, get_args

Quantity = Literal[
    "time",
    "seconds",
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
    "force",
    "impulse",
    "torque",
    "milliseconds",
    "words",
]
"""Kind of a number, from which the page chooses its unit.

A page that shows feet and inches shows "length" and "gap" in inches, and "distance" in feet. Every page shows "share"
in per cent. It shows "time" as minutes and seconds.
"""

UNITS: dict[Quantity, str] = dict.fromkeys(get_args(Quantity), "") | {
    "time": "s",
    "seconds": "s",
    "length": "m",
    "gap": "m",
    "distance": "m",
    "angle": "rad",
    "speed": "m/s",
    "turn rate": "rad/s",
    "force": "N",
    "impulse": "N s",
    "torque": "N m",
    "milliseconds": "ms",
}
"""SI unit of each quantity; empty for a number without a unit, and for a text."""
SLID: dict[Quantity, Quantity] = {"angle": "length", "turn rate": "speed", "torque": "force"}
"""Quantity of a joint that slides, for the quantities of a joint that turns."""
