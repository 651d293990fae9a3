"""A solid: a convex hexahedron for collision, with the frame that carries it and the name that people give it."""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.arrays import Array


class Solid(NamedTuple):
    """A convex hexahedron for collision.

    Attributes:
        part: what people call it: "upper boom", "palm", "bay wall port"; several solids may share a part.
        frame: name of the frame that carries it.
        vertices: (8, 3) in that frame [m], numbered as in `bodies.hexahedron`.
    """

    part: str
    frame: str
    vertices: Array
