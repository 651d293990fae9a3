"""Triangle meshes: the common form in which shapes are drawn, measured or exported."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.frames import Pose
from aftdeck.matrices import dots, lengths, product, reflects


class Mesh(NamedTuple):
    """A surface of triangles.

    In a closed mesh each edge is in two triangles, with opposite directions. Some triangles may have no area.

    Attributes:
        vertices: (n, 3) [m].
        faces: (m, 3) indices of vertices, counter-clockwise as seen from outside.
    """

    vertices: Array
    faces: Indices


def mesh(vertices: Array, faces: Iterable[tuple[int, int, int]]) -> Mesh:
    """Return a mesh of vertices (n, 3) and faces; faces that contain a vertex twice are left out."""
    kept = [face for face in faces if len(set(face)) == 3]
    return Mesh(np.asarray(vertices, dtype=np.float64), np.array(kept, dtype=np.int64).reshape(-1, 3))


def moved(surface: Mesh, motion: Pose) -> Mesh:
    """Return a surface moved by a pose, which may include a reflection."""
    faces = surface.faces[:, ::-1] if reflects(motion.rotation) else surface.faces
    return Mesh(product(surface.vertices, motion.rotation.T) + motion.position, faces)


def joined(surfaces: Iterable[Mesh]) -> Mesh:
    """Return all surfaces as one mesh; vertices are not merged."""
    vertices, faces, first = [np.empty((0, 3))], [np.empty((0, 3), dtype=np.int64)], 0
    for surface in surfaces:
        vertices.append(surface.vertices)
        faces.append(surface.faces + first)
        first += len(surface.vertices)
    return Mesh(np.concatenate(vertices), np.concatenate(faces))


def area(surface: Mesh) -> float:
    """Return the area of all triangles [m^2]."""
    a, b, c = (surface.vertices[surface.faces[:, k]] for k in range(3))
    return 0.5 * float(lengths(np.cross(b - a, c - a)).sum())


def volume(surface: Mesh) -> float:
    """Return the volume of a closed surface [m^3], by the divergence theorem; negative if its faces point inwards."""
    a, b, c = (surface.vertices[surface.faces[:, k]] for k in range(3))
    return float(dots(a, np.cross(b, c)).sum()) / 6.0
