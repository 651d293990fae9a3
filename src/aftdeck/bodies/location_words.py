"""Location words: for each vertex of one hexahedron, the faces of another hexahedron on whose TRUE side the vertex is.

Source: vertex-face test in the final report of the Remote Manipulator Simulation (IV.B.1). Subroutine EFFTST tests the
vertices of body `a` against the faces of body `b`. NORMS tests the vertices of `b` against the faces of `a`. A word of
zeros means that the vertex is inside the other body, which is a collision. A bit that is set in all eight words names a
face whose plane separates the two bodies.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import NX, NY, NZ, SIDES, VERTICES, D, X, Y, Z
from aftdeck.law import law

Words = NDArray[np.int64]


class Deepest(NamedTuple):
    """Vertex that is deepest inside the other body.

    Attributes:
        vertex: number of the vertex, from zero.
        height: greatest height of the vertex over a face of the other body [m]; negative if the vertex is inside.
    """

    vertex: int
    height: float


@law
def heights(a: Array, b: Array, above: Array) -> None:
    """Write into `above` (6, 8) the heights of the vertices of `a` over the faces of `b` [m]; negative inside `b`."""
    for f in range(SIDES):
        nx, ny, nz, d = b[NX + f], b[NY + f], b[NZ + f], b[D + f]
        for v in range(VERTICES):
            above[f, v] = nx * a[X + v] + ny * a[Y + v] + nz * a[Z + v] - d


@law
def location_words(above: Array, words: Words) -> None:
    """Write the location words. Bits 0 to 5 stand for faces a to f; a bit is set if the vertex is on the TRUE side."""
    for v in range(VERTICES):
        word = 0
        for f in range(SIDES):
            word |= (above[f, v] > 0.0) << f
        words[v] = word


@law
def deepest(above: Array) -> Deepest:
    """Return the vertex that is deepest inside the other body.

    If no vertex is inside, return the vertex whose greatest height over a face is least.
    """
    vertex, best = 0, np.inf
    for v in range(VERTICES):
        height = above[0, v]
        for f in range(1, SIDES):
            height = max(height, above[f, v])
        if height < best:
            vertex, best = v, height
    return Deepest(vertex, best)
