"""Values of an arm's joints: a check of lists that have one for each joint, and texts with the unit of each joint."""

from __future__ import annotations

import math
from collections.abc import Sequence, Sized

from aftdeck.units import OfJoint, with_article


def misfit(joints: Sequence[str], given: Sized) -> str:
    """Return why a list does not fit an arm with these joints; "" if it has one value for each of them."""
    if len(given) == len(joints):
        return ""
    return f"expected {len(joints)} values, one for each joint ({', '.join(joints)}); got {len(given)}"


def wrong_unit(joint: str, slides: bool, given: object) -> str:
    """Return why a joint cannot have a value, or a pair of values, from a file; "" if its unit is that of the joint."""
    for value in given if isinstance(given, tuple) else (given,):
        if isinstance(value, OfJoint) and value.slides not in (None, slides):
            turning, sliding = value.kinds
            needed, got = (sliding, turning) if slides else (turning, sliding)
            moves = "slides" if slides else "turns"
            return (
                f"{joint} {moves}: expected {with_article(needed.noun)}, such as {needed.example!r}, got "
                f"{with_article(got.noun)}, {value:g} {got.unit}"
            )
    return ""


def shown(value: float, slides: bool, how: str = "g") -> str:
    """Return a joint's coordinate as text: an angle in degrees, or a length in metres; `how`: format of the number."""
    factor, unit = scale(slides)
    return f"{value * factor:{how}} {unit}"


def scale(slides: bool, degrees: bool = True) -> tuple[float, str]:
    """Return the factor from the SI unit of a joint's coordinate to the unit that is shown, and this unit."""
    if slides or not degrees:
        return 1.0, "m" if slides else "rad"
    return math.degrees(1.0), "deg"
