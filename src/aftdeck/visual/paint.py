"""Materials of the clusters' faces, taken from the drawn shapes that the collision solids enclose."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.matrices import lengths
from aftdeck.scene.colours import COLOURS, material_of
from aftdeck.shapes import Material
from aftdeck.visual.drawn import Drawn

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


def surfaces_of(drawn: Iterable[Drawn]) -> Surfaces:
    """Return the surfaces of drawn shapes, without details."""
    parts: dict[str, list[tuple[Array, Array, Indices]]] = {}
    for one in drawn:
        if one.is_detail:
            continue
        a, b, c = (one.surface.vertices[one.surface.faces[:, k]] for k in range(3))
        which = np.full(len(a), _MATERIALS.index(material_of(one.shape)), dtype=np.int64)
        parts.setdefault(one.frame, []).append(((a + b + c) / 3.0, 0.5 * np.cross(b - a, c - a), which))
    return Surfaces(
        {
            frame: _Triangles(*(np.concatenate([part[k] for part in own]) for k in range(3)))
            for frame, own in parts.items()
        }
    )
