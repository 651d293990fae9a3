"""Marks: what is drawn on the faces of the clusters because it has no collision solid of its own.

A docking port, the marks of a target, a handrail or a lamp is a drawn shape that no cluster represents. Seen along the
normal of the nearest face, it covers a part of this face: the *mark*, one or more convex polygons. Marks belong to
their face and are painted directly after it, so they need no order of their own: nothing is between the two.

A mark is flat. A shape that stands out of its face by up to REACH is drawn on the face as if it were flattened.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.visual.store import MOST_CORNERS

MOST_MARK_CORNERS = 2 * MOST_CORNERS
"""Greatest number of corners of a mark: those of a round shape, and those of the face at which it ends."""


class Marks(NamedTuple):
    """Marks of all clusters, in the order in which they are painted on their face.

    Attributes:
        points: (P, 3) corners, in the frame of the face's cluster [m].
        begins: (M + 1,) first corner of each mark.
        first: (F + 1,) first mark of each face of the clusters.
    """

    points: Array
    begins: Indices
    first: Indices


def no_marks(faces: int) -> Marks:
    """Return the marks of faces that have none."""
    return Marks(np.empty((0, 3)), np.zeros(1, np.int64), np.zeros(faces + 1, np.int64))
