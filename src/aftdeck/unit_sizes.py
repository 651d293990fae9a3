"""Units that files may use: size in SI units and dimension of each, and of their products and quotients."""

from __future__ import annotations

import math
import re
from typing import NamedTuple

Dimension = tuple[int, int, int, int]
"""Exponents of length, mass, time and angle. An angle counts as a dimension, so that 5 Hz is not read as 5 rad/s."""


class Unit(NamedTuple):
    """Unit of measurement.

    Attributes:
        names: its names; the first one is its symbol.
        size: one unit in m, kg, s and rad.
        dimension: what it measures.
    """

    names: tuple[str, ...]
    size: float
    dimension: Dimension


LENGTH, MASS, TIME, ANGLE = (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)
FORCE, SPEED, RATE, ENERGY = (1, 1, -2, 0), (1, 0, -1, 0), (0, 0, -1, 1), (2, 1, -2, 0)

FOOT, POUND = 0.30479999999999996, 0.4535923700000001
"""Sizes that differ from the exact ones in the last digit: recordings were made with them."""

TABLE = (
    Unit(("m", "meter", "meters", "metre", "metres"), 1.0, LENGTH),
    Unit(("mm", "millimeter", "millimeters", "millimetre", "millimetres"), 0.001, LENGTH),
    Unit(("cm", "centimeter", "centimeters", "centimetre", "centimetres"), 0.01, LENGTH),
    Unit(("km", "kilometer", "kilometers", "kilometre", "kilometres"), 1000.0, LENGTH),
    Unit(("in", "inch", "inches"), 0.0254, LENGTH),
    Unit(("ft", "foot", "feet"), FOOT, LENGTH),
    Unit(("yd", "yard", "yards"), 0.9144, LENGTH),
    Unit(("mi", "mile", "miles"), 1609.344, LENGTH),
    Unit(("nmi",), 1852.0, LENGTH),
    Unit(("kg", "kilogram", "kilograms"), 1.0, MASS),
    Unit(("g", "gram", "grams"), 0.001, MASS),
    Unit(("t", "tonne", "tonnes"), 1000.0, MASS),
    Unit(("lb", "lbs", "pound", "pounds"), POUND, MASS),
    Unit(("oz", "ounce", "ounces"), 0.028349523125, MASS),
    Unit(("ton", "tons"), 2000 * 0.45359237, MASS),
    Unit(("slug", "slugs"), 14.593902937206364, MASS),
    Unit(("s", "sec", "second", "seconds"), 1.0, TIME),
    Unit(("ms", "millisecond", "milliseconds"), 0.001, TIME),
    Unit(("us", "microsecond", "microseconds"), 1e-6, TIME),
    Unit(("min", "minute", "minutes"), 60.0, TIME),
    Unit(("h", "hr", "hour", "hours"), 3600.0, TIME),
    Unit(("d", "day", "days"), 86_400.0, TIME),
    Unit(("rad", "radian", "radians"), 1.0, ANGLE),
    Unit(("mrad",), 0.001, ANGLE),
    Unit(("deg", "degree", "degrees"), math.pi / 180, ANGLE),
    Unit(("arcmin", "arcminute", "arcminutes"), math.pi / 10_800, ANGLE),
    Unit(("arcsec", "arcsecond", "arcseconds"), math.pi / 648_000, ANGLE),
    Unit(("turn", "turns", "revolution", "revolutions"), math.tau, ANGLE),
    Unit(("N", "newton", "newtons"), 1.0, FORCE),
    Unit(("kN",), 1000.0, FORCE),
    Unit(("lbf",), 4.4482216152605, FORCE),
    Unit(("kgf",), 9.80665, FORCE),
    Unit(("J",), 1.0, ENERGY),
    Unit(("mph",), 0.44704, SPEED),
    Unit(("knot", "knots"), 1852.0 / 3600.0, SPEED),
    Unit(("rpm",), math.tau / 60.0, RATE),
    Unit(("Hz",), 1.0, (0, 0, -1, 0)),
)
"""All units. Sizes are exact by definition, except as noted."""
UNITS = {name: unit for unit in TABLE for name in unit.names}
"""Units by their names."""
_PART = re.compile(r"\s*([/*]?)\s*([A-Za-z]+)\s*")


def size_of(text: str) -> tuple[float, Dimension] | None:
    """Return size and dimension of a unit, or of a product or quotient such as ``ft*lbf`` or ``deg/s/s``.

    The text consists of names with ``*`` and ``/`` between them; each operator concerns the name after it. None if a
    name is unknown.
    """
    size, dimension = 1.0, (0, 0, 0, 0)
    for operator, name in _PART.findall(text):
        if name not in UNITS:
            return None
        one, sign = UNITS[name], -1 if operator == "/" else 1
        size = size / one.size if sign < 0 else size * one.size
        a, b, c, d = (have + sign * more for have, more in zip(dimension, one.dimension, strict=True))
        dimension = (a, b, c, d)
    return size, dimension


def symbols(dimension: Dimension) -> list[str]:
    """Return the symbols of all units of a dimension."""
    return [unit.names[0] for unit in TABLE if unit.dimension == dimension]


def si_symbol(dimension: Dimension) -> str:
    """Return the product of SI units that has a dimension, such as ``kg m s-2``."""
    powers = zip(("kg", "m", "s", "rad"), (dimension[1], dimension[0], *dimension[2:]), strict=True)
    return " ".join(base if power == 1 else f"{base}{power}" for base, power in powers if power)
