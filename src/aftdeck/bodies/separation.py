"""Clearance of two hexahedra, with the plane or feature that proves it."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import EDGES, FACES
from aftdeck.bodies.hexahedron_check import hexahedron
from aftdeck.bodies.pair import CLEARANCE, CONTACT, DISTANCE, FEATURE_A, FEATURE_B, NORMAL, PAIR, POINT_A, POINT_B
from aftdeck.bodies.pair_check import measure


class Feature(NamedTuple):
    """Features that collide or are closest, one of each body: ``vertex 3``, ``edge 34``, ``face b``, or ``body``.

    If the bodies collide, a vertex of one body and ``body`` for the other mean that the vertex is inside the other
    body. An edge of one body and a face of the other mean that the edge pierces the face.

    Attributes:
        a: feature of the first body.
        b: feature of the second body.
    """

    a: str
    b: str


class Plane(NamedTuple):
    """Plane between two bodies: n·a < distance < n·b for every point a of the first body and b of the second body.

    Attributes:
        normal: (3,) unit normal, from the first body to the second [1].
        distance: distance from the origin along the normal [m].
    """

    normal: Array
    distance: float


class Closest(NamedTuple):
    """Closest points of two bodies.

    If the bodies overlap: the points that are in contact after the shortest move that separates the bodies.

    Attributes:
        a: (3,) point of the first body [m].
        b: (3,) point of the second body [m].
    """

    a: Array
    b: Array


class Separation(NamedTuple):
    """Clearance of two hexahedra and its proof, in the frame in which their vertices were given.

    Attributes:
        collides: whether the clearance is at most 1e-9 m.
        clearance: distance between the two bodies [m]; if they overlap, the negative of the length of the shortest move
            that separates them.
        closest: the closest points; the distance between them is the magnitude of the clearance.
        plane: a plane between the bodies, checked with all sixteen vertices; None if the bodies collide.
        feature: if the bodies collide, the features that penetrate or touch; if not, the features that contain the
            closest points.
    """

    collides: bool
    clearance: float
    closest: Closest
    plane: Plane | None
    feature: Feature


def separation(a: ArrayLike, b: ArrayLike) -> Separation:
    """Return the clearance of two convex hexahedra, the closest points, and the separating plane or the features.

    The number of a vertex is 1, plus 4 on the +y side, plus 2 on the +x side, plus 1 on the +z side, in each body's own
    axes. Clearances are accurate to 1e-12 m for bodies some tens of metres from the origin. Compiled code that measures
    the same two bodies in every step uses `aftdeck.bodies.pair_check`, which is faster.

    Args:
        a: (8, 3) vertices of the first body [m].
        b: (8, 3) vertices of the second body, in the same frame [m].

    Raises:
        InputError: a body is not convex, has a bent face or no volume, or its vertices are not in the order above; the
            message names the vertex at fault.

    Examples:
        >>> import numpy as np
        >>> cube = np.array([(x, y, z) for y in (0, 1) for x in (0, 1) for z in (0, 1)])
        >>> found = separation(cube, cube + [1.5, 0, 0])
        >>> found.clearance, found.collides
        (0.5, False)
        >>> separation(cube, cube + [0.75, 0.5, 0.5]).feature
        Feature(a='vertex 8', b='body')
    """
    pair = np.zeros(PAIR)
    measure(hexahedron(a, "the first hexahedron"), hexahedron(b, "the second hexahedron"), pair)
    return read(pair)


def read(pair: Array) -> Separation:
    """Return the contents of a packed pair that `measure` has filled."""
    collides = bool(pair[CLEARANCE] <= CONTACT)
    return Separation(
        collides,
        float(pair[CLEARANCE]),
        Closest(pair[POINT_A : POINT_A + 3].copy(), pair[POINT_B : POINT_B + 3].copy()),
        None if collides else Plane(pair[NORMAL : NORMAL + 3].copy(), float(pair[DISTANCE])),
        Feature(named(int(pair[FEATURE_A])), named(int(pair[FEATURE_B]))),
    )


@lru_cache(maxsize=1 << 8)
def named(bits: int) -> str:
    """Return the name of the smallest feature that contains every vertex v whose bit 2**(v - 1) is set."""
    vertices = {v for v in range(1, 9) if bits >> (v - 1) & 1}
    if len(vertices) == 1:
        return f"vertex {min(vertices)}"
    for p, q in EDGES:
        if vertices == {p, q}:
            return f"edge {p}{q}"
    return next((f"face {letter}" for letter, face in FACES.items() if vertices <= set(face)), "body")
