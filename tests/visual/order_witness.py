"""Pictures of loose polyhedra, and rays that meet them, for tests of the order."""

from __future__ import annotations

from itertools import product
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron_check import hexahedron
from aftdeck.visual.marks import no_marks
from aftdeck.visual.order import CUTS, ordered
from aftdeck.visual.planes import TOLERANCE
from aftdeck.visual.polygons import Polygons
from aftdeck.visual.solids import apart
from aftdeck.visual.store import Polyhedron, of_hexahedron, store_of
from aftdeck.visual.trees import forest_of
from aftdeck.visual.workspace import Workspace
from tests.bodies.shapes import CUBE, rotations
from tests.visual.depth_picture import rays, traced
from tests.visual.painted_picture import painted

BESIDE = 1e-7
"""Distance by which a ray is moved to find the bodies on both sides of an edge, as a tangent."""
SIZE = 120
"""Width and height of the pictures [pixels]."""
WIDE = 0.7
"""Tangent of half the field of view."""


class Ordered(NamedTuple):
    """Picture of loose bodies.

    Attributes:
        cuts: number of cuts.
        polygons: polygons in painting order.
        eye: position of the eye [m].
        axes: rows are the directions right, down and ahead.
    """

    cuts: int
    polygons: Polygons
    eye: Array
    axes: Array


class Bodies:
    """Polyhedra that do not overlap, each in its own frame, so that no list and no tree compares them."""

    def __init__(self, bodies: list[Polyhedron]) -> None:
        self.bodies = bodies
        self._store = store_of(bodies)
        self._frame = np.arange(len(bodies))
        self._work = Workspace(bodies)

    def order(self, eye: Array, target: Array) -> Ordered:
        """Return the picture seen from an eye towards a target."""
        ahead = (target - eye) / np.linalg.norm(target - eye)
        right = np.cross(ahead, [0.0, 0.0, 1.0])
        right /= np.linalg.norm(right)
        axes = np.array([right, np.cross(ahead, right), ahead])
        pose = np.concatenate([-axes @ eye, axes.ravel()])
        poses = np.tile(pose, (len(self.bodies), 1))
        work, count, none = self._work, len(self.bodies), np.empty((0, 2), np.int64)
        found = ordered(
            self._store, self._frame, none, none, poses, np.ones(count, np.uint8), WIDE, WIDE,
            work.placed, forest_of(self._store, self._frame, count), np.zeros(count, np.uint8),
            np.zeros(count, np.int64), work.memory("eye"), work.entries, work.table, work.notes,
        )  # fmt: skip
        assert found >= 0
        polygons = work.polygons(found, WIDE, WIDE, no_marks(len(self._store.planes)), self._frame, poses)
        assert polygons is not None
        return Ordered(int(work.notes[CUTS]), polygons, eye, axes)

    def wrong_pixels(self, order: Ordered) -> int:
        """Return how many pixels, each with its centre not on an edge, show another body than the ray meets first."""
        shown = painted(order.polygons, SIZE, SIZE)
        planes = np.array([body.planes for body in self.bodies])
        normals, distances = planes[:, :, :3] @ order.axes.T, planes[:, :, 3] - planes[:, :, :3] @ order.eye
        across, down = rays(WIDE, WIDE, SIZE, SIZE)
        right = np.zeros_like(shown, bool)
        for a, b in product((-BESIDE, BESIDE), repeat=2):
            right |= shown == traced(np.arange(len(planes)), normals, distances, across + a, down + b)[0]
        return int((~right).sum())


def first_hit(body: Polyhedron, eye: Array, direction: Array) -> float:
    """Return the distance along a ray, in lengths of `direction`, at which it enters a body; inf if it misses it."""
    enters, leaves = 0.0, np.inf
    for plane in body.planes:
        speed, height = float(plane[:3] @ direction), float(plane[3] - plane[:3] @ eye)
        if speed < 0.0:
            enters = max(enters, height / speed)
        elif speed > 0.0:
            leaves = min(leaves, height / speed)
        elif height < 0.0:
            return np.inf
    return enters if enters < leaves else np.inf


def random_bars(rng: np.random.Generator, count: int) -> list[Polyhedron]:
    """Return long bars in random directions that do not overlap."""
    found: list[Polyhedron] = []
    while len(found) < count:
        corners = CUBE * np.array([6.0, 0.3, 0.3]) @ rotations(rng, 1)[0].T + rng.uniform(-1.5, 1.5, 3)
        bar = of_hexahedron(hexahedron(corners, "bar"))
        if all(apart(bar, other) > TOLERANCE for other in found):
            found.append(bar)
    return found
