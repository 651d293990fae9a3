"""Convex hexahedron with eight vertices and six flat faces, for all collision tests.

Vertices are numbered 1 to 8. The number of a vertex is 1, plus 4 on the +y side, plus 2 on the +x side, plus 1 on the
+z side, in the body's own axes. Face c is the top (-z), d the bottom (+z), b and e are the sides (-y, +y), a and f are
the ends (-x, +x). The TRUE side of a face is its outside. Source: the final report of the Remote Manipulator
Simulation, Figure 2 (restored).

The laws take a *packed* body: an array (48,) of floats. It holds, in this order: the vertices (all x, all y, all z);
the outward unit normals of faces a to f (all x, all y, all z); the distances of the faces' planes from the origin.
"""

from __future__ import annotations

from itertools import combinations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.vector import Vector
from aftdeck.law import law
from aftdeck.matrices import dots, lengths

VERTICES, SIDES = 8, 6
X, Y, Z = 0, 8, 16
"""Indices of the vertices' coordinates in a packed body [m]."""
NX, NY, NZ, D = 24, 30, 36, 42
"""Indices of the faces' outward unit normals [1] and distances [m]."""
BODY = 48
"""Number of values in a packed body."""

FACES = {
    "a": (1, 2, 5, 6),
    "b": (1, 2, 3, 4),
    "c": (1, 3, 5, 7),
    "d": (2, 4, 6, 8),
    "e": (5, 6, 7, 8),
    "f": (3, 4, 7, 8),
}
"""The four vertices p, q, r, s of each face. The diagonals of a face are p-s and q-r."""
EDGES = tuple(
    (p, q) for p, q in combinations(range(1, 9), 2) if sum({p, q} <= set(face) for face in FACES.values()) == 2
)
"""The twelve edges, each by its two vertices."""

# The same tables for the laws, with vertices, edges and faces numbered from zero.
CORNERS = np.array([[v - 1 for v in face] for face in FACES.values()], dtype=np.int64)
"""(6, 4) vertices of each face."""
ENDS = np.array([[p - 1, q - 1] for p, q in EDGES], dtype=np.int64)
"""(12, 2) ends of each edge."""
_CUBE = np.array([(v >> 1 & 1, v >> 2 & 1, v & 1) for v in range(VERTICES)]) - 0.5
_OUTWARD = _CUBE[CORNERS].sum(axis=1)


def _beside(p: int, q: int) -> tuple[int, int]:
    """Return the two faces of an edge, in the order of BESIDE."""
    f, g = (k for k, face in enumerate(FACES.values()) if {p, q} <= set(face))
    return (f, g) if dots(np.cross(_OUTWARD[f], _OUTWARD[g]), _CUBE[q - 1] - _CUBE[p - 1]) > 0.0 else (g, f)


BESIDE = np.array([_beside(p, q) for p, q in EDGES], dtype=np.int64)
"""(12, 2) faces of each edge. In this order, the cross product of the two normals points along the edge."""


def pack(vertices: Array) -> Array:
    """Return packed bodies (..., 48) from their vertices (..., 8, 3) [m], in the order of their numbers.

    The vertices are not checked. A face's normal is perpendicular to the face's diagonals. A face's plane contains the
    face's outermost vertex.
    """
    corners = vertices[..., CORNERS, :]
    p, q, r, s = (corners[..., k, :] for k in range(4))
    normals = np.cross(s - p, r - q)
    normals /= lengths(normals)[..., None]
    # without these signs, the normals of faces b, c and f would point inwards
    normals *= np.array([1.0, -1.0, -1.0, 1.0, 1.0, -1.0])[:, None]
    distances = dots(corners, normals[..., None, :]).max(axis=-1)
    by_axis = [one.swapaxes(-1, -2).reshape(*one.shape[:-2], -1) for one in (vertices, normals)]
    return np.concatenate([*by_axis, distances], axis=-1)


def unpack(body: Array) -> Array:
    """Return the vertices (8, 3) [m] of a packed body."""
    return body[:NX].reshape(3, VERTICES).T.copy()


@law
def vertex(body: Array, v: int) -> Vector:
    """Return the position [m] of a packed body's vertex `v`; vertices are numbered from zero."""
    return Vector(body[X + v], body[Y + v], body[Z + v])


@law
def face_normal(body: Array, f: int) -> Vector:
    """Return the outward unit normal [1] of a packed body's face `f`; faces are numbered from zero."""
    return Vector(body[NX + f], body[NY + f], body[NZ + f])


@law
def place(body: Array, position: Array, rotation: Array, placed: Array) -> None:
    """Write into `placed` (48,) the packed body rotated by `rotation` (3, 3), then moved by `position` (3,) [m]."""
    x0, y0, z0 = position[0], position[1], position[2]
    for v in range(VERTICES):
        x, y, z = body[X + v], body[Y + v], body[Z + v]
        placed[X + v] = rotation[0, 0] * x + rotation[0, 1] * y + rotation[0, 2] * z + x0
        placed[Y + v] = rotation[1, 0] * x + rotation[1, 1] * y + rotation[1, 2] * z + y0
        placed[Z + v] = rotation[2, 0] * x + rotation[2, 1] * y + rotation[2, 2] * z + z0
    for f in range(SIDES):
        x, y, z = body[NX + f], body[NY + f], body[NZ + f]
        u = rotation[0, 0] * x + rotation[0, 1] * y + rotation[0, 2] * z
        v_ = rotation[1, 0] * x + rotation[1, 1] * y + rotation[1, 2] * z
        w = rotation[2, 0] * x + rotation[2, 1] * y + rotation[2, 2] * z
        placed[NX + f], placed[NY + f], placed[NZ + f] = u, v_, w
        placed[D + f] = body[D + f] + u * x0 + v_ * y0 + w * z0
