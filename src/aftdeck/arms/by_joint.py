"""Values of an arm's joints: a check of lists that have one for each joint, and texts with the unit of each joint."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence, Sized

from aftdeck.arms.link_file import LONGEST, REAL_LENGTHS
from aftdeck.bounds import ROTATION, Bounds
from aftdeck.units import Coordinate, OfJoint, with_article

SLIDE = Bounds(-LONGEST, LONGEST, REAL_LENGTHS, "m")
"""Range of the coordinate of a joint that slides."""


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


def misfits(
    joints: Sequence[str], slides: Sequence[bool], given: Sequence[object]
) -> Iterator[tuple[tuple[int, ...], str]]:
    """Yield why a list from a file does not fit an arm with these joints, each with its place in the list."""
    if why := misfit(joints, given):
        yield (), why
        return
    for i, (joint, kind, value) in enumerate(zip(joints, slides, given, strict=True)):
        if why := wrong_unit(joint, kind, value):
            yield (i,), why
        elif isinstance(value, Coordinate) and (why := implausible([kind], [value])):
            yield (i,), f"{joint}: {why}"


def implausible(slides: Sequence[bool], values: Sequence[float]) -> str:
    """Return why joints cannot have these coordinates [rad or m], whatever their limits; "" if they can."""
    for slid, value in zip(slides, values, strict=True):
        if why := (SLIDE if slid else ROTATION).problem(value, scale(slid, degrees=False)[1]):
            return why
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
