"""Edge test: search for an edge of one hexahedron that pierces a face of another.

Source: subroutine ETECOL, final report of the Remote Manipulator Simulation (IV.B.1), with three corrections. The test
is made for the edges of both bodies. The edge is a segment instead of a ray. The edge is clipped by the faces that its
location words name; the source uses scalar triple products with a table of bounding edges, which fails for tapered
bodies.
"""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import ENDS, SIDES
from aftdeck.bodies.location_words import Words
from aftdeck.law import law


class Pierced(NamedTuple):
    """Piercing edge, and the face through which it enters, numbered from zero; edge is -1 if no edge pierces."""

    edge: int
    face: int


@law
def piercing_edge(above: Array, words: Words) -> Pierced:
    """Return the first edge that passes through the other body with both ends outside.

    Args:
        above: (6, 8) heights of this body's vertices over the other's faces [m].
        words: (8,) location words of these vertices.
    """
    for e in range(len(ENDS)):
        i, j = ENDS[e, 0], ENDS[e, 1]
        # A piercing edge enters through one plane and leaves through another, so at least two bits change. If both
        # ends are on the TRUE side of the same face, the whole edge is outside.
        changed = words[i] ^ words[j]
        if words[i] & words[j] != 0 or changed & (changed - 1) == 0:
            continue
        enters, leaves, face = 0.0, 1.0, 0
        for f in range(SIDES):
            if changed >> f & 1:
                t = above[f, i] / (above[f, i] - above[f, j])
                if above[f, i] > 0.0:
                    if t > enters:
                        enters, face = t, f
                else:
                    leaves = min(leaves, t)
        if enters <= leaves:
            return Pierced(e, face)
    return Pierced(-1, 0)
