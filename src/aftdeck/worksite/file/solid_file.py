"""Schema of a body's solids in a worksite's file."""

from __future__ import annotations

from aftdeck.bodies.cover import SIDES
from aftdeck.shapes import Axis, Material
from aftdeck.units import Angle, Length
from aftdeck.worksite.file.tables import Placed, Point, Range, Text

Corner = tuple[Length, Length]


class _SolidFile(Placed, frozen=True, kw_only=True, tag_field="kind"):
    """A solid of a body for collision: one convex hexahedron, or several."""

    part: Text
    """Name of the part, for the operator; several solids may share a part."""
    material: Material | None = None
    """Material with which the solid is drawn; None if the body's `shapes` draw it."""
    mirror: bool = False
    """True to add a copy, reflected in the plane y = 0 of the body; the parts are named ``… port``, ``… starboard``."""
    source: Text | None = None
    """Source of the solid's own numbers; None if it is the body's source."""


class BlockFile(_SolidFile, frozen=True, kw_only=True, tag="block"):
    """A box given by its ranges, or a tapered one if the ranges of y or z differ at its far x."""

    x: Range
    y: Range
    z: Range
    y_end: Range | None = None
    z_end: Range | None = None


class BoxFile(_SolidFile, frozen=True, kw_only=True, tag="box"):
    """A box given by its size, about its centre."""

    size: Point


class PlateFile(_SolidFile, frozen=True, kw_only=True, tag="plate"):
    """A plate with an outline of four corners, half of its thickness to each side; as a `shapes.Plate`."""

    normal: Axis
    outline: tuple[Corner, Corner, Corner, Corner]
    thickness: Length


class HexahedronFile(_SolidFile, frozen=True, kw_only=True, tag="hexahedron"):
    """A hexahedron given by its eight vertices, numbered as in `aftdeck.bodies.hexahedron`."""

    vertices: tuple[Point, Point, Point, Point, Point, Point, Point, Point]


class TubeWallFile(_SolidFile, frozen=True, kw_only=True, tag="tube_wall"):
    """The wall of a tube, covered from outside by hexahedra; as `bodies.cover.tube_wall`."""

    radius: Length
    thickness: Length
    length: Length
    radius_end: Length | None = None
    axis: Axis = "x"
    start: Angle = Angle(0.0)
    sweep: Angle
    count: int


class PrismFile(_SolidFile, frozen=True, kw_only=True, tag="prism"):
    """A regular prism, also to enclose a round body; as `bodies.cover.prism`."""

    radius: Length
    """Distance from the axis to a side's middle."""
    length: Length
    radius_end: Length | None = None
    axis: Axis = "x"
    sides: int = SIDES
    turn: Angle = Angle(0.0)


SolidFile = BlockFile | BoxFile | PlateFile | HexahedronFile | TubeWallFile | PrismFile
