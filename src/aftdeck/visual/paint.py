"""Materials of the clusters' faces, taken from the drawn shapes that the collision solids enclose."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.frames import IDENTITY, Pose
from aftdeck.kinematics.linkage import L5
from aftdeck.matrices import lengths
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.relative import inverted, scene_in_l
from aftdeck.scene.bodies import PAYLOAD, bodies_of
from aftdeck.scene.colours import COLOURS, material_of
from aftdeck.scene.mesh import moved
from aftdeck.scene.placed import carried, placed
from aftdeck.scene.solids import solid
from aftdeck.shapes import Material

_AROUND = 0.03
"""Distance outside a cluster up to which a shape's triangle belongs to the cluster [m]: a little more than the distance
by which a shape that only adds detail stands out of its collision solid."""
_MATERIALS: tuple[Material, ...] = tuple(COLOURS)


class _Triangles(NamedTuple):
    """Triangles of all shapes in one frame.

    Attributes:
        middle: (n, 3) centres [m].
        normal: (n, 3) normals, each with the length of the triangle's area [m^2].
        material: (n,) index in _MATERIALS.
    """

    middle: Array
    normal: Array
    material: Indices


class Surfaces:
    """Drawn shapes of a scenario as triangles, by frame."""

    def __init__(self, frames: dict[str, _Triangles]) -> None:
        self._frames = frames

    def of(self, frame: str, planes: Array) -> list[Material]:
        """Return the material of each face of a cluster.

        It is the material of the greatest area that faces the same way, among the triangles in the cluster. A face
        without any such triangle has the most frequent material in the cluster, or ``structure`` if it is empty.

        Args:
            frame: frame of the cluster.
            planes: (f, 4) the cluster's faces.
        """
        own = self._frames.get(frame)
        if own is None:
            return ["structure"] * len(planes)
        inside = (own.middle @ planes[:, :3].T <= planes[:, 3] + _AROUND).all(axis=1)
        normal, material = own.normal[inside], own.material[inside]
        total = np.bincount(material, lengths(normal), len(_MATERIALS))
        usual = _MATERIALS[int(total.argmax())] if total.any() else "structure"
        found: list[Material] = []
        for face in planes[:, :3]:
            towards = np.maximum(normal @ face, 0.0) ** 3 / np.maximum(lengths(normal), 1e-12) ** 2
            weight = np.bincount(material, towards, len(_MATERIALS))
            found.append(_MATERIALS[int(weight.argmax())] if weight.any() else usual)
        return found


def surfaces_of(scenario: Scenario) -> Surfaces:
    """Return the drawn shapes of a scenario, each in the frame that carries its body."""
    model = scenario.arm.model
    mount = inverted(scene_in_l(model.mount, scenario.worksite.origin))
    home: dict[str, tuple[str, Pose]] = {body.name: (body.fixed_to, body.pose) for body in scenario.worksite.bodies}
    home[model.linkage.frames[0]] = ("orbiter", mount)
    if scenario.payload is not None:
        tip = Pose(np.array([float(model.links[L5]), 0.0, 0.0]), np.eye(3))
        home[PAYLOAD] = (model.linkage.frames[-1], scenario.payload.pose(tip))
    parts: dict[str, list[tuple[Array, Array, Indices]]] = {}
    for body in bodies_of(scenario):
        frame, pose = home.get(body.name, (body.name, IDENTITY))
        for leaf, own in placed(body.shapes):
            surface = moved(solid(leaf), carried(pose, own))
            a, b, c = (surface.vertices[surface.faces[:, k]] for k in range(3))
            which = np.full(len(a), _MATERIALS.index(material_of(leaf)), dtype=np.int64)
            parts.setdefault(frame, []).append(((a + b + c) / 3.0, 0.5 * np.cross(b - a, c - a), which))
    return Surfaces(
        {
            frame: _Triangles(*(np.concatenate([part[k] for part in own]) for k in range(3)))
            for frame, own in parts.items()
        }
    )
