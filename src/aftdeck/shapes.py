"""Drawable shapes, as arm and worksite files list them: the alphabet of every picture.

Lengths are metres, angles radians, in the frame of the body that carries the shape. A shape stands at its
`position`, first turned by its `rotation`. Files name materials; how a material looks is the page's business.
A shape that cannot be drawn raises ValueError when it is made, so a decoder can report it with its place.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise
from math import inf, tau
from typing import Literal

import msgspec

Vec2 = tuple[float, float]
Vec3 = tuple[float, float, float]
Axis = Literal["x", "y", "z"]
Material = Literal[
    "blanket",  # white quilted blanket of the orbiter's upper side
    "liner",  # grey-white liner of the payload bay
    "tiles",  # black tiles
    "leading_edge",  # grey carbon of nose and wing edges
    "radiator",  # silvered radiator panels
    "boom",  # the arm's wrapped booms, a seam each 0.7 m
    "padding",  # padded white covers of joints and boxes
    "housing",  # dark joint housings and nozzles
    "bright",  # bright rings and rims
    "dark",  # black openings and lenses
    "glass",
    "metal",
    "foil",  # crinkled gold foil
    "structure",  # painted frames and brackets
    "glow",  # a lamp's face
]

FEWEST_CORNERS = 3
"""Of a plate's outline."""
FEWEST_SECTIONS = 2
"""Of a loft."""
HEXAHEDRON_VERTICES = 8


def _positive(shape: str, **sizes: float) -> None:
    """Refuse a size that is not above zero, by name."""
    for name, value in sizes.items():
        if not 0.0 < value < inf:
            raise ValueError(f"the {shape}'s {name} is {value:g}; it has to be above 0")


def _within_turn(shape: str, sweep: float) -> None:
    """Refuse a sweep outside (0, 2 pi]; a thousandth of slack lets files write 6.2832."""
    if not 0.0 < sweep <= tau * 1.001:
        raise ValueError(f"the {shape}'s sweep is {sweep:g}; it has to be above 0 and at most 2 pi")


class _Placed(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag_field="kind", kw_only=True):
    """What every shape has: its place and turn in the frame that it is listed in."""

    position: Vec3 = (0.0, 0.0, 0.0)
    """[m]"""
    rotation: Vec3 = (0.0, 0.0, 0.0)
    """Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]."""


class _Solid(_Placed, frozen=True, kw_only=True):
    """A placed shape that is made of something."""

    material: Material


class Box(_Solid, frozen=True, kw_only=True, tag="box"):
    """A box about its centre."""

    size: Vec3
    """Edges along x, y, z [m]."""

    def __post_init__(self) -> None:
        """Refuse an edge that is not above zero."""
        for axis, edge in zip("xyz", self.size, strict=True):
            _positive("box", **{f"size along {axis}": edge})


class Cylinder(_Solid, frozen=True, kw_only=True, tag="cylinder"):
    """A solid cylinder or truncated cone about its centre."""

    axis: Axis = "x"
    length: float
    radius: float
    """At the end of smaller axis coordinate [m]."""
    radius_end: float | None = None
    """At the other end [m]; as `radius` where not given."""

    def __post_init__(self) -> None:
        """Refuse sizes that are not above zero."""
        end = self.radius if self.radius_end is None else self.radius_end
        _positive("cylinder", length=self.length, radius=self.radius, radius_end=end)


class Shell(_Solid, frozen=True, kw_only=True, tag="shell"):
    """A wall bent round an axis: tube, nozzle, door, or, where it is as thick as its radius, a piece of disc.

    Angles run from y to z about axis x, from z to x about y, from x to y about z.
    """

    axis: Axis = "x"
    length: float
    radius: float
    """Outer, at the end of smaller axis coordinate [m]."""
    radius_end: float | None = None
    """Outer, at the other end [m]; as `radius` where not given."""
    thickness: float
    start: float = 0.0
    sweep: float = tau

    def __post_init__(self) -> None:
        """Refuse sizes that are not above zero and walls thicker than their radius."""
        end = self.radius if self.radius_end is None else self.radius_end
        _positive("shell", length=self.length, radius=self.radius, radius_end=end, thickness=self.thickness)
        _within_turn("shell", self.sweep)
        if self.thickness > min(self.radius, end):
            raise ValueError(f"the shell's thickness is {self.thickness:g}; it has to be at most its radius")


class Ring(_Solid, frozen=True, kw_only=True, tag="ring"):
    """A round bar bent about an axis, a full turn or part of one; angles as in `Shell`."""

    axis: Axis = "x"
    radius: float
    """Of the bar's middle line [m]."""
    bar: float
    """Radius of the bar [m]."""
    start: float = 0.0
    sweep: float = tau

    def __post_init__(self) -> None:
        """Refuse sizes that are not above zero."""
        _positive("ring", radius=self.radius, bar=self.bar)
        _within_turn("ring", self.sweep)


class Sphere(_Solid, frozen=True, kw_only=True, tag="sphere"):
    """A sphere."""

    radius: float

    def __post_init__(self) -> None:
        """Refuse a radius that is not above zero."""
        _positive("sphere", radius=self.radius)


class Plate(_Solid, frozen=True, kw_only=True, tag="plate"):
    """A flat outline given thickness, half to each side of the plane through its position."""

    normal: Axis
    outline: tuple[Vec2, ...]
    """Corners in order, not closed, as (y, z), (x, z) or (x, y) for normal x, y or z [m]."""
    thickness: float
    bevel: float = 0.0
    """How far the rims are cut back, at most half the thickness [m]."""

    def __post_init__(self) -> None:
        """Refuse fewer than three corners, no thickness, or a bevel deeper than half of it."""
        _positive("plate", thickness=self.thickness)
        if len(self.outline) < FEWEST_CORNERS:
            raise ValueError(f"the plate's outline has {len(self.outline)} corners; it needs at least {FEWEST_CORNERS}")
        if not 0.0 <= self.bevel <= self.thickness / 2:
            raise ValueError(f"the plate's bevel is {self.bevel:g}; it has to be 0 to half the thickness")


class Section(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A rounded cross-section of a loft: an upper and a lower half of a superellipse.

    Its points satisfy |y/half_width|^n + |z/height|^n = 1 about `middle`, n being the exponent of its half:
    2 is an ellipse, 5 nearly a rectangle.
    """

    x: float
    half_width: float
    top: float
    middle: float
    bottom: float
    exponents: Vec2 = (2.0, 2.0)
    """Of the upper and of the lower half."""

    def __post_init__(self) -> None:
        """Refuse an empty section."""
        _positive("section", half_width=self.half_width, height=self.top - self.bottom)
        _positive("section", upper_exponent=self.exponents[0], lower_exponent=self.exponents[1])
        if not self.bottom <= self.middle <= self.top:
            raise ValueError(f"the section's middle is {self.middle:g}; it has to lie from bottom to top")


class Loft(_Solid, frozen=True, kw_only=True, tag="loft"):
    """A skin over cross-sections along x, closed at both ends."""

    sections: tuple[Section, ...]
    """In order of growing x."""

    def __post_init__(self) -> None:
        """Refuse fewer than two sections, or sections out of order."""
        if len(self.sections) < FEWEST_SECTIONS:
            raise ValueError(f"the loft has {len(self.sections)} sections; it needs at least {FEWEST_SECTIONS}")
        stations = [section.x for section in self.sections]
        if any(after <= before for before, after in pairwise(stations)):
            raise ValueError("the loft's sections have to be listed in order of growing x")


class Hexahedron(_Solid, frozen=True, kw_only=True, tag="hexahedron"):
    """A body of eight vertices and six flat faces, numbered as in `aftdeck.bodies.hexahedron`."""

    vertices: tuple[Vec3, ...]
    """Numbered v - 1 = 4 (on the +y side) + 2 (+x) + 1 (+z), in axes of the body's own [m]."""

    def __post_init__(self) -> None:
        """Refuse another number of vertices than eight."""
        if len(self.vertices) != HEXAHEDRON_VERTICES:
            raise ValueError(f"the hexahedron has {len(self.vertices)} vertices; it needs {HEXAHEDRON_VERTICES}")


class Light(_Placed, frozen=True, kw_only=True, tag="light"):
    """A lamp: a round face that looks along its own x and lights what lies before it."""

    radius: float
    cone: float
    """Half angle of its beam [rad]; above pi/2 it shines all round."""
    reach: float
    """How far it lights [m]."""
    intensity: float
    """On its axis [cd], in the scale in which the sun gives 4.1 lx."""
    switch: str = "lamps"
    """Which switch of the panel lights it, with others of that name."""

    def __post_init__(self) -> None:
        """Refuse sizes that are not above zero."""
        _positive("light", radius=self.radius, cone=self.cone, reach=self.reach, intensity=self.intensity)


class Group(_Placed, frozen=True, kw_only=True, tag="group"):
    """Shapes that share a place; drawn once, or several times in even steps, or also mirrored."""

    shapes: tuple[Shape, ...]
    count: int = 1
    """How many copies."""
    step: Vec3 = (0.0, 0.0, 0.0)
    """From a copy to the next, along the group's own axes [m]."""
    turn: Vec3 = (0.0, 0.0, 0.0)
    """From a copy to the next, about the group's own axes, as a `rotation` [rad]."""
    mirror: bool = False
    """Draw all once more, reflected in the plane y = 0 of the frame that the group is listed in."""

    def __post_init__(self) -> None:
        """Refuse an empty group."""
        if not self.shapes:
            raise ValueError("the group has no shapes; it needs at least 1")
        if self.count < 1:
            raise ValueError(f"the group's count is {self.count}; it has to be at least 1")


Shape = Box | Cylinder | Shell | Ring | Sphere | Plate | Loft | Hexahedron | Light | Group


def switches(shapes: Iterable[Shape]) -> tuple[str, ...]:
    """The switches of the lamps among some shapes, each once, in the order in which they come."""
    found: dict[str, None] = {}
    for shape in shapes:
        if isinstance(shape, Light):
            found[shape.switch] = None
        elif isinstance(shape, Group):
            found.update(dict.fromkeys(switches(shape.shapes)))
    return tuple(found)
