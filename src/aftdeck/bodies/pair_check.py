"""Check of a pair of hexahedra that remembers its last result: verdict and clearance.

For use inside compiled code. The result is written into the packed pair (`pair.py`). A plane is stored only after a
test of all sixteen vertices. A collision is stored only with the features that prove it.
"""

from __future__ import annotations

from math import sqrt

import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.bodies.closest import ENCLOSED, Nearest, Simplex, corner, nearest, spanned, weights
from aftdeck.bodies.depth import greatest
from aftdeck.bodies.edges import piercing_edge
from aftdeck.bodies.hexahedron import CORNERS, ENDS, SIDES, VERTICES, vertex
from aftdeck.bodies.location_words import deepest, heights, location_words
from aftdeck.bodies.pair import (
    CLEARANCE,
    CONTACT,
    DISTANCE,
    FEATURE_A,
    FEATURE_B,
    NORMAL,
    POINT_A,
    POINT_B,
    SIMPLEX,
    SIZE,
    WHOLE,
)
from aftdeck.bodies.planes import lowest, sides
from aftdeck.bodies.vector import ZERO, Vector, dot, minus, moved_along, opposite, plus, put_vector, times, vector_at
from aftdeck.law import large_law, law

EDGE_BITS = (1 << ENDS).sum(axis=1, dtype=np.int64)
FACE_BITS = (1 << CORNERS).sum(axis=1, dtype=np.int64)
"""Feature values of the edges (12,) and of the faces (6,), as stored in a packed pair."""
ASIDE = 1e-9
"""Gap [m] to which overlapping bodies are moved apart before the search for their closest points. With a greater gap,
the distance of the closest points could differ from that of their neighbours by less than the rounding errors."""


@law
def verified(a: Array, b: Array, pair: Array) -> bool:
    """Return whether the pair's last normal still separates packed bodies a and b.

    If so, move the pair's plane halfway between the bodies.
    """
    found = sides(a, b, vector_at(pair, NORMAL))
    if found.b - found.a <= CONTACT:
        return False
    pair[DISTANCE] = 0.5 * (found.a + found.b)
    return True


@law
def verdict(a: Array, b: Array, pair: Array) -> bool:
    """Return whether packed bodies a and b collide, and store the plane or the features that prove the verdict.

    If the bodies collide, fill the features; otherwise fill NORMAL and DISTANCE. CLEARANCE and the closest points are
    NaN, unless they were needed for the verdict.
    """
    pair[CLEARANCE : POINT_B + 3] = np.nan
    if verified(a, b, pair):
        return False
    near = nearest(a, b, ZERO, _start(a, b, pair), CONTACT)
    _remember(pair, near.simplex)
    if near.gap > CONTACT and _put_plane(a, b, pair, _towards(near.simplex)):
        return False
    if _penetrates(a, b, pair):
        return True
    return _touching(a, b, pair, near) <= CONTACT


@large_law
def measure(a: Array, b: Array, pair: Array) -> float:
    """Return the clearance of packed bodies a and b [m], and fill the whole pair."""
    near = nearest(a, b, ZERO, _start(a, b, pair), np.inf)
    _remember(pair, near.simplex)
    if near.gap <= CONTACT or not _put_plane(a, b, pair, _towards(near.simplex)):
        return _touching(a, b, pair, near)
    _put_points(a, b, pair, near.simplex)
    pair[CLEARANCE] = near.distance
    return near.distance


@law
def measure_all(bodies: Array, watched: Indices, pairs: Array) -> None:
    """Measure many pairs: packed bodies (n, 48), indices of each pair's two bodies (m, 2), packed pairs (m, 17)."""
    for k in range(len(watched)):
        measure(bodies[watched[k, 0]], bodies[watched[k, 1]], pairs[k])


@law
def _touching(a: Array, b: Array, pair: Array, near: Nearest) -> float:
    """Return the clearance of bodies that overlap or almost overlap, and fill the pair.

    Bodies almost overlap if their distance, apart from rounding errors, is at most CONTACT. The closest points of
    overlapping bodies are the points that are in contact after the shortest move that separates the bodies. To find
    these points, extend this move by ASIDE and apply it to body a; then search for the closest points.

    If no tested plane separates the bodies by more than CONTACT, they count as in contact, whatever the distance of
    their closest points: rounding may make it a little greater than CONTACT.
    """
    above_b, above_a = np.empty((SIDES, VERTICES)), np.empty((SIDES, VERTICES))
    heights(a, b, above_b)
    heights(b, a, above_a)
    best = greatest(a, b, above_b, above_a)
    if best.apart > 0.0 and near.simplex.size < ENCLOSED:
        s, clearance = near.simplex, near.distance
    else:
        moved = times(best.apart - ASIDE, best.normal)
        w = corner(a, b, lowest(a, opposite(best.normal)), lowest(b, best.normal), moved)
        s, clearance = nearest(a, b, moved, spanned(1, w, w, w), np.inf).simplex, best.apart
    _put_points(a, b, pair, s)
    if clearance > CONTACT and not (
        _put_plane(a, b, pair, best.normal) or _put_plane(a, b, pair, _towards(near.simplex))
    ):
        clearance = CONTACT
    pair[CLEARANCE] = clearance
    if clearance <= CONTACT:
        _penetrates(a, b, pair)
    return clearance


@law
def _penetrates(a: Array, b: Array, pair: Array) -> bool:
    """Return whether a vertex of one body is inside the other body, or an edge of one body pierces a face of the other.

    If so, store these features. Always clear the pair's plane (subroutine COLLIDE).
    """
    pair[NORMAL : NORMAL + 4] = 0.0
    above_b, above_a = np.empty((SIDES, VERTICES)), np.empty((SIDES, VERTICES))
    heights(a, b, above_b)
    heights(b, a, above_a)
    of_a, of_b = deepest(above_b), deepest(above_a)
    if of_a.height <= 0.0 and of_a.height <= of_b.height:
        pair[FEATURE_A], pair[FEATURE_B] = 1 << of_a.vertex, WHOLE
        return True
    if of_b.height <= 0.0:
        pair[FEATURE_A], pair[FEATURE_B] = WHOLE, 1 << of_b.vertex
        return True
    words = np.empty(VERTICES, np.int64)
    location_words(above_b, words)
    found = piercing_edge(above_b, words)
    if found.edge >= 0:
        pair[FEATURE_A], pair[FEATURE_B] = EDGE_BITS[found.edge], FACE_BITS[found.face]
        return True
    location_words(above_a, words)
    found = piercing_edge(above_a, words)
    if found.edge >= 0:
        pair[FEATURE_A], pair[FEATURE_B] = FACE_BITS[found.face], EDGE_BITS[found.edge]
        return True
    return False


@law
def _start(a: Array, b: Array, pair: Array) -> Simplex:
    """Return the simplex of the last measurement, at the bodies' present poses.

    For a pair that was never measured, return a simplex with only one corner. This corner combines one vertex of each
    body: the vertex that is farthest in the direction of the other body's centre.
    """
    size = int(pair[SIZE])
    if size == 0:
        # Vertices 1 and 8 are opposite.
        to_a = minus(minus(plus(vertex(a, 0), vertex(a, 7)), vertex(b, 0)), vertex(b, 7))
        w = corner(a, b, lowest(a, to_a), lowest(b, opposite(to_a)), ZERO)
        return spanned(1, w, w, w)
    p, q, r = int(pair[SIMPLEX]), int(pair[SIMPLEX + 1]), int(pair[SIMPLEX + 2])
    return spanned(
        size,
        corner(a, b, p >> 3, p & 7, ZERO),
        corner(a, b, q >> 3, q & 7, ZERO),
        corner(a, b, r >> 3, r & 7, ZERO),
    )


@law
def _remember(pair: Array, s: Simplex) -> None:
    """Store the simplex as the start of the next search. If the simplex is a tetrahedron, store one of its faces."""
    pair[SIZE] = min(s.size, 3)
    pair[SIMPLEX] = 8 * s.p.a + s.p.b
    pair[SIMPLEX + 1] = 8 * s.q.a + s.q.b
    pair[SIMPLEX + 2] = 8 * s.r.a + s.r.b


@law
def _put_plane(a: Array, b: Array, pair: Array, normal: Vector) -> bool:
    """Store the plane halfway between a and b that is perpendicular to a unit normal; return whether it separates them.

    For the direction of the shortest line from a to b, the plane bisects this line (subroutine SPTSG).
    """
    put_vector(pair, NORMAL, normal)
    return verified(a, b, pair)


@law
def _towards(s: Simplex) -> Vector:
    """Return the unit direction of the shortest line from a to b."""
    return times(-1.0 / sqrt(dot(s.point, s.point)), s.point)


@law
def _put_points(a: Array, b: Array, pair: Array, s: Simplex) -> None:
    """Store the points of a and b whose difference is `s.point`, and the features that contain these two points."""
    p, q, r = weights(s)
    i, j, k = s.p.a, s.q.a, s.r.a
    point = moved_along(moved_along(times(p, vertex(a, i)), q, vertex(a, j)), r, vertex(a, k))
    put_vector(pair, POINT_A, point)
    pair[FEATURE_A] = 1 << i | 1 << j | 1 << k
    i, j, k = s.p.b, s.q.b, s.r.b
    point = moved_along(moved_along(times(p, vertex(b, i)), q, vertex(b, j)), r, vertex(b, k))
    put_vector(pair, POINT_B, point)
    pair[FEATURE_B] = 1 << i | 1 << j | 1 << k
