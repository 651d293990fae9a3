"""Check that eight vertices form a convex hexahedron; an error names the vertex that is at fault."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import BODY, CORNERS, ENDS, FACES, NX, VERTICES, D, pack
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
_TURNED = (np.array([3, 0, 1, 2]), np.array([1, 2, 3, 0]), np.array([2, 3, 0, 1]))
"""Indices along a rim of the vertex before each vertex, of the one after it, and of the one across."""
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
    return np.asarray(hexahedra(points[None], [name])[0])


def hexahedra(bodies: Array, names: Sequence[str]) -> Array:
    """Check bodies and pack them for the laws, as `hexahedron` does, but all at once.

    Args:
        bodies: (n, 8, 3) vertices [m].
        names: name of each body in an error message.

    Returns:
        (n, 48) packed bodies.

    Raises:
        InputError: a body is not a convex hexahedron; the message is about the first one.
    """
    if not len(bodies):
        return np.empty((0, BODY))
    try:
        for check in (_bounded, _distinct, _right_handed, _flat, _round):
            check(bodies, names)
        packed = pack(bodies)
        _convex(bodies, packed, names)
    except InputError:
        if len(bodies) > 1:  # find the first one
            for body, name in zip(bodies, names, strict=True):
                hexahedra(body[None], [name])
        raise
    return packed


def _first(wrong: ArrayLike) -> int | None:
    """Return the index of the first body for which `wrong` (n,) is True; None if there is none."""
    wrong = np.asarray(wrong)
    return int(wrong.argmax()) if wrong.any() else None


def _at(point: Array) -> str:
    return "({})".format(", ".join(f"{x:.9g}" for x in point))


def _bounded(bodies: Array, names: Sequence[str]) -> None:
    """Reject coordinates that are not finite or too large."""
    outside = np.asarray(~(np.abs(bodies) <= FARTHEST).all(axis=2))
    if (k := _first(outside.any(axis=1))) is not None:
        v = int(outside[k].argmax())
        allowed = f"at most {FARTHEST:g} m" if np.isfinite(bodies[k, v]).all() else "finite"
        raise InputError(f"{names[k]}: vertex {v + 1} is {_at(bodies[k, v])}; coordinates have to be {allowed}")


def _distinct(bodies: Array, names: Sequence[str]) -> None:
    """Reject vertices closer together than SHORTEST."""
    distances = np.linalg.norm(bodies[:, :, None] - bodies[:, None], axis=3)
    distances[:, *np.triu_indices(VERTICES)] = np.inf
    if (k := _first((distances < SHORTEST).any(axis=(1, 2)))) is not None:
        points = bodies[k]
        v, u = np.unravel_index(int(distances[k].argmin()), distances[k].shape)
        raise InputError(
            f"{names[k]}: vertex {v + 1} at {_at(points[v])} is {distances[k, v, u]:.3g} m from vertex {u + 1}; "
            f"two vertices have to be at least {SHORTEST:g} m apart"
        )


def _right_handed(bodies: Array, names: Sequence[str]) -> None:
    """Reject a body that is a mirror image, or that is flat or dented at a vertex."""
    arms = (bodies[:, _BESIDE] - bodies[:, :, None]) * _UPWARD
    turns = np.linalg.det(arms) / np.linalg.norm(arms, axis=3).prod(axis=2)
    if (k := _first((turns <= THINNEST**2).any(axis=1))) is None:
        return
    points, of_body, name = bodies[k], turns[k], names[k]
    if (of_body < -(THINNEST**2)).all():
        raise InputError(
            f"{name}: vertex 2 at {_at(points[1])} makes the body a mirror image: seen from vertex 1, "
            "vertices 2, 3 and 5 have to be in the directions z, x and y of right-handed axes; "
            "exchange 1 with 2, 3 with 4, 5 with 6 and 7 with 8"
        )
    v = int(of_body.argmin())
    what = (
        "is in one plane with" if abs(of_body[v]) <= THINNEST**2 else "is dented in, or numbered wrongly, relative to"
    )
    p, q, r = _BESIDE[v] + 1
    raise InputError(
        f"{name}: vertex {v + 1} at {_at(points[v])} {what} its neighbours {p}, {q} and {r}; "
        "vertices are numbered 1 + 4 (on the +y side) + 2 (on the +x side) + 1 (on the +z side)"
    )


def _flat(bodies: Array, names: Sequence[str]) -> None:
    """Reject a body with bent faces.

    The error names the vertex that is on the greatest number of bent faces. If there are several such vertices, the
    error names the vertex that is farthest from the plane of a face.
    """
    rims = bodies[:, _RIMS]
    before, after, across = (rims[:, :, order] for order in _TURNED)
    normals = np.cross(after - across, before - across)
    away = np.abs(((rims - across) * normals).sum(axis=3)) / np.linalg.norm(normals, axis=3)
    if (k := _first(~(away <= FLAT).all(axis=(1, 2)))) is not None:
        points = bodies[k]
        bent = np.bincount(_RIMS.ravel(), ~(away[k] <= FLAT).ravel(), VERTICES)
        off = np.zeros(VERTICES)
        np.maximum.at(off, _RIMS, away[k])
        v = int(np.lexsort((off, bent))[-1])
        faces = ", ".join(letter for letter, face in FACES.items() if v + 1 in face)
        raise InputError(
            f"{names[k]}: vertex {v + 1} at {_at(points[v])} is {off[v]:.3g} m off the plane of the other three "
            f"vertices of a face (it is on {faces}); at most {FLAT:g} m is allowed"
        )


def _round(bodies: Array, names: Sequence[str]) -> None:
    """Reject a face whose rim crosses itself or is dented."""
    rims = bodies[:, _RIMS]
    before, after, _ = _TURNED
    turns = np.cross(rims[:, :, after] - rims, rims[:, :, before] - rims)
    agree = np.einsum("nfvk,nfk->nfv", turns, turns.sum(axis=2))
    if (k := _first(~(agree > 0.0).all(axis=(1, 2)))) is not None:
        f, at = np.unravel_index(int(agree[k].argmin()), agree[k].shape)
        v, order = _RIMS[f, at], ", ".join(str(vertex + 1) for vertex in _RIMS[f])
        raise InputError(
            f"{names[k]}: vertex {v + 1} at {_at(bodies[k, v])} makes the rim of face {list(FACES)[f]} cross itself or "
            f"turn back; its vertices have to be in this order along the rim: {order}"
        )


def _convex(bodies: Array, packed: Array, names: Sequence[str]) -> None:
    """Check that each vertex is on the inner side of the planes of all faces that do not contain the vertex."""
    longest = np.linalg.norm(bodies[:, ENDS[:, 1]] - bodies[:, ENDS[:, 0]], axis=2).max(axis=1)
    normals, distances = packed[:, NX:D].reshape(-1, 3, 6), packed[:, D:]
    inside = distances[:, :, None] - np.einsum("nkf,nvk->nfv", normals, bodies)
    inside[:, np.repeat(np.arange(len(CORNERS)), 4), CORNERS.ravel()] = np.inf
    least = inside.min(axis=(1, 2))
    if (k := _first(~(least > np.maximum(THINNEST * longest, FLAT)))) is not None:
        f, v = np.unravel_index(int(inside[k].argmin()), inside[k].shape)
        raise InputError(
            f"{names[k]}: vertex {v + 1} at {_at(bodies[k, v])} is {least[k]:.3g} m on the inner side of the plane "
            f"of face {list(FACES)[f]}, which does not contain this vertex; in a convex body, this distance is "
            f"more than {THINNEST:g} of the longest edge and more than {FLAT:g} m"
        )
