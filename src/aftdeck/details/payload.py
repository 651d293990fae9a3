"""Details of a payload, from its drawn shapes and its mass alone."""

from __future__ import annotations

from aftdeck.details.hull import hull_of
from aftdeck.details.satellites import fittings_of
from aftdeck.details.skin import Skin
from aftdeck.shapes import Group, Shape

LEAST = 0.5
"""Least distance of the skin from the axis at which a hull is decorated [m]; a smaller one has no room (assumed)."""


def payload_details(shapes: tuple[Shape, ...], mass: float) -> tuple[Shape, ...]:
    """Return the shapes that decorate a payload, in its own axes; none if its hull is too small or of another form.

    Args:
        shapes: the payload's drawn shapes.
        mass: its mass [kg].
    """
    hull = hull_of(shapes)
    if hull is None or hull.distance < LEAST:
        return ()
    found = tuple(fittings_of(Skin(hull), mass))
    return (Group(position=hull.position, rotation=hull.rotation, shapes=found),) if found else ()
