"""Outlines of polyhedra in a picture: the convex polygons that they cover, cut off at the edges of the picture.

A point (x, y, z) in the coordinates of a camera, with x to the right, y downwards and z ahead, is drawn at x/z and y/z.
A point is in the picture if abs(x/z) <= wide and abs(y/z) <= high.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.law import law
from aftdeck.visual.cutting import FEWEST_CORNERS, FULL, ON
from aftdeck.visual.store import Store

MOST_POINTS = 96
"""Greatest number of corners of an outline."""
GATHERED = 1024
"""Greatest number of points from which an outline is found."""
_SIDES = 4
"""Number of the picture's edges: left, right, upper, lower."""
NEAR = 5e-3
"""Least distance of a camera's eye from a plane of every cluster in the picture [m]."""


@law
def outcodes(points: Array, begin: int, end: int, wide: float, high: float) -> tuple[int, int]:
    """Return the edges of the picture (as bits) beyond which all vertices are, and beyond which any vertex is.

    The vertices are the points from index `begin` to `end`.
    """
    every, some = 15, 0
    for i in range(begin, end):
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
def touches_eye(planes: Array, begin: int, end: int) -> bool:
    """Return whether the eye is inside a polyhedron, or so near that the plane of no face is farther than NEAR.

    The planes of its faces are those from index `begin` to `end`.
    """
    farthest = np.inf
    for f in range(begin, end):
        farthest = min(farthest, planes[f, 3])
    return bool(farthest >= -NEAR)


@law
def clipped(
    points: Array, corners: Indices, begin: int, end: int, wide: float, high: float, polygon: Array, work: Array
) -> int:
    """Write the part of a face inside the picture into `polygon` (n, 3); return the number of its corners.

    The face's corners are the points `corners[begin:end]`. `polygon` and `work` need room for four more.
    """
    for c in range(begin, end):
        for axis in range(3):
            polygon[c - begin, axis] = points[corners[c], axis]
    return in_picture(polygon, end - begin, wide, high, work)


@law
def in_picture(polygon: Array, count: int, wide: float, high: float, work: Array) -> int:
    """Cut off what is beyond the edges of the picture from a polygon (count, 3); return the number of its corners."""
    for side in range(_SIDES):
        axis, sign, limit = side >> 1, 1.0 if side & 1 else -1.0, high if side & 2 else wide
        inside = 0
        for i in range(count):
            inside += limit * polygon[i, 2] - sign * polygon[i, axis] >= 0.0
        if inside == count:
            continue
        kept = 0
        for i in range(count):
            j = i + 1 if i + 1 < count else 0
            a = limit * polygon[i, 2] - sign * polygon[i, axis]
            b = limit * polygon[j, 2] - sign * polygon[j, axis]
            if a >= 0.0:
                for k in range(3):
                    work[kept, k] = polygon[i, k]
                kept += 1
            if (a < 0.0 and b > 0.0) or (a > 0.0 and b < 0.0):
                part = a / (a - b)
                for k in range(3):
                    work[kept, k] = polygon[i, k] + part * (polygon[j, k] - polygon[i, k])
                kept += 1
        count = kept
        for i in range(count):
            for k in range(3):
                polygon[i, k] = work[i, k]
    return count


@law
def within_planes(planes: Array, begin: int, end: int, f: int, polygon: Array, count: int, work: Array) -> int:
    """Cut off what is outside a polyhedron from a polygon (count, 3) in the plane of its face `f`.

    The polyhedron's planes are those from index `begin` to `end`. A corner up to ON outside a plane is kept: a cut
    there would make an edge whose direction is rounding.
    """
    for g in range(begin, end):
        if g == f:
            continue
        x, y, z, distance = planes[g, 0], planes[g, 1], planes[g, 2], planes[g, 3] + ON
        inside = 0
        for i in range(count):
            inside += distance - x * polygon[i, 0] - y * polygon[i, 1] - z * polygon[i, 2] >= 0.0
        if inside == count:
            continue
        kept = 0
        for i in range(count):
            j = i + 1 if i + 1 < count else 0
            a = distance - x * polygon[i, 0] - y * polygon[i, 1] - z * polygon[i, 2]
            b = distance - x * polygon[j, 0] - y * polygon[j, 1] - z * polygon[j, 2]
            if a >= 0.0:
                for n in range(3):
                    work[kept, n] = polygon[i, n]
                kept += 1
            if (a < 0.0 and b > 0.0) or (a > 0.0 and b < 0.0):
                part = a / (a - b)
                for n in range(3):
                    work[kept, n] = polygon[i, n] + part * (polygon[j, n] - polygon[i, n])
                kept += 1
        count = kept
        for i in range(count):
            for n in range(3):
                polygon[i, n] = work[i, n]
    return count


@law
def outline(
    placed: Store, k: int, crosses: bool, wide: float, high: float, flat: Array, polygon: Array, work: Array
) -> int:
    """Write points into `flat` (GATHERED, 2) whose hull is the outline of a polyhedron; return their number.

    Args:
        placed: the polyhedra.
        k: the polyhedron.
        crosses: whether an edge of the picture cuts the polyhedron.
        wide: tangent of half the horizontal field of view.
        high: tangent of half the vertical field of view.
        flat: output.
        polygon: room for a face.
        work: room for a face.

    Returns:
        Number of points; FULL if there are too many.
    """
    points, corners, planes, first = placed.points, placed.corners, placed.planes, placed.first_corner
    begin, end, count = placed.first_point[k], placed.first_point[k + 1], 0
    if end - begin > GATHERED:
        return FULL
    if not crosses:
        for i in range(begin, end):
            flat[count, 0] = points[i, 0] / points[i, 2]
            flat[count, 1] = points[i, 1] / points[i, 2]
            count += 1
        return count
    for f in range(placed.first_face[k], placed.first_face[k + 1]):
        if planes[f, 3] >= 0.0:
            continue
        size = clipped(points, corners, first[f], first[f + 1], wide, high, polygon, work)
        if count + size > GATHERED:
            return FULL
        for i in range(size):
            flat[count, 0], flat[count, 1] = polygon[i, 0] / polygon[i, 2], polygon[i, 1] / polygon[i, 2]
            count += 1
    return count


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
            x, y = flat[i, 0], flat[i, 1]
            while size >= least:
                ax, ay = found[size - 2, 0], found[size - 2, 1]
                if (found[size - 1, 0] - ax) * (y - ay) - (found[size - 1, 1] - ay) * (x - ax) > 0.0:
                    break
                size -= 1
            if size == len(found):
                return FULL
            found[size, 0], found[size, 1] = x, y
            size += 1
    size -= 1  # the last corner is the first one
    return size if size >= FEWEST_CORNERS else 0


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
def overlapping(
    outlines: Array, sizes: Indices, boxes: Array, new: Mask, count: int, slack: float, pairs: Indices, begin: int
) -> int:
    """Write the pairs (a, b), a > b, of convex outlines that overlap by more than about `slack`; return where they end.

    No edge of either outline of a pair separates the two. The bounds are compared first, in this law: as a law of its
    own, called for each pair, this comparison would take ten times as long, because a call counts references.

    Args:
        outlines: (n, MOST_POINTS, 2) outlines.
        sizes: (n,) their numbers of corners; 0 for an outline that overlaps none.
        boxes: (n, 4) their bounds.
        new: (n,) 1 for each new outline; a pair without a new one is left out.
        count: number of outlines.
        slack: overlap that does not count.
        pairs: output: (m, 2), from index `begin` on.
        begin: the index.
    """
    end = begin
    for a in range(count):
        if sizes[a] == 0:
            continue
        left, top, right, bottom = boxes[a, 0], boxes[a, 1], boxes[a, 2] - slack, boxes[a, 3] - slack
        for b in range(a):
            if not (new[a] or new[b]) or left > boxes[b, 2] - slack or boxes[b, 0] > right:
                continue
            if top > boxes[b, 3] - slack or boxes[b, 1] > bottom or sizes[b] == 0:
                continue
            if _divides(outlines, a, sizes[a], b, sizes[b], slack) or _divides(
                outlines, b, sizes[b], a, sizes[a], slack
            ):
                continue
            pairs[end, 0], pairs[end, 1] = a, b
            end += 1
    return end


@law
def _divides(outlines: Array, p: int, size: int, q: int, others: int, slack: float) -> bool:
    """Return whether an edge of outline `p` has all of outline `q` on its other side; the sizes are their corners."""
    for i in range(size):
        j = i + 1 if i + 1 < size else 0
        x, y = outlines[p, i, 0], outlines[p, i, 1]
        ex, ey = outlines[p, j, 0] - x, outlines[p, j, 1] - y
        limit = slack * (abs(ex) + abs(ey))
        beyond = True
        for k in range(others):
            if ex * (outlines[q, k, 1] - y) - ey * (outlines[q, k, 0] - x) > limit:
                beyond = False
                break
        if beyond:
            return True
    return False
