"""Three kinds of spacecraft, by mass: which fittings a payload's hull gets.

Their models are public photographs of spacecraft that the Shuttle carried: a large observatory in silver foil with
folded solar wings, a platform in gold foil with solar panels and radiators on its sides, and a communications satellite
whose whole side is solar cells.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import inf, pi, radians, tau
from typing import NamedTuple

from aftdeck.details.fittings import End, dish, engine, equipment, handrail, tank, target, thrusters
from aftdeck.details.hull import Strip
from aftdeck.details.skin import Skin
from aftdeck.shapes import Material, Shape

UP = pi / 2
"""Direction of the top, from y towards z [rad]."""
_GAP = 0.015
"""Half of the gap between two panels [m]."""
_WIDEST = 0.95
"""Greatest radius of an antenna or engine on an end [m]."""
_RAIL = 0.9
"""Length of a handrail [m]."""


class Zone(NamedTuple):
    """Covering of the strips that face away from the top by up to a certain angle.

    Attributes:
        until: greatest angle from the top [rad].
        material: material of its panels; None leaves the hull bare.
        panel: approximate length along the hull and width of a panel [m].
        part: part of the hull's length that is covered.
        thickness: thickness of the panels [m].
    """

    until: float
    material: Material | None
    panel: tuple[float, float] = (2.8, 2.0)
    part: float = 0.93
    thickness: float = 0.012


class Kind(NamedTuple):
    """A kind of spacecraft.

    Attributes:
        least: least mass [kg].
        zones: coverings, from the top to the underside.
        belt: part of the hull's length round its middle that a belt of radiators covers instead.
        rails: places of handrails on both sides of the top, as parts of half the length.
        fore: fitting in the middle of the end at -x, and its radius as a part of the hull's.
        aft: likewise at +x.
        rings: equal fittings in rings round both ends: their number, their distance from the axis as a part of the
            hull's, the radius of the room that each needs [m], and their shapes.
    """

    least: float
    zones: tuple[Zone, ...]
    belt: float
    rails: tuple[float, ...]
    fore: tuple[str, float]
    aft: tuple[str, float]
    rings: tuple[tuple[int, float, float, tuple[Shape, ...]], ...]


_OBSERVATORY = Kind(
    least=10e3,  # observatories that the Shuttle deployed had 11 to 17 t (assumed)
    zones=(
        Zone(radians(20.0), "silver"),
        Zone(radians(70.0), "solar", (1.8, 1.2), 0.8, 0.03),
        Zone(inf, "silver"),
    ),
    belt=0.0,
    rails=(-0.7, 0.0, 0.7),
    fore=("dish", 0.42),
    aft=("engine", 0.2),
    rings=((8, 0.74, 0.2, equipment((0.09, 0.34, 0.3), "padding")), (4, 0.62, 0.16, tank(0.15))),
)
_PLATFORM = Kind(
    least=4e3,  # platforms and pallets of the Shuttle had 3 to 8 t (assumed)
    zones=(
        Zone(radians(20.0), None),
        Zone(radians(80.0), "solar", (2.0, 1.2), 0.86, 0.03),
        Zone(radians(140.0), "radiator", (2.6, 2.0), 0.86, 0.02),
        Zone(inf, None),
    ),
    belt=0.0,
    rails=(-0.75, 0.75),
    fore=("engine", 0.3),
    aft=("dish", 0.45),
    rings=((6, 0.66, 0.24, tank(0.22)), (4, 0.8, 0.16, equipment((0.08, 0.26, 0.2), "silver"))),
)
_COMMUNICATIONS = Kind(
    least=0.0,
    zones=(Zone(inf, "solar", (2.1, 1.2), 0.95, 0.02),),
    belt=0.16,
    rails=(),
    fore=("dish", 0.55),
    aft=("engine", 0.24),
    rings=((8, 0.72, 0.22, tank(0.2)), (8, 0.8, 0.16, equipment((0.08, 0.26, 0.22), "radiator"))),
)
KINDS = (_OBSERVATORY, _PLATFORM, _COMMUNICATIONS)
"""Kinds of spacecraft, the heaviest first."""
_TARGETS = (-0.9, -0.4, 0.4, 0.9)
"""Places of the vision system's targets on both sides of the top, as parts of half the length."""


def fittings_of(skin: Skin, mass: float) -> Iterator[Shape]:
    """Yield the shapes that decorate a hull, in the hull's own axes; `mass`: the payload's mass [kg]."""
    kind = next(kind for kind in KINDS if mass >= kind.least)
    half, top = 0.5 * skin.hull.length, skin.strip(UP)
    for strip in skin.hull.strips:
        yield from _covered(skin, strip, kind)
    sides = (-0.8 * top.half_width, 0.8 * top.half_width)
    for s in sides:
        for x in kind.rails:
            yield from handrail(skin, top, (x * half - 0.5 * _RAIL, x * half + 0.5 * _RAIL), s)
        for x in _TARGETS:
            yield from target(skin, top, x * half, 0.55 * s)
    for side, middle in ((-1, kind.fore), (1, kind.aft)):
        yield from _end(End(skin, side), middle, kind)


def _covered(skin: Skin, strip: Strip, kind: Kind) -> Iterator[Shape]:
    """Yield the panels of one strip."""
    half = 0.5 * skin.hull.length
    tilt = abs((strip.angle - UP + pi) % tau - pi)
    zone = next(zone for zone in kind.zones if tilt <= zone.until)
    if zone.material is None:
        return
    for x in _rows((-zone.part * half, zone.part * half), zone.panel[0]):
        belted = abs(x[0] + x[1]) < 2.0 * kind.belt * half
        material: Material = "radiator" if belted else zone.material
        wide = inf if belted else zone.panel[1]
        for s in _rows((-strip.half_width, strip.half_width), wide):
            yield from skin.cover(strip, _within(x), _within(s), material, zone.thickness)


def _end(end: End, middle: tuple[str, float], kind: Kind) -> Iterator[Shape]:
    """Yield the fittings of an end: one in its middle if this is free, thrusters at its rim, and rings of others."""
    name, part = middle
    radius = min(part * end.radius, _WIDEST)
    if end.free(0.0, 0.0, 1.2 * radius):
        end.take(0.0, 0.0, 1.2 * radius)
        yield end.placed(0.0, 0.0, dish(radius) if name == "dish" else engine(radius))
    yield from end.around(4, 0.88 * end.radius, 0.14, thrusters())
    for count, out, room, shapes in kind.rings:
        yield from end.around(count, out * end.radius, room, shapes)


def _rows(span: tuple[float, float], size: float) -> list[tuple[float, float]]:
    """Return equal parts of a span, each of about this size [m]."""
    count = max(1, round((span[1] - span[0]) / size))
    step = (span[1] - span[0]) / count
    return [(span[0] + k * step, span[0] + (k + 1) * step) for k in range(count)]


def _within(span: tuple[float, float]) -> tuple[float, float]:
    """Return a span less the gap at both ends [m]."""
    return span[0] + _GAP, span[1] - _GAP
