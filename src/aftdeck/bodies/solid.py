"""Solid: a convex hexahedron for collision, with the frame that carries it and the name of its part."""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.arrays import Array


class Solid(NamedTuple):
    """Convex hexahedron for collision.

    Attributes:
        part: name of the part, which the operator reads: "upper boom", "palm", "bay wall port". Several solids may
            belong to one part.
        frame: name of the frame that carries the solid.
        vertices: (8, 3) vertices in that frame [m], numbered as in `bodies.hexahedron`.
    """

    part: str
    frame: str
    vertices: Array
