"""Store of convex polyhedra in flat arrays, for laws that place, cut and order them.

A law can append polyhedra: the pieces of a polyhedron that it cuts. The arrays therefore have free space at their ends.
A polyhedron has at most MOST_CORNERS corners in a face.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from aftdeck.arms.covers import corners
from aftdeck.arrays import Array, Indices
from aftdeck.bodies.hexahedron import NX, SIDES, D, pack, unpack
from aftdeck.scene.solids import RIMS
from aftdeck.tuples import Vec3

MOST_CORNERS = 32
"""Greatest number of corners of a face, and of edges that one cut crosses."""
_COUNTS = 4
"""Number of values in `Store.used`."""
CLUSTERS, POINTS, FACES, CORNERS = range(_COUNTS)
"""Indices in `Store.used`: how many polyhedra, points, faces and corners the arrays contain."""


class Polyhedron(NamedTuple):
    """Convex polyhedron.

    Attributes:
        points: (n, 3) vertices [m].
        planes: (f, 4) outward unit normal and distance of each face [m].
        loops: for each face, the indices of its vertices, counter-clockwise as seen from outside.
    """

    points: Array
    planes: Array
    loops: tuple[tuple[int, ...], ...]


class Store(NamedTuple):
    """Convex polyhedra in flat arrays. All indices count from zero; those of points are indices in `points`.

    Attributes:
        points: (P, 3) vertices of all polyhedra [m].
        planes: (F, 4) outward unit normal and distance of each face [m].
        corners: (C,) vertices of all faces, counter-clockwise as seen from outside.
        first_point: (N + 1,) first vertex of each polyhedron.
        first_face: (N + 1,) first face of each polyhedron.
        first_corner: (F + 1,) first corner of each face.
        owner: (N,) cluster of which the polyhedron is a piece; a cluster is its own owner.
        paint: (F,) face of the cluster whose colour a face has; -1 for a face that a cut made.
        used: (4,) numbers of polyhedra, points, faces and corners that the arrays contain.
    """

    points: Array
    planes: Array
    corners: Indices
    first_point: Indices
    first_face: Indices
    first_corner: Indices
    owner: Indices
    paint: Indices
    used: Indices


def store_of(bodies: Sequence[Polyhedron], room: int = 0) -> Store:
    """Return a store of polyhedra with free space for `room` more polyhedra."""
    counts = [len(body.points) for body in bodies], [len(body.planes) for body in bodies]
    loops = [loop for body in bodies for loop in body.loops]
    starts = np.cumsum([0, *counts[0]])
    shift = np.repeat(starts[:-1], counts[1]) if bodies else np.zeros(0, np.int64)
    numbers = [np.array(loop) + start for loop, start in zip(loops, shift.tolist(), strict=True)]
    points = sum(counts[0]) + room * MOST_CORNERS
    faces = sum(counts[1]) + room * MOST_CORNERS
    used = np.array([len(bodies), sum(counts[0]), sum(counts[1]), sum(map(len, loops))], dtype=np.int64)
    return Store(
        _filled((points, 3), np.concatenate([np.empty((0, 3)), *(body.points for body in bodies)])),
        _filled((faces, 4), np.concatenate([np.empty((0, 4)), *(body.planes for body in bodies)])),
        _indices(int(used[CORNERS]) + 4 * room * MOST_CORNERS, np.concatenate([np.empty(0), *numbers])),
        _indices(len(bodies) + room + 1, starts),
        _indices(len(bodies) + room + 1, np.cumsum([0, *counts[1]])),
        _indices(faces + 1, np.cumsum([0, *map(len, loops)])),
        _indices(len(bodies) + room, np.arange(len(bodies))),
        _indices(faces, np.arange(used[FACES])),
        used,
    )


def polyhedron(store: Store, k: int) -> Polyhedron:
    """Return a copy of one polyhedron of a store."""
    first, end = store.first_point[k], store.first_point[k + 1]
    faces = range(store.first_face[k], store.first_face[k + 1])
    begins = store.first_corner
    return Polyhedron(
        store.points[first:end].copy(),
        store.planes[faces.start : faces.stop].copy(),
        tuple(tuple((store.corners[begins[f] : begins[f + 1]] - first).tolist()) for f in faces),
    )


def of_hexahedron(body: Array) -> Polyhedron:
    """Return the polyhedron of a packed hexahedron (48,)."""
    planes = np.column_stack([body[NX:D].reshape(3, SIDES).T, body[D : D + SIDES]])
    return Polyhedron(unpack(body), planes, RIMS)


def box(low: Vec3, high: Vec3) -> Polyhedron:
    """Return a box from its least and greatest coordinates [m]."""
    return of_hexahedron(pack(corners(low, high)))


def volume(body: Polyhedron) -> float:
    """Return the volume of a polyhedron [m^3], by the divergence theorem."""
    points, middle = body.points.tolist(), body.points.mean(axis=0)
    heights: list[float] = (body.planes[:, 3] - body.planes[:, :3] @ middle).tolist()
    return sum(area([points[i] for i in loop]) * height for loop, height in zip(body.loops, heights, strict=True)) / 3.0


def area(polygon: Sequence[Sequence[float]]) -> float:
    """Return the area of a flat polygon of n corners (x, y, z) [m^2]."""
    (ox, oy, oz), *others = polygon
    away = [(x - ox, y - oy, z - oz) for x, y, z in others]
    normal = [0.0, 0.0, 0.0]
    for (ax, ay, az), (bx, by, bz) in itertools.pairwise(away):
        normal[0] += ay * bz - az * by
        normal[1] += az * bx - ax * bz
        normal[2] += ax * by - ay * bx
    return 0.5 * math.hypot(*normal)


def _filled(shape: tuple[int, int], start: Array) -> Array:
    found = np.zeros(shape)
    found[: len(start)] = start
    return found


def _indices(length: int, start: Array | Indices) -> Indices:
    found = np.zeros(length, dtype=np.int64)
    found[: len(start)] = start
    return found
