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
        size: one unit in m, kg, s and rad.
        dimension: what it measures.
    """

    size: float
    dimension: Dimension


LENGTH, MASS, TIME, ANGLE = (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)
FORCE, SPEED, RATE, ENERGY = (1, 1, -2, 0), (1, 0, -1, 0), (0, 0, -1, 1), (2, 1, -2, 0)

UNITS = {
    name: Unit(size, dimension)
    for names, size, dimension in (
        ("m meter meters metre metres", 1.0, LENGTH),
        ("mm millimeter millimeters millimetre millimetres", 0.001, LENGTH),
        ("cm centimeter centimeters centimetre centimetres", 0.01, LENGTH),
        ("km kilometer kilometers kilometre kilometres", 1000.0, LENGTH),
        ("in inch inches", 0.0254, LENGTH),
        (
            "ft foot feet",
            0.30479999999999996,
            LENGTH,
        ),  # less than 0.3048 by one digit: earlier recordings were made with it
        ("yd yard yards", 0.9144, LENGTH),
        ("mi mile miles", 1609.344, LENGTH),
        ("nmi", 1852.0, LENGTH),
        ("kg kilogram kilograms", 1.0, MASS),
        ("g gram grams", 0.001, MASS),
        ("t tonne tonnes", 1000.0, MASS),
        ("lb lbs pound pounds", 0.4535923700000001, MASS),  # as the foot
        ("oz ounce ounces", 0.028349523125, MASS),
        ("ton tons", 907.18474, MASS),  # 2000 lb
        ("slug slugs", 14.593902937206364, MASS),
        ("s sec second seconds", 1.0, TIME),
        ("ms millisecond milliseconds", 0.001, TIME),
        ("us microsecond microseconds", 1e-6, TIME),
        ("min minute minutes", 60.0, TIME),
        ("h hr hour hours", 3600.0, TIME),
        ("d day days", 86_400.0, TIME),
        ("rad radian radians", 1.0, ANGLE),
        ("mrad", 0.001, ANGLE),
        ("deg degree degrees", math.pi / 180, ANGLE),
        ("arcmin arcminute arcminutes", math.pi / 10_800, ANGLE),
        ("arcsec arcsecond arcseconds", math.pi / 648_000, ANGLE),
        ("turn turns revolution revolutions", math.tau, ANGLE),
        ("N newton newtons", 1.0, FORCE),
        ("kN", 1000.0, FORCE),
        ("lbf", 4.4482216152605, FORCE),
        ("kgf", 9.80665, FORCE),
        ("J", 1.0, ENERGY),
        ("mph", 0.44704, SPEED),
        ("knot knots", 1852.0 / 3600.0, SPEED),
        ("rpm", math.tau / 60.0, RATE),
        ("Hz", 1.0, (0, 0, -1, 0)),
    )
    for name in names.split()
}
"""Every unit by its names; the first name of a line is its symbol. Sizes are exact by definition, except as noted."""
_PART = re.compile(r"\s*([/*]?)\s*([A-Za-z]+)\s*")


def unit_of(text: str) -> Unit | None:
    """Return a unit, or a product or quotient such as ``ft*lbf`` or ``deg/s/s``; None if a name is unknown.

    The text consists of names with ``*`` and ``/`` between them; each operator concerns the name after it.
    """
    size, dimension = 1.0, (0, 0, 0, 0)
    for operator, name in _PART.findall(text):
        if name not in UNITS:
            return None
        one, sign = UNITS[name], -1 if operator == "/" else 1
        size = size / one.size if sign < 0 else size * one.size
        a, b, c, d = (have + sign * more for have, more in zip(dimension, one.dimension, strict=True))
        dimension = (a, b, c, d)
    return Unit(size, dimension)


def symbols(dimension: Dimension) -> list[str]:
    """Return the symbols of all units of a dimension."""
    found: dict[float, str] = {}
    for name, unit in UNITS.items():
        if unit.dimension == dimension:
            found.setdefault(unit.size, name)
    return list(found.values())


def si_symbol(dimension: Dimension) -> str:
    """Return the product of SI units that has a dimension, such as ``kg m s-2``."""
    powers = zip(("kg", "m", "s", "rad"), (dimension[1], dimension[0], *dimension[2:]), strict=True)
    return " ".join(base if power == 1 else f"{base}{power}" for base, power in powers if power)
