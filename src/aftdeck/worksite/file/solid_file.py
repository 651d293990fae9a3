"""Schema of a body's solids in a worksite's file."""

from __future__ import annotations

from typing import Annotated

from aftdeck.arms.body_file import Sides
from aftdeck.bodies.cover import FEWEST_WALLS, SIDES
from aftdeck.bounds import Bounds
from aftdeck.shapes import Axis, Material
from aftdeck.units import Angle, Length
from aftdeck.worksite.tables import Placed, Point, Range, Text

Corner = tuple[Length, Length]


class _SolidFile(Placed, frozen=True, kw_only=True, tag_field="kind"):
    """An entry for one or more convex hexahedra, with which a body collides."""

    part: Text
    """Name of the part, for the operator; several solids may share a part."""
    material: Material | None = None
    """Material with which the solid is drawn; None if the body's `shapes` draw it."""
    mirror: bool = False
    """True to add a copy that is reflected in the plane y = 0 of the body. The two parts are then named ``… port`` and
    ``… starboard``."""
    source: Text | None = None
    """Source of the solid's own numbers; None if the body's source applies."""


class BlockFile(_SolidFile, frozen=True, kw_only=True, tag="block"):
    """A box given by its ranges. `y_end` and `z_end` taper it: they replace `y` and `z` at the end with greater x."""

    x: Range
    y: Range
    z: Range
    y_end: Range | None = None
    z_end: Range | None = None


class BoxFile(_SolidFile, frozen=True, kw_only=True, tag="box"):
    """A box given by its size; its centre is at `position`."""

    size: Point


class PlateFile(_SolidFile, frozen=True, kw_only=True, tag="plate"):
    """A plate.

    Its outline has four corners and is midway between the two surfaces. The fields are those of `shapes.Plate`.
    """

    normal: Axis
    outline: tuple[Corner, Corner, Corner, Corner]
    thickness: Length


class HexahedronFile(_SolidFile, frozen=True, kw_only=True, tag="hexahedron"):
    """A hexahedron given by its eight vertices, numbered as in `aftdeck.bodies.hexahedron`."""

    vertices: tuple[Point, Point, Point, Point, Point, Point, Point, Point]


class TubeWallFile(_SolidFile, frozen=True, kw_only=True, tag="tube_wall"):
    """The wall of a tube, covered by hexahedra.

    The fields are the arguments of `bodies.cover.tube_wall`.
    """

    radius: Length
    thickness: Length
    length: Length
    radius_end: Length | None = None
    axis: Axis = "x"
    start: Angle = Angle(0.0)
    sweep: Angle
    count: Annotated[int, Bounds(FEWEST_WALLS, 360, "360 hexahedra cover a tube to 0.004 % of its radius")]


class PrismFile(_SolidFile, frozen=True, kw_only=True, tag="prism"):
    """A regular prism, which may enclose a round body. The fields are the arguments of `bodies.cover.prism`."""

    radius: Length
    """Distance from the axis to the middle of a side."""
    length: Length
    radius_end: Length | None = None
    axis: Axis = "x"
    sides: Sides = SIDES
    turn: Angle = Angle(0.0)


SolidFile = BlockFile | BoxFile | PlateFile | HexahedronFile | TubeWallFile | PrismFile
