"""Small parts of spacecraft: antenna, nozzles, handrails, targets. Each has the size of its real counterpart.

Sources, from general descriptions (single): a handrail for a gloved hand is about 19 by 32 mm, 57 mm off the surface;
a target of the Shuttle's vision system is a black disc on a white square; a thruster of 22 N has a nozzle of 50 mm.
Other sizes are assumed.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import pi, tau

from aftdeck.details.hull import Strip
from aftdeck.details.skin import Skin
from aftdeck.elementary import sincos
from aftdeck.shapes import Box, Cylinder, Group, Material, Ring, Shape, Shell

RAIL = (0.032, 0.019, 0.045)
"""Width and thickness of a handrail, and its height above the skin, within `skin.PROUD` [m]."""
_DOT = 0.16
"""Edge of the white square of a target [m]."""
_TURNS = 12
"""Number of turns of a circle of fittings among which the one with most room is chosen."""
BEYOND = 0.15
"""Greatest distance by which a detail stands out of an end [m]. Contacts are computed without it (assumed)."""


def handrail(skin: Skin, strip: Strip, x: tuple[float, float], s: float) -> Iterator[Shape]:
    """Yield a handrail along the hull, with a post at each end; nothing if a fixture is in its way."""
    if not skin.free(strip, x, (s - 0.1, s + 0.1)):
        return
    wide, thick, high = RAIL
    middle, length = 0.5 * (x[0] + x[1]), x[1] - x[0]
    yield skin.box(strip, (middle, s, high - 0.5 * thick), (length, wide, thick), "rail")
    for end in x:
        yield skin.box(strip, (end, s, 0.5 * high), (0.05, 0.06, high), "structure")


def target(skin: Skin, strip: Strip, x: float, s: float) -> Iterator[Shape]:
    """Yield a target of the vision system, a black disc on a white square; nothing if a fixture is in its way."""
    half = 0.5 * _DOT
    if not skin.free(strip, (x - half, x + half), (s - half, s + half)):
        return
    yield skin.box(strip, (x, s, 0.012), (_DOT, _DOT, 0.024), "padding")
    plate = skin.box(strip, (x, s, 0.0255), (0.01, 0.01, 0.003), "dark")
    yield Cylinder(
        material="dark", axis="z", length=0.003, radius=0.3 * _DOT, position=plate.position, rotation=plate.rotation
    )


class End:
    """One end of a hull; `side` is -1 or 1 along its axis."""

    def __init__(self, skin: Skin, side: int) -> None:
        self.skin, self.side, self.radius = skin, side, skin.hull.distance
        self._face = skin.hull.ends[side > 0]
        self._taken: list[tuple[float, float, float]] = []

    def placed(self, y: float, z: float, shapes: tuple[Shape, ...], roll: float = 0.0) -> Shape:
        """Return shapes whose x axis points out of the end, with their origin on it at (y, z) [m]."""
        turn = (0.0, 0.0, pi) if self.side < 0 else (0.0, 0.0, 0.0)
        return Group(position=(self._face, y, z), rotation=(roll, turn[1], turn[2]), shapes=shapes)

    def free(self, y: float, z: float, radius: float) -> bool:
        """Return whether neither a fixture nor an earlier fitting is before a disc on the end [m]."""
        apart = all((y - at_y) ** 2 + (z - at_z) ** 2 >= (radius + room) ** 2 for at_y, at_z, room in self._taken)
        return apart and self.skin.end_is_free(self.side, y, z, radius)

    def take(self, y: float, z: float, radius: float) -> None:
        """Leave a disc on the end to the fitting that is now placed there [m]."""
        self._taken.append((y, z, radius))

    def around(self, count: int, radius: float, room: float, shapes: tuple[Shape, ...]) -> Iterator[Shape]:
        """Yield copies of shapes at equal angles on a circle, turned so that most find a free disc of radius `room`."""
        step = tau / count
        best: list[tuple[float, float, float]] = []
        for turn in range(_TURNS):
            angles = [(k + turn / _TURNS) * step for k in range(count)]
            points = [(radius * cosine, radius * sine, angle) for angle in angles for sine, cosine in [sincos(angle)]]
            found = [point for point in points if self.free(point[0], point[1], room)]
            best = max(best, found, key=len)
        for y, z, angle in best:
            self.take(y, z, room)
            yield self.placed(y, z, shapes, angle - pi / 2 if self.side > 0 else pi / 2 - angle)


def dish(radius: float) -> tuple[Shape, ...]:
    """Return an antenna whose axis is x: a shallow bowl on a stub, with a feed on three struts."""
    deep = min(0.1, 0.2 * radius)
    strut = Cylinder(
        material="bright",
        axis="z",
        length=0.62 * radius,
        radius=0.008,
        position=(deep, 0.0, 0.31 * radius),
        rotation=(0.0, -0.12, 0.0),
    )
    return (
        Shell(
            material="padding",
            position=(0.5 * deep + 0.02, 0.0, 0.0),
            length=deep,
            radius=0.1 * radius,
            radius_end=radius,
            thickness=0.1 * radius,
        ),
        Ring(material="bright", position=(deep + 0.02, 0.0, 0.0), radius=radius, bar=0.012),
        Cylinder(material="bright", position=(0.5 * deep + 0.025, 0.0, 0.0), length=deep, radius=0.09 * radius),
        Cylinder(material="housing", position=(deep + 0.01, 0.0, 0.0), length=0.06, radius=0.12 * radius),
        Group(shapes=(strut,), count=3, turn=(tau / 3, 0.0, 0.0)),
    )


def engine(radius: float) -> tuple[Shape, ...]:
    """Return the nozzle of an apogee engine whose axis is x, sunk into a dark ring of insulation."""
    return (
        Cylinder(material="dark", position=(0.003, 0.0, 0.0), length=0.006, radius=1.25 * radius),
        Ring(material="silver", position=(0.01, 0.0, 0.0), radius=1.25 * radius, bar=0.03),
        Shell(
            material="housing",
            position=(0.07, 0.0, 0.0),
            length=0.14,
            radius=0.72 * radius,
            radius_end=radius,
            thickness=0.02,
        ),
        Ring(material="bright", position=(0.135, 0.0, 0.0), radius=radius, bar=0.012),
        Cylinder(material="bright", position=(0.01, 0.0, 0.0), length=0.01, radius=0.3 * radius),
    )


def thrusters() -> tuple[Shape, ...]:
    """Return a block with two nozzles that point outwards along x."""
    nozzle = Cylinder(material="housing", length=0.06, radius=0.012, radius_end=0.03)
    return (
        Box(material="silver", position=(0.04, 0.0, 0.0), size=(0.08, 0.24, 0.09)),
        Group(position=(0.11, -0.06, 0.0), shapes=(nozzle,), count=2, step=(0.0, 0.12, 0.0)),
    )


def equipment(size: tuple[float, float, float], material: Material) -> tuple[Shape, ...]:
    """Return a box of equipment on an end, with a lid and a connector; `size` along x, y and z [m]."""
    x, y, z = size
    return (
        Box(material=material, position=(0.5 * x, 0.0, 0.0), size=size),
        Box(material="structure", position=(x + 0.004, 0.0, 0.0), size=(0.008, 0.8 * y, 0.75 * z)),
        Cylinder(material="bright", position=(x + 0.02, 0.28 * y, -0.25 * z), length=0.04, radius=0.03),
    )


def tank(radius: float) -> tuple[Shape, ...]:
    """Return a foil-covered pressure tank of which a cap stands out of an end; `radius` of the cap [m]."""
    return (
        Cylinder(material="bright", position=(0.01, 0.0, 0.0), length=0.02, radius=1.1 * radius),
        Cylinder(material="foil", position=(0.06, 0.0, 0.0), length=0.1, radius=radius, radius_end=0.5 * radius),
    )
