"""Outlines of polyhedra in a picture: the convex polygons that they cover, cut off at the edges of the picture.

A point (x, y, z) in the coordinates of a camera, with x to the right, y downwards and z ahead, is drawn at x/z and y/z.
A point is in the picture if abs(x/z) <= wide and abs(y/z) <= high.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.law import law
from aftdeck.visual.cutting import FEWEST_CORNERS, FULL, ON
from aftdeck.visual.store import MOST_CORNERS, Store

MOST_POINTS = 96
"""Greatest number of corners of an outline."""
_GATHERED = 1024
"""Greatest number of points from which an outline is found."""
_SIDES = 4
"""Number of the picture's edges: left, right, upper, lower."""
NEAR = 5e-3
"""Least distance of a camera's eye from a plane of every cluster in the picture [m]."""


@law
def outcodes(placed: Store, k: int, wide: float, high: float) -> tuple[int, int]:
    """Return the edges of the picture (as bits) beyond which all vertices are, and beyond which any vertex is."""
    every, some, points = 15, 0, placed.points
    for i in range(placed.first_point[k], placed.first_point[k + 1]):
        x, y, z = points[i, 0], points[i, 1], points[i, 2]
        code = 0
        if x < -wide * z:
            code |= 1
        if x > wide * z:
            code |= 2
        if y < -high * z:
            code |= 4
        if y > high * z:
            code |= 8
        every &= code
        some |= code
    return every, some


@law
def touches_eye(placed: Store, k: int) -> bool:
    """Return whether the eye is inside a polyhedron, or so near that the plane of no face is farther than NEAR."""
    farthest = np.inf
    for f in range(placed.first_face[k], placed.first_face[k + 1]):
        farthest = min(farthest, placed.planes[f, 3])
    return bool(farthest >= -NEAR)


@law
def clipped(placed: Store, f: int, wide: float, high: float, polygon: Array, work: Array) -> int:
    """Write the part of a face inside the picture into `polygon` (n, 3); return the number of its corners.

    `polygon` and `work` need room for the face's corners and four more.
    """
    count = 0
    for c in range(placed.first_corner[f], placed.first_corner[f + 1]):
        polygon[count] = placed.points[placed.corners[c]]
        count += 1
    return in_picture(polygon, count, wide, high, work)


@law
def in_picture(polygon: Array, count: int, wide: float, high: float, work: Array) -> int:
    """Cut off what is beyond the edges of the picture from a polygon (count, 3); return the number of its corners."""
    for side in range(_SIDES):
        axis, sign, limit = side >> 1, 1.0 if side & 1 else -1.0, high if side & 2 else wide
        kept = 0
        for i in range(count):
            j = i + 1 if i + 1 < count else 0
            a = limit * polygon[i, 2] - sign * polygon[i, axis]
            b = limit * polygon[j, 2] - sign * polygon[j, axis]
            if a >= 0.0:
                work[kept] = polygon[i]
                kept += 1
            if (a < 0.0 and b > 0.0) or (a > 0.0 and b < 0.0):
                part = a / (a - b)
                for k in range(3):
                    work[kept, k] = polygon[i, k] + part * (polygon[j, k] - polygon[i, k])
                kept += 1
        count = kept
        for i in range(count):
            polygon[i] = work[i]
    return count


@law
def within_planes(placed: Store, k: int, f: int, polygon: Array, count: int, work: Array) -> int:
    """Cut off what is outside polyhedron `k` from a polygon (count, 3) in the plane of its face `f`.

    A corner up to ON outside a plane is kept: a cut there would make an edge whose direction is rounding.
    """
    for g in range(placed.first_face[k], placed.first_face[k + 1]):
        if g == f:
            continue
        kept = 0
        for i in range(count):
            j = i + 1 if i + 1 < count else 0
            a, b = placed.planes[g, 3] + ON, placed.planes[g, 3] + ON
            for n in range(3):
                a -= placed.planes[g, n] * polygon[i, n]
                b -= placed.planes[g, n] * polygon[j, n]
            if a >= 0.0:
                work[kept] = polygon[i]
                kept += 1
            if (a < 0.0 and b > 0.0) or (a > 0.0 and b < 0.0):
                part = a / (a - b)
                for n in range(3):
                    work[kept, n] = polygon[i, n] + part * (polygon[j, n] - polygon[i, n])
                kept += 1
        count = kept
        for i in range(count):
            polygon[i] = work[i]
    return count


@law
def outline(placed: Store, k: int, crosses: bool, wide: float, high: float, found: Array) -> int:
    """Write the outline of a polyhedron into `found` (MOST_POINTS, 2), counter-clockwise for x right and y up.

    Args:
        placed: the polyhedra.
        k: the polyhedron.
        crosses: whether an edge of the picture cuts the polyhedron.
        wide: tangent of half the horizontal field of view.
        high: tangent of half the vertical field of view.
        found: output.

    Returns:
        Number of corners; 0 if the polyhedron is not in the picture; FULL if there are too many.
    """
    flat, count = np.empty((_GATHERED, 2)), 0
    if placed.first_point[k + 1] - placed.first_point[k] > _GATHERED:
        return FULL
    if not crosses:
        for i in range(placed.first_point[k], placed.first_point[k + 1]):
            flat[count, 0] = placed.points[i, 0] / placed.points[i, 2]
            flat[count, 1] = placed.points[i, 1] / placed.points[i, 2]
            count += 1
        return convex_hull(flat, count, found)
    polygon, work = np.empty((MOST_CORNERS + 8, 3)), np.empty((MOST_CORNERS + 8, 3))
    for f in range(placed.first_face[k], placed.first_face[k + 1]):
        if placed.planes[f, 3] >= 0.0:
            continue
        corners = clipped(placed, f, wide, high, polygon, work)
        if count + corners > _GATHERED:
            return FULL
        for i in range(corners):
            flat[count, 0], flat[count, 1] = polygon[i, 0] / polygon[i, 2], polygon[i, 1] / polygon[i, 2]
            count += 1
    return convex_hull(flat, count, found)


@law
def convex_hull(flat: Array, count: int, found: Array) -> int:
    """Sort points (count, 2), and write their convex hull into `found`; return its number of corners (Andrew, 1979)."""
    for i in range(1, count):
        x, y, j = flat[i, 0], flat[i, 1], i - 1
        while j >= 0 and (flat[j, 0] > x or (flat[j, 0] == x and flat[j, 1] > y)):
            flat[j + 1, 0], flat[j + 1, 1] = flat[j, 0], flat[j, 1]
            j -= 1
        flat[j + 1, 0], flat[j + 1, 1] = x, y
    size = 0
    if count < FEWEST_CORNERS:
        return 0
    for half in range(2):
        least = size + 1 if half else 2
        for step in range(count):
            i = count - 1 - step if half else step
            if half and step == 0:
                continue
            while size >= least and _turn(found, size, flat[i, 0], flat[i, 1]) <= 0.0:
                size -= 1
            if size == len(found):
                return FULL
            found[size, 0], found[size, 1] = flat[i, 0], flat[i, 1]
            size += 1
    size -= 1  # the last corner is the first one
    return size if size >= FEWEST_CORNERS else 0


@law
def _turn(found: Array, size: int, x: float, y: float) -> float:
    ax, ay = found[size - 2, 0], found[size - 2, 1]
    turn: float = (found[size - 1, 0] - ax) * (y - ay) - (found[size - 1, 1] - ay) * (x - ax)
    return turn


@law
def bound(outlines: Array, k: int, size: int, boxes: Array) -> None:
    """Write the least x and y and the greatest x and y of an outline into its row of `boxes` (n, 4)."""
    left, top, right, bottom = np.inf, np.inf, -np.inf, -np.inf
    for i in range(size):
        x, y = outlines[k, i, 0], outlines[k, i, 1]
        left, right = x if x < left else left, x if x > right else right
        top, bottom = y if y < top else top, y if y > bottom else bottom
    boxes[k, 0], boxes[k, 1], boxes[k, 2], boxes[k, 3] = left, top, right, bottom


@law
def overlap(outlines: Array, sizes: Indices, boxes: Array, a: int, b: int, slack: float) -> bool:
    """Return whether two convex outlines overlap by more than about `slack`: no edge of either separates them.

    Args:
        outlines: (n, MOST_POINTS, 2) outlines.
        sizes: (n,) their numbers of corners.
        boxes: (n, 4) their bounds, which are compared first.
        a: the first outline.
        b: the second outline.
        slack: overlap that does not count.
    """
    if sizes[a] == 0 or sizes[b] == 0:
        return False
    if boxes[a, 0] > boxes[b, 2] - slack or boxes[b, 0] > boxes[a, 2] - slack:
        return False
    if boxes[a, 1] > boxes[b, 3] - slack or boxes[b, 1] > boxes[a, 3] - slack:
        return False
    for side in range(2):
        p, q = (a, b) if side == 0 else (b, a)
        for i in range(sizes[p]):
            j = i + 1 if i + 1 < sizes[p] else 0
            x, y = outlines[p, i, 0], outlines[p, i, 1]
            ex, ey = outlines[p, j, 0] - x, outlines[p, j, 1] - y
            limit = slack * (abs(ex) + abs(ey))
            beyond = True
            for k in range(sizes[q]):
                if ex * (outlines[q, k, 1] - y) - ey * (outlines[q, k, 0] - x) > limit:
                    beyond = False
                    break
            if beyond:
                return False
    return True
