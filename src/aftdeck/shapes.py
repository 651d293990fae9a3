"""Drawable shapes, as listed in arm and worksite files. Every picture consists of such shapes.

Lengths are in metres and angles in radians, in the frame of the body to which the shape belongs. A shape is first
rotated by its `rotation`, then moved to its `position`. Files name materials. `scene.colours` and the page define the
colour of each material; the page also defines its finish. The constructor of a shape that cannot be drawn raises
ValueError. A decoder then reports the shape's place in the file.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise
from math import inf, tau
from typing import Annotated, Literal

import msgspec

from aftdeck.bounds import COORDINATE, ROTATION, Bounds

Vec2 = tuple[float, float]
Metres = Annotated[float, COORDINATE]
Radians = Annotated[float, ROTATION]
Exponent = Annotated[float, Bounds(0.1, 100.0, "exponent 2 gives an ellipse, and 5 nearly a rectangle")]
Point2 = tuple[Metres, Metres]
Point = tuple[Metres, Metres, Metres]
Turn = tuple[Radians, Radians, Radians]
Axis = Literal["x", "y", "z"]
Material = Literal[
    "blanket",  # white quilted blanket of the orbiter's upper side
    "liner",  # grey-white liner of the payload bay
    "tiles",  # black tiles
    "leading_edge",  # grey carbon of nose and wing edges
    "radiator",  # silvered radiator panels
    "boom",  # the arm's wrapped booms, with a seam every 0.7 m
    "padding",  # padded white covers of joints and boxes
    "housing",  # dark joint housings and nozzles
    "bright",  # bright rings and rims
    "dark",  # black openings and lenses
    "glass",
    "metal",
    "foil",  # crinkled gold foil
    "structure",  # painted frames and brackets
    "silver",  # crinkled silver foil
    "solar",  # solar cells
    "rail",  # handrails, anodised yellow
    "scuffed",  # white paint with scratches
    "glow",  # a lamp's face
]

FEWEST_CORNERS = 3
"""Minimum number of corners of a plate's outline."""
FEWEST_SECTIONS = 2
"""Minimum number of sections of a loft."""
HEXAHEDRON_VERTICES = 8
MOST_SHAPES = 10_000
"""Greatest number of shapes that one group draws, in all its copies (assumed)."""
DEEPEST = 8
"""Greatest number of groups of which each contains the next (assumed)."""


def _positive(shape: str, **sizes: float) -> None:
    """Raise ValueError for a size that is zero, negative or not finite; the message names the size."""
    for name, value in sizes.items():
        if not 0.0 < value < inf:
            raise ValueError(f"the {shape}'s {name} is {value:g}; it has to be above 0")


def _within_turn(shape: str, sweep: float) -> None:
    """Raise ValueError for a sweep outside (0, 2 pi] [rad]; a tolerance of 0.1 % allows 6.2832 in files."""
    if not 0.0 < sweep <= tau * 1.001:
        raise ValueError(f"the {shape}'s sweep is {sweep:g}; it has to be above 0 and at most 2 pi")


class _Placed(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag_field="kind", kw_only=True):
    """Base of every shape: position and rotation in the frame in which the shape is listed."""

    position: Point = (0.0, 0.0, 0.0)
    """Position [m]."""
    rotation: Turn = (0.0, 0.0, 0.0)
    """Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]."""


class _Solid(_Placed, frozen=True, kw_only=True):
    """A placed shape with a material."""

    material: Material


class Box(_Solid, frozen=True, kw_only=True, tag="box"):
    """A box, centred at its position."""

    size: Point
    """Edges along x, y, z [m]."""

    def __post_init__(self) -> None:
        """Reject an edge that is not above zero."""
        for axis, edge in zip("xyz", self.size, strict=True):
            _positive("box", **{f"size along {axis}": edge})


class Cylinder(_Solid, frozen=True, kw_only=True, tag="cylinder"):
    """A solid cylinder or truncated cone, centred at its position."""

    axis: Axis = "x"
    length: Metres
    radius: Metres
    """Radius at the end with the smaller axis coordinate [m]."""
    radius_end: Metres | None = None
    """Radius at the other end [m]; None if it equals `radius`."""

    def __post_init__(self) -> None:
        """Reject sizes that are not above zero."""
        end = self.radius if self.radius_end is None else self.radius_end
        _positive("cylinder", length=self.length, radius=self.radius, radius_end=end)


class Shell(_Solid, frozen=True, kw_only=True, tag="shell"):
    """A wall bent round an axis: a tube, nozzle or door, or a sector of a disc if the thickness equals the radius.

    Angles run from y to z about axis x, from z to x about y, from x to y about z.
    """

    axis: Axis = "x"
    length: Metres
    radius: Metres
    """Outer radius at the end with the smaller axis coordinate [m]."""
    radius_end: Metres | None = None
    """Outer radius at the other end [m]; None if it equals `radius`."""
    thickness: Metres
    start: Radians = 0.0
    sweep: Radians = tau

    def __post_init__(self) -> None:
        """Reject sizes that are not above zero, a sweep beyond a full turn, and walls thicker than their radius."""
        end = self.radius if self.radius_end is None else self.radius_end
        _positive("shell", length=self.length, radius=self.radius, radius_end=end, thickness=self.thickness)
        _within_turn("shell", self.sweep)
        if self.thickness > min(self.radius, end):
            raise ValueError(f"the shell's thickness is {self.thickness:g}; it has to be at most the shell's radius")


class Ring(_Solid, frozen=True, kw_only=True, tag="ring"):
    """A round bar bent about an axis by a full turn or less; angles are as in `Shell`."""

    axis: Axis = "x"
    radius: Metres
    """Radius of the bar's centre line [m]."""
    bar: Metres
    """Radius of the bar [m]."""
    start: Radians = 0.0
    sweep: Radians = tau

    def __post_init__(self) -> None:
        """Reject sizes that are not above zero, and a sweep beyond a full turn."""
        _positive("ring", radius=self.radius, bar=self.bar)
        _within_turn("ring", self.sweep)


class Sphere(_Solid, frozen=True, kw_only=True, tag="sphere"):
    """A sphere."""

    radius: Metres

    def __post_init__(self) -> None:
        """Reject a radius that is not above zero."""
        _positive("sphere", radius=self.radius)


class Plate(_Solid, frozen=True, kw_only=True, tag="plate"):
    """A flat plate. Half of its thickness is on each side of the plane through its position."""

    normal: Axis
    outline: tuple[Point2, ...]
    """Corners in order, each listed once: (y, z), (x, z) or (x, y) for normal x, y or z [m]."""
    thickness: Metres
    bevel: Metres = 0.0
    """Distance by which the edges are cut back, at most half the thickness [m]."""

    def __post_init__(self) -> None:
        """Reject fewer than 3 corners, a thickness not above zero, and a bevel below 0 or above half the thickness."""
        _positive("plate", thickness=self.thickness)
        if len(self.outline) < FEWEST_CORNERS:
            raise ValueError(f"the plate's outline has {len(self.outline)} corners; it needs at least {FEWEST_CORNERS}")
        if not 0.0 <= self.bevel <= self.thickness / 2:
            raise ValueError(f"the plate's bevel is {self.bevel:g}; it has to be between 0 and half the thickness")


class Section(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A rounded cross-section of a loft: an upper and a lower half of a superellipse.

    The points of a half satisfy |y/half_width|^n + |(z - middle)/height|^n = 1. The height is from `middle` to `top` or
    `bottom`; n is the exponent of the half. Exponent 2 gives an ellipse, 5 nearly a rectangle.
    """

    x: Metres
    half_width: Metres
    top: Metres
    middle: Metres
    bottom: Metres
    exponents: tuple[Exponent, Exponent] = (2.0, 2.0)
    """Exponents of the upper and the lower half."""

    def __post_init__(self) -> None:
        """Reject sizes and exponents that are not above zero, and a middle that is not between bottom and top."""
        _positive("section", half_width=self.half_width, height=self.top - self.bottom)
        _positive("section", upper_exponent=self.exponents[0], lower_exponent=self.exponents[1])
        if not self.bottom <= self.middle <= self.top:
            raise ValueError(f"the section's middle is {self.middle:g}; it has to be between bottom and top")


class Loft(_Solid, frozen=True, kw_only=True, tag="loft"):
    """A skin over cross-sections along x, closed at both ends."""

    sections: tuple[Section, ...]
    """Sections in order of increasing x."""

    def __post_init__(self) -> None:
        """Reject fewer than two sections, or sections out of order."""
        if len(self.sections) < FEWEST_SECTIONS:
            raise ValueError(f"the loft has {len(self.sections)} sections; it needs at least {FEWEST_SECTIONS}")
        stations = [section.x for section in self.sections]
        if any(after <= before for before, after in pairwise(stations)):
            raise ValueError("the loft's sections have to be listed in order of increasing x")


class Hexahedron(_Solid, frozen=True, kw_only=True, tag="hexahedron"):
    """A body of eight vertices and six flat faces, numbered as in `aftdeck.bodies.hexahedron`."""

    vertices: tuple[Point, ...]
    """Vertices in the body's own axes [m]. Vertex v has v - 1 = 4 (if at +y) + 2 (if at +x) + 1 (if at +z)."""

    def __post_init__(self) -> None:
        """Reject any number of vertices other than eight."""
        if len(self.vertices) != HEXAHEDRON_VERTICES:
            raise ValueError(f"the hexahedron has {len(self.vertices)} vertices; it needs {HEXAHEDRON_VERTICES}")


class Light(_Placed, frozen=True, kw_only=True, tag="light"):
    """A lamp: a round face that points along its own x axis and lights the space in front."""

    radius: Metres
    cone: Radians
    """Half angle of the beam [rad]; above pi/2 the lamp shines in all directions."""
    reach: Metres
    """Range of the light [m]."""
    intensity: Annotated[float, Bounds(0.0, 1e9, "a lighthouse has 1e6 to 1e8 cd", "cd")]
    """Intensity on the lamp's axis [cd]; on this scale full sunlight is 4.1 lx."""
    switch: str = "lamps"
    """Name of the panel's switch for this lamp. Several lamps may have the same switch."""

    def __post_init__(self) -> None:
        """Reject sizes that are not above zero."""
        _positive("light", radius=self.radius, cone=self.cone, reach=self.reach, intensity=self.intensity)


class Group(_Placed, frozen=True, kw_only=True, tag="group"):
    """Shapes that are moved together. A group can be repeated in equal steps, and mirrored."""

    shapes: tuple[Shape, ...]
    count: Annotated[int, Bounds(1, MOST_SHAPES, "every copy is drawn in every picture")] = 1
    """Number of copies."""
    step: Point = (0.0, 0.0, 0.0)
    """Translation from one copy to the next, along the group's own axes [m]."""
    turn: Turn = (0.0, 0.0, 0.0)
    """Roll, pitch, yaw about the group's own axes, as in `rotation` [rad]. For copy i, counted from 0, each angle is
    multiplied by i."""
    mirror: bool = False
    """Whether all copies are also drawn mirrored across the plane y = 0 of the frame in which the group is listed."""

    def __post_init__(self) -> None:
        """Reject a group that is empty, nested too deeply, or draws too many shapes; and a count below 1."""
        if not self.shapes:
            raise ValueError("the group has no shapes; it needs at least 1")
        if self.count < 1:
            raise ValueError(f"the group's count is {self.count}; it has to be at least 1")
        number, depth = self._extent()
        if depth > DEEPEST:
            raise ValueError(f"the group contains {depth} groups, one inside the other; at most {DEEPEST} are allowed")
        if number > MOST_SHAPES:
            raise ValueError(f"the group draws {number} shapes in all its copies; at most {MOST_SHAPES} are allowed")

    def _extent(self) -> tuple[int, int]:
        """Return the number of shapes that the group draws, and the number of groups from this one to the innermost."""
        inner = [shape._extent() if isinstance(shape, Group) else (1, 0) for shape in self.shapes]
        copies = self.count * (2 if self.mirror else 1)
        return copies * sum(number for number, _ in inner), 1 + max(depth for _, depth in inner)


Shape = Box | Cylinder | Shell | Ring | Sphere | Plate | Loft | Hexahedron | Light | Group


def without_lamps(details: Iterable[Shape]) -> None:
    """Raise ValueError if one of the shapes is a lamp: what only decorates a body does not light it."""
    if found := switches(details):
        raise ValueError(f"details cannot be lamps, and these have a lamp of switch {found[0]!r}; list it in shapes")


def switches(shapes: Iterable[Shape]) -> tuple[str, ...]:
    """Return the switches of all lamps among the shapes, each switch once, in order of appearance."""
    found: dict[str, None] = {}
    for shape in shapes:
        if isinstance(shape, Light):
            found[shape.switch] = None
        elif isinstance(shape, Group):
            found.update(dict.fromkeys(switches(shape.shapes)))
    return tuple(found)
