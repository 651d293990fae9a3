"""How far two hexahedra are apart, and what proves it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from aftdeck.arrays import Array
from aftdeck.bodies.check import hexahedron
from aftdeck.bodies.hexahedron import EDGES, FACES
from aftdeck.bodies.pair import CLEARANCE, CONTACT, DISTANCE, FEATURE_A, FEATURE_B, NORMAL, PAIR, POINT_A, POINT_B
from aftdeck.bodies.watch import measure


class Feature(NamedTuple):
    """What of each body meets or is closest: ``vertex 3``, ``edge 34``, ``face b``, or ``body``.

    A vertex and ``body``: the vertex lies inside the other body. An edge and a face: the edge pierces the face.

    Attributes:
        a: of the first body.
        b: of the second body.
    """

    a: str
    b: str


class Plane(NamedTuple):
    """A plane with all of the first body before it and all of the second behind: n·a < distance < n·b.

    Attributes:
        normal: (3,) unit normal, from the first body to the second [1].
        distance: from the origin along the normal [m].
    """

    normal: Array
    distance: float


class Closest(NamedTuple):
    """The two points whose distance is the clearance, or that would touch last on the shortest way apart.

    Attributes:
        a: (3,) point of the first body [m].
        b: (3,) point of the second body [m].
    """

    a: Array
    b: Array


class Separation(NamedTuple):
    """How two hexahedra stand to each other, in the frame that they were given in.

    Attributes:
        collides: whether the clearance is at most 1e-9 m.
        clearance: distance of the two; negative, minus the length of the shortest move that takes them apart [m].
        closest: the closest points; they are as far from each other as the clearance says.
        plane: a plane between them, checked with all sixteen vertices; None where they collide.
        feature: what penetrates or touches where they collide, else what the closest points lie on.
    """

    collides: bool
    clearance: float
    closest: Closest
    plane: Plane | None
    feature: Feature


def separation(a: ArrayLike, b: ArrayLike) -> Separation:
    """Clearance, closest points and separating plane or penetrating feature of two convex hexahedra.

    Vertices are numbered v - 1 = 4 (on the +y side) + 2 (on the +x side) + 1 (on the +z side), in axes of each body's
    own. Clearances are right to 1e-12 m for bodies some tens of metres from the origin. Two bodies watched frame by
    frame inside compiled code are cheaper with `aftdeck.bodies.watch`.

    Args:
        a: (8, 3) vertices of the first body [m].
        b: (8, 3) vertices of the second, in the same frame [m].

    Raises:
        InputError: not convex, not flat in its faces, without volume, or not so numbered; names the vertex.

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
    """What a pair that `measure` has filled says."""
    collides = bool(pair[CLEARANCE] <= CONTACT)
    return Separation(
        collides,
        float(pair[CLEARANCE]),
        Closest(pair[POINT_A : POINT_A + 3].copy(), pair[POINT_B : POINT_B + 3].copy()),
        None if collides else Plane(pair[NORMAL : NORMAL + 3].copy(), float(pair[DISTANCE])),
        Feature(named(int(pair[FEATURE_A])), named(int(pair[FEATURE_B]))),
    )


def named(bits: int) -> str:
    """The name of the smallest feature that has all vertices v whose bits 2**(v - 1) are set."""
    vertices = {v for v in range(1, 9) if bits >> (v - 1) & 1}
    if len(vertices) == 1:
        return f"vertex {min(vertices)}"
    for p, q in EDGES:
        if vertices == {p, q}:
            return f"edge {p}{q}"
    return next((f"face {letter}" for letter, face in FACES.items() if vertices <= set(face)), "body")
