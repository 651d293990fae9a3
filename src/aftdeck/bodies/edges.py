"""Edge test: search for an edge of one hexahedron that pierces a face of another hexahedron.

Source: subroutine ETECOL, final report of the Remote Manipulator Simulation (IV.B.1), with three corrections:

- The edges of both bodies are tested.
- An edge is a segment, not a ray.
- An edge is clipped by each face whose bit is different in the location words of the edge's two ends. The source uses
  scalar triple products with a table of bounding edges; the source's method fails for tapered bodies.
"""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import ENDS, SIDES
from aftdeck.bodies.location_words import Words
from aftdeck.law import law


class Pierced(NamedTuple):
    """Piercing edge, and the face through which it enters, both numbered from zero; `edge` is -1 if no edge pierces."""

    edge: int
    face: int


@law
def piercing_edge(above: Array, words: Words) -> Pierced:
    """Return the first edge of a body that passes through another body and has both ends outside.

    Args:
        above: (6, 8) heights of the body's vertices over the other body's faces [m].
        words: (8,) location words of these vertices.
    """
    for e in range(len(ENDS)):
        i, j = ENDS[e, 0], ENDS[e, 1]
        # A piercing edge enters through one plane and leaves through another plane: at least two bits change. If both
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
