"""Pictures of the collision solids by a depth test for each pixel: the witness for the order of the clusters.

It shares no code with `aftdeck.visual`: it takes the hexahedra themselves, and intersects a ray through the centre of
each pixel with the six planes of each. A pixel shows the part that the ray enters first.
"""

from __future__ import annotations

import numpy as np
from numba import njit

from aftdeck.arrays import Array, Indices
from aftdeck.bodies.hexahedron import NX, SIDES, D, pack
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.constants.site import all_solids
from aftdeck.visual.scene import Aim


class DepthPictures:
    """Depth pictures of a scenario's collision solids.

    Args:
        scenario: the scenario.
        width: width of the pictures [pixels].
        height: height of the pictures [pixels].
    """

    def __init__(self, scenario: Scenario, width: int, height: int) -> None:
        solids = all_solids(scenario)
        self.parts = tuple(dict.fromkeys(solid.part for solid in solids))
        self._part = [self.parts.index(solid.part) for solid in solids]
        self._frame = [solid.frame for solid in solids]
        bodies = np.array([pack(solid.vertices) for solid in solids])
        self._normals = bodies[:, NX:D].reshape(-1, 3, SIDES).transpose(0, 2, 1)
        self._distances = bodies[:, D : D + SIDES]
        self._size = width, height

    def at(self, poses: dict[str, tuple[Array, Array]], aim: Aim, absent: frozenset[str]) -> tuple[Indices, Array]:
        """Return the part that each pixel shows, and its depth (height, width).

        A part is given as its index in `parts`, -1 if there is none; the depth is then infinite.

        Args:
            poses: position and rotation in the scene of each frame that carries solids.
            aim: the camera.
            absent: parts that are not in the picture.
        """
        shown, depth = traced(*self._seen(poses, aim, absent), *rays(aim.wide, aim.high, *self._size))
        return shown, depth

    def distance(self, poses: dict[str, tuple[Array, Array]], aim: Aim, absent: frozenset[str]) -> float:
        """Return a lower bound of the distance from the eye to the nearest part [m]; negative inside a part."""
        _, _, distances = self._seen(poses, aim, absent)
        return float((-distances).max(axis=1).min())

    def _seen(
        self, poses: dict[str, tuple[Array, Array]], aim: Aim, absent: frozenset[str]
    ) -> tuple[Indices, Array, Array]:
        """Return part, normals and distances of the faces of all solids, in the coordinates of a camera."""
        kept, normals, distances = [], [], []
        for k, frame in enumerate(self._frame):
            if self.parts[self._part[k]] in absent:
                continue
            position, rotation = poses[frame]
            turned = self._normals[k] @ rotation.T
            kept.append(self._part[k])
            normals.append(turned @ aim.axes.T)
            distances.append(self._distances[k] + turned @ (position - aim.position))
        return np.array(kept), np.array(normals), np.array(distances)


def rays(wide: float, high: float, width: int, height: int) -> tuple[Array, Array]:
    """Return x/z of the columns' and y/z of the rows' pixel centres."""
    across = ((np.arange(width) + 0.5) / width * 2.0 - 1.0) * wide
    down = ((np.arange(height) + 0.5) / height * 2.0 - 1.0) * high
    return across, down


@njit(cache=True)
def traced(part, normals, distances, across, down):  # type: ignore[no-untyped-def]
    shown = np.full((len(down), len(across)), -1, np.int64)
    depth = np.full((len(down), len(across)), np.inf)
    for row in range(len(down)):
        for column in range(len(across)):
            for k in range(len(part)):
                enters, leaves = 0.0, np.inf
                for f in range(normals.shape[1]):
                    speed = normals[k, f, 0] * across[column] + normals[k, f, 1] * down[row] + normals[k, f, 2]
                    if speed < 0.0:
                        enters = max(enters, distances[k, f] / speed)
                    elif speed > 0.0:
                        leaves = min(leaves, distances[k, f] / speed)
                    elif distances[k, f] < 0.0:
                        leaves = -1.0
                    if enters >= leaves:
                        break
                if enters < leaves and enters < depth[row, column]:
                    depth[row, column], shown[row, column] = enters, part[k]
    return shown, depth
