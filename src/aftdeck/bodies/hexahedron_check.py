"""Check that eight vertices form a convex hexahedron; an error names the vertex that is at fault."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import CORNERS, ENDS, FACES, VERTICES, pack
from aftdeck.errors import InputError

FLAT = 1e-9
"""Greatest allowed distance of a face's vertices from the face's plane [m]; equal to `pair.CONTACT`."""
FARTHEST = 1e4
"""Greatest allowed coordinate [m] (assumed). For greater values, rounding errors are not small compared with FLAT."""
SHORTEST = 1e-6
"""Smallest allowed distance between two vertices [m] (assumed)."""
THINNEST = 1e-6
"""Least allowed distance of a vertex from the plane of a face that does not contain the vertex, as a share of the
longest edge [1] (assumed). The distance is positive on the inner side."""

_RIMS = CORNERS[:, [0, 1, 3, 2]]
"""(6, 4) vertices of each face in order along its rim, numbered from zero."""
_BESIDE = np.arange(VERTICES)[:, None] ^ np.array([1, 2, 4])
"""(8, 3) neighbours of each vertex along the body's own z, x and y, numbered from zero."""
_UPWARD = np.sign(_BESIDE - np.arange(VERTICES)[:, None])[..., None]
"""(8, 3, 1) 1 if the neighbour is in the positive direction of the axis (z, x or y), otherwise -1."""


def hexahedron(vertices: ArrayLike, name: str = "the hexahedron") -> Array:
    """Check eight vertices and pack them for the laws.

    Args:
        vertices: (8, 3), numbered as in `aftdeck.bodies.hexahedron`, in any frame [m].
        name: name of the body in an error message.

    Returns:
        (48,) packed body.

    Raises:
        InputError: the vertices are not a convex hexahedron with flat faces in this numbering; the message names the
            vertex at fault.
    """
    try:
        points = np.array(vertices, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(f"{name}: expected numbers of shape (8, 3), got {vertices!r}") from None
    if points.shape != (VERTICES, 3):
        raise InputError(f"{name}: expected 8 vertices with x, y and z, shape (8, 3), got shape {points.shape}")
    for v in np.flatnonzero(~(np.abs(points) <= FARTHEST).all(axis=1)):
        allowed = f"at most {FARTHEST:g} m" if np.isfinite(points[v]).all() else "finite"
        raise InputError(f"{name}: vertex {v + 1} is {_at(points[v])}; coordinates have to be {allowed}")
    _distinct(points, name)
    _right_handed(points, name)
    _flat(points, name)
    _round(points, name)
    body = pack(points)
    _convex(points, body, name)
    return body


def _at(point: Array) -> str:
    return "({})".format(", ".join(f"{x:.9g}" for x in point))


def _distinct(points: Array, name: str) -> None:
    """Reject vertices closer together than SHORTEST."""
    distances = np.linalg.norm(points[:, None] - points, axis=2)
    distances[np.triu_indices(VERTICES)] = np.inf
    v, u = np.unravel_index(int(distances.argmin()), distances.shape)
    if distances[v, u] < SHORTEST:
        raise InputError(
            f"{name}: vertex {v + 1} at {_at(points[v])} is {distances[v, u]:.3g} m from vertex {u + 1}; "
            f"two vertices have to be at least {SHORTEST:g} m apart"
        )


def _right_handed(points: Array, name: str) -> None:
    """Reject a body that is a mirror image, or that is flat or dented at a vertex."""
    arms = (points[_BESIDE] - points[:, None]) * _UPWARD
    turns = np.linalg.det(arms) / np.linalg.norm(arms, axis=2).prod(axis=1)
    if (turns < -(THINNEST**2)).all():
        raise InputError(
            f"{name}: vertex 2 at {_at(points[1])} makes the body a mirror image: seen from vertex 1, "
            "vertices 2, 3 and 5 have to be in the directions z, x and y of right-handed axes; "
            "exchange 1 with 2, 3 with 4, 5 with 6 and 7 with 8"
        )
    v = int(turns.argmin())
    if turns[v] <= THINNEST**2:
        what = (
            "is in one plane with" if abs(turns[v]) <= THINNEST**2 else "is dented in, or numbered wrongly, relative to"
        )
        p, q, r = _BESIDE[v] + 1
        raise InputError(
            f"{name}: vertex {v + 1} at {_at(points[v])} {what} its neighbours {p}, {q} and {r}; "
            "vertices are numbered 1 + 4 (on the +y side) + 2 (on the +x side) + 1 (on the +z side)"
        )


def _flat(points: Array, name: str) -> None:
    """Reject a body with bent faces.

    The error names the vertex that is on the greatest number of bent faces. If there are several such vertices, the
    error names the vertex that is farthest from the plane of a face.
    """
    rims = points[_RIMS]
    before, after, across = (np.roll(rims, k, axis=1) for k in (1, -1, 2))
    normals = np.cross(after - across, before - across)
    away = np.abs(((rims - across) * normals).sum(axis=2)) / np.linalg.norm(normals, axis=2)
    bent = np.bincount(_RIMS.ravel(), ~(away <= FLAT).ravel(), VERTICES)
    if bent.any():
        off = np.zeros(VERTICES)
        np.maximum.at(off, _RIMS, away)
        v = int(np.lexsort((off, bent))[-1])
        faces = ", ".join(letter for letter, face in FACES.items() if v + 1 in face)
        raise InputError(
            f"{name}: vertex {v + 1} at {_at(points[v])} is {off[v]:.3g} m off the plane of the other three vertices "
            f"of a face (it is on {faces}); at most {FLAT:g} m is allowed"
        )


def _round(points: Array, name: str) -> None:
    """Reject a face whose rim crosses itself or is dented."""
    rims = points[_RIMS]
    turns = np.cross(np.roll(rims, -1, axis=1) - rims, np.roll(rims, 1, axis=1) - rims)
    agree = np.einsum("fvk,fk->fv", turns, turns.sum(axis=1))
    f, k = np.unravel_index(int(agree.argmin()), agree.shape)
    if not agree[f, k] > 0.0:
        v, order = _RIMS[f, k], ", ".join(str(vertex + 1) for vertex in _RIMS[f])
        raise InputError(
            f"{name}: vertex {v + 1} at {_at(points[v])} makes the rim of face {list(FACES)[f]} cross itself or turn "
            f"back; its vertices have to be in this order along the rim: {order}"
        )


def _convex(points: Array, body: Array, name: str) -> None:
    """Check that each vertex is on the inner side of the planes of all faces that do not contain the vertex."""
    longest = np.linalg.norm(points[ENDS[:, 1]] - points[ENDS[:, 0]], axis=1).max()
    normals, distances = body[24:42].reshape(3, 6).T, body[42:]
    inside = distances[:, None] - normals @ points.T
    inside[np.repeat(np.arange(len(CORNERS)), 4), CORNERS.ravel()] = np.inf
    f, v = np.unravel_index(int(inside.argmin()), inside.shape)
    if not inside[f, v] > max(THINNEST * longest, FLAT):
        raise InputError(
            f"{name}: vertex {v + 1} at {_at(points[v])} is {inside[f, v]:.3g} m on the inner side of the plane "
            f"of face {list(FACES)[f]}, which does not contain this vertex; in a convex body, this distance is "
            f"more than {THINNEST:g} of the longest edge and more than {FLAT:g} m"
        )
