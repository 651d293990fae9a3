"""The solids of a body as a worksite's file lists them."""

from __future__ import annotations

from aftdeck.bodies.cover import SIDES
from aftdeck.shapes import Axis, Material
from aftdeck.units import Angle, Length
from aftdeck.worksite.tables import Placed, Point, Range, Text

Corner = tuple[Length, Length]


class _SolidFile(Placed, frozen=True, kw_only=True, tag_field="kind"):
    """What collision takes a piece of a body to be: one convex hexahedron, or several."""

    part: Text
    """What people call it; several solids may share a part."""
    material: Material | None = None
    """What it is drawn of; None: the body's `shapes` draw it."""
    mirror: bool = False
    """Make it once more, reflected in the plane y = 0 of the body; the parts are called ``… port``, ``… starboard``."""
    source: Text | None = None
    """Where its own numbers come from; None: as the body's."""


class BlockFile(_SolidFile, frozen=True, kw_only=True, tag="block"):
    """A box by its ends, or, with other ends of y or z at its far x, one that tapers."""

    x: Range
    y: Range
    z: Range
    y_end: Range | None = None
    z_end: Range | None = None


class BoxFile(_SolidFile, frozen=True, kw_only=True, tag="box"):
    """A box about its centre."""

    size: Point


class PlateFile(_SolidFile, frozen=True, kw_only=True, tag="plate"):
    """A flat outline of four corners given thickness, half to each side; as a `shapes.Plate`."""

    normal: Axis
    outline: tuple[Corner, Corner, Corner, Corner]
    thickness: Length


class HexahedronFile(_SolidFile, frozen=True, kw_only=True, tag="hexahedron"):
    """Eight vertices, numbered as in `aftdeck.bodies.hexahedron`."""

    vertices: tuple[Point, Point, Point, Point, Point, Point, Point, Point]


class TubeWallFile(_SolidFile, frozen=True, kw_only=True, tag="tube_wall"):
    """The wall of a tube, covered from outside; as `bodies.cover.tube_wall`."""

    radius: Length
    thickness: Length
    length: Length
    radius_end: Length | None = None
    axis: Axis = "x"
    start: Angle = Angle(0.0)
    sweep: Angle
    count: int


class PrismFile(_SolidFile, frozen=True, kw_only=True, tag="prism"):
    """A regular prism, or what covers a round body from outside; as `bodies.cover.prism`."""

    radius: Length
    """From the axis to a side's middle."""
    length: Length
    radius_end: Length | None = None
    axis: Axis = "x"
    sides: int = SIDES
    turn: Angle = Angle(0.0)


SolidFile = BlockFile | BoxFile | PlateFile | HexahedronFile | TubeWallFile | PrismFile
