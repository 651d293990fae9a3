"""Collision bodies of an arm file: covers around round parts of the arm, and blocks, which are parts themselves."""

from __future__ import annotations

from typing import Annotated

from aftdeck.arms.constant import Confidence, Part, Text
from aftdeck.arms.link_file import LinkMass, Place
from aftdeck.bodies.cover import FEWEST_SIDES
from aftdeck.bounds import Bounds
from aftdeck.shapes import Axis, Material
from aftdeck.units import Angle, Length

Sides = Annotated[int, Bounds(FEWEST_SIDES, 360, "360 sides cover a cylinder to 0.004 % of its radius")]
"""Number of sides of a prism."""
SignedAxis = Annotated[int, Bounds(-3, 3, "a space has three axes")]


class _Cover(Part, frozen=True, tag_field="kind", kw_only=True):
    """Convex body that encloses another body. The clearance of the enclosed body is therefore never overstated."""

    position: tuple[Length, Length, Length] = (Length(0.0), Length(0.0), Length(0.0))
    """Position of the cover's centre in the frame of the enclosed body."""
    rotation: tuple[Angle, Angle, Angle] = (Angle(0.0), Angle(0.0), Angle(0.0))
    """Roll, pitch, yaw about fixed x, y, z, applied in that order."""


class BoxCover(_Cover, frozen=True, kw_only=True, tag="box"):
    """A box about its centre."""

    size: tuple[Length, Length, Length]


class PrismCover(_Cover, frozen=True, kw_only=True, tag="prism"):
    """A regular prism that encloses a cylinder."""

    axis: Axis = "x"
    radius: Length
    """Radius of the cylinder; the prism's edges are farther from the axis."""
    length: Length
    sides: Sides


Cover = BoxCover | PrismCover


class BoxBody(BoxCover, frozen=True, kw_only=True, tag="box"):
    """A box that covers a part of the arm."""

    part: Text
    """Name of the part, which the operator reads; several bodies may belong to one part."""
    frame: Text
    """Name of the frame that carries the body: ``arm.`` and the joint's name, or ``arm.base``."""
    source: Text
    confidence: Confidence


class PrismBody(PrismCover, frozen=True, kw_only=True, tag="prism"):
    """A prism that covers a part of the arm; `part` and `frame` as in `BoxBody`."""

    part: Text
    frame: Text
    source: Text
    confidence: Confidence


class BlockBody(Part, frozen=True, kw_only=True, tag_field="kind", tag="block"):
    """A part of the arm that is a box itself, along the axes of its frame; `part` and `frame` as in `BoxBody`."""

    part: Text
    frame: Text
    low: Place
    """Corner with the least coordinates."""
    high: Place
    """Corner with the greatest coordinates."""
    axes: tuple[SignedAxis, SignedAxis, SignedAxis] = (1, 2, 3)
    """For each of the block's own axes x, y and z, the number (1 to 3) of the parallel axis of the frame; negative if
    the two directions are opposite. The block's own axes define the numbers of its vertices."""
    material: Material = "padding"
    """Material with which it is drawn if the file names no file of shapes."""
    mass: LinkMass | None = None
    """Mass of the uniform block, for parts whose mass is not in the link behind the joint."""
    source: Text
    confidence: Confidence


BodyFile = BoxBody | PrismBody | BlockBody
