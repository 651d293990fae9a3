"""Arrays that the laws of a picture use. They are allocated once, and used again for each picture."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.visual.cutting import FULL
from aftdeck.visual.marks import Marks
from aftdeck.visual.order import NOTES, Entries
from aftdeck.visual.outlines import MOST_POINTS
from aftdeck.visual.polygons import MOST_POLYGONS, Polygons, gather
from aftdeck.visual.store import Polyhedron, store_of

PIECES = 1024
"""Number of pieces of clusters for which there is room; they include those that are cut again."""
ENTRIES = 512
"""Greatest number of polyhedra in a picture."""
SLOTS = 256
"""Number of pieces whose separating planes are remembered."""


class Workspace:
    """Arrays for the pictures of a set of clusters.

    Attributes:
        placed: the clusters in the coordinates of the last camera, and their pieces.
        entries: room for the work of `order.ordered`.
        table: the priority output table of the last picture.
        notes: numbers and clusters to report about it.
    """

    def __init__(self, bodies: Sequence[Polyhedron]) -> None:
        self.placed = store_of(bodies, PIECES)
        self.entries = Entries(
            np.empty(ENTRIES, np.int64),
            np.empty(ENTRIES, np.int64),
            np.empty((ENTRIES, MOST_POINTS, 2)),
            np.empty(ENTRIES, np.int64),
            np.empty((ENTRIES, 4)),
            np.empty(ENTRIES, np.uint8),
            np.empty((ENTRIES * ENTRIES // 2, 2), np.int64),
        )
        self.table = np.empty(ENTRIES, np.int64)
        self.notes = np.empty(NOTES, np.int64)
        self._clusters = len(bodies)
        self._memories: dict[str, Array] = {}
        self._polygons = Polygons(
            np.empty((8 * MOST_POLYGONS, 2)),
            np.empty(MOST_POLYGONS + 1, np.int64),
            np.empty(MOST_POLYGONS, np.int64),
            np.empty(MOST_POLYGONS, np.int64),
            np.empty((MOST_POLYGONS, 3)),
        )

    def memory(self, camera: str) -> Array:
        """Return a camera's memory of separating planes; no order depends on it."""
        if camera not in self._memories:
            slots = self._clusters + SLOTS
            self._memories[camera] = np.zeros((slots, slots, 3))
        return self._memories[camera]

    def polygons(
        self, count: int, wide: float, high: float, marks: Marks, frame: Indices, poses: Array
    ) -> Polygons | None:
        """Return the polygons of the last picture, in new arrays; None if there are more than MOST_POLYGONS.

        Args:
            count: number of entries in the priority output table.
            wide: tangent of half the horizontal field of view.
            high: tangent of half the vertical field of view.
            marks: the marks of the clusters' faces.
            frame: (N,) frame of each cluster.
            poses: (F, 12) poses of the frames in the coordinates of the camera.
        """
        points, begins, owner, face, normal = self._polygons
        written = gather(
            self.placed, self.table, count, wide, high, marks, frame, poses, points, begins, owner, face, normal
        )
        if written == FULL:
            return None
        return Polygons(
            points[: begins[written]].copy(),
            begins[: written + 1].copy(),
            owner[:written].copy(),
            face[:written].copy(),
            normal[:written].copy(),
        )
