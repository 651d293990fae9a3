"""Plausible range of a constant in a file, declared in the type of the constant's field, with the reason.

The ranges are wide: they contain the Shuttle's arm, Canadarm2 and Dextre, ERA, JEMRMS, the concept arm of 1972, arms of
a few centimetres on small satellites, and structures of 100 m. What is outside is a slip of the hand or of a unit, and
could not be computed with the accuracy that the program promises. `aftdeck.schema_check` checks the ranges.
"""

from __future__ import annotations

from typing import NamedTuple


class Bounds(NamedTuple):
    """Plausible range of a number; a field declares it as ``Annotated[Length, Bounds(0.001, 200.0, "…")]``.

    Attributes:
        least: least plausible value, in the SI unit of the field.
        greatest: greatest plausible value.
        reason: comparison with a real thing; it ends the sentence of the error message.
        unit: unit of a plain number; a `units.Quantity` has its own unit.
    """

    least: float
    greatest: float
    reason: str
    unit: str = ""

    def problem(self, value: float, unit: str) -> str:
        """Return the error message about a value outside the range; "" if the value is inside it."""
        if self.least <= value <= self.greatest:
            return ""
        unit = f" {unit or self.unit}".rstrip()
        return f"got {value:g}{unit}; expected {self.least:g} to {self.greatest:g}{unit}, because {self.reason}"


COORDINATE = Bounds(-1000.0, 1000.0, "the widest structure in orbit, the ISS, measures 109 m", "m")
"""Range of a position or a size, also of a plain number [m]."""
DIRECTION = Bounds(-1000.0, 1000.0, "only the direction of the vector counts, so that its components can be near 1")
"""Range of a component of a vector of any length."""
ROTATION = Bounds(-62.84, 62.84, "more than ten revolutions repeat an attitude", "rad")
"""Range of an angle, also of a plain number [rad]."""
COMPONENT = Bounds(-1.001, 1.001, "the rows of a rotation matrix are unit vectors")
"""Range of a number in a rotation matrix."""
