"""The edge test: which edge of one hexahedron pierces a face of another.

Subroutine ETECOL of the final report of the Remote Manipulator Simulation (IV.B.1), corrected: both ways, the edge as
a segment instead of a ray, and clipped by the faces that its words name instead of scalar triple products with a table
of bounding edges, which tapered bodies outgrow.
"""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import ENDS, SIDES
from aftdeck.bodies.words import Words
from aftdeck.law import law


class Pierced(NamedTuple):
    """The edge and the face through which it enters, from zero; an edge of -1 where none does."""

    edge: int
    face: int


@law
def piercing_edge(above: Array, words: Words) -> Pierced:
    """The first edge that passes through the other body, both ends outside.

    Args:
        above: (6, 8) heights of this body's vertices over the other's faces [m].
        words: (8,) their location words.
    """
    for e in range(len(ENDS)):
        i, j = ENDS[e, 0], ENDS[e, 1]
        # It enters through one plane and leaves through another, so two bits change; ends that share a face's
        # TRUE side have the whole edge there.
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
