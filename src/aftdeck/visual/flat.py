"""Convex polygons in a plane: hull, the part inside another polygon, and unions that are convex.

A polygon is a list of corners (x, y) [m], counter-clockwise.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from aftdeck.shapes import Vec2

Flat = list[Vec2]
"""A convex polygon."""
FEWEST_CORNERS = 3
_LEAST = 1e-9
"""Area below which a polygon counts as empty, and twice which a corner may turn to the wrong side [m^2]."""
_SHORT = 1e-6
"""Length of an edge below which its ends count as one corner [m]: its direction would be rounding."""
_THERE_AND_BACK = 2
"""Number of changes between rising and falling of a convex polygon's corners: at the greatest and at the least one."""
_SAME = 7
"""Number of decimals up to which corners of neighbouring polygons are equal [of a metre]."""


def area(polygon: Sequence[Vec2]) -> float:
    """Return the area of a polygon [m^2]; negative if it is clockwise."""
    if not polygon:
        return 0.0
    double, (ax, ay) = 0.0, polygon[0]
    for bx, by in (*polygon[1:], polygon[0]):
        double += ax * by - ay * bx
        ax, ay = bx, by
    return 0.5 * double


def hull(points: Iterable[Vec2]) -> Flat:
    """Return the convex hull of points (Andrew, 1979); empty if it has no area."""
    ordered = sorted(set(points))
    found = _half(ordered) + _half(ordered[::-1])
    return found if len(found) >= FEWEST_CORNERS and area(found) > _LEAST else []


def _half(points: Flat) -> Flat:
    """Return the half of a hull to the right of the line from the first to the last of sorted points, but this one."""
    half: Flat = []
    for point in points:
        cx, cy = point
        while len(half) > 1:
            (ax, ay), (bx, by) = half[-2], half[-1]
            if (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) > 0.0:  # as `_turn`; a call would take twice as long
                break
            half.pop()
        half.append(point)
    return half[:-1]


def is_convex(polygon: Sequence[Vec2]) -> bool:
    """Return whether a polygon turns to the left, or nowhere, at each corner."""
    (ax, ay), (bx, by) = polygon[-2], polygon[-1]
    for cx, cy in polygon:
        if (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) < -_LEAST:
            return False
        ax, ay, bx, by = bx, by, cx, cy
    return True


def common(polygon: Flat, others: Flat) -> Flat:
    """Return the part of a polygon inside another one; empty if it has no area."""
    left, a = polygon, others[0]
    for b in (*others[1:], a):
        if not left:
            return []
        left, a = _left_of(a, b, left), b
    left = [p for p, q in _edges(left) if abs(p[0] - q[0]) + abs(p[1] - q[1]) > _SHORT]
    return left if len(left) >= FEWEST_CORNERS and area(left) > _LEAST else []


def _left_of(a: Vec2, b: Vec2, polygon: Flat) -> Flat:
    """Return the part of a polygon to the left of the line from `a` to `b`."""
    (ax, ay), (along_x, along_y) = a, (b[0] - a[0], b[1] - a[1])
    turns = [along_x * (y - ay) - along_y * (x - ax) for x, y in polygon]
    if min(turns) >= 0.0:
        return polygon
    kept: Flat = []
    for k, (p, from_p) in enumerate(zip(polygon, turns, strict=True)):
        if from_p >= 0.0:
            kept.append(p)
        from_q = turns[k + 1 - len(turns)]
        if from_p * from_q < 0.0:
            q, part = polygon[k + 1 - len(turns)], from_p / (from_p - from_q)
            kept.append((p[0] + part * (q[0] - p[0]), p[1] + part * (q[1] - p[1])))
    return kept


def covers(polygon: Flat, other: Flat) -> bool:
    """Return whether a polygon contains another one."""
    ax, ay = polygon[-1]
    for bx, by in polygon:
        along_x, along_y = bx - ax, by - ay
        for x, y in other:
            if along_x * (y - ay) - along_y * (x - ax) < -_LEAST:
                return False
        ax, ay = bx, by
    return True


def merged(polygons: Iterable[Flat]) -> list[Flat]:
    """Return polygons that fill the same area: two that share an edge become one if their union is convex."""
    rounded = ([(round(x, _SAME), round(y, _SAME)) for x, y in polygon] for polygon in polygons)
    left = dict(enumerate(polygon for polygon in rounded if area(polygon) > _LEAST))
    at = {edge: k for k, polygon in left.items() for edge in _edges(polygon)}
    found: list[Flat] = []
    while left:
        _, polygon = left.popitem()
        for a, b in _edges(polygon):
            k = at.get((b, a))
            if k in left and (both := _union(polygon, left[k], a, b)):
                left[k] = both
                at.update(dict.fromkeys(_edges(both), k))
                break
        else:
            found.append(hull(polygon))
    return [polygon for polygon in found if polygon]


def _union(polygon: Flat, other: Flat, a: Vec2, b: Vec2) -> Flat:
    """Return the union of two polygons that share the edge from `a` to `b`; empty if it is not convex."""
    # round the first polygon from b to a, then round the other one from a to b
    first, second = polygon.index(b), other.index(a)
    both = polygon[first:] + polygon[:first] + (other[second:] + other[:second])[1:-1]
    end = len(polygon) - 1
    if _turn(both[-1], b, both[1]) < -_LEAST or _turn(both[end - 1], a, both[end + 1 - len(both)]) < -_LEAST:
        return []
    if _is_round(both):
        return both
    return both if is_convex(both) and area(hull(both)) <= area(both) + _LEAST else []


def _is_round(polygon: Flat) -> bool:
    """Return whether a polygon turns to the left, or nowhere, at each corner, and once round in all.

    It is then its own hull, but for rounding. If it turns back at a corner, it has more than one least corner.
    """
    (ax, ay), (bx, by) = polygon[-2], polygon[-1]
    rises, changes = (ax, ay) < (bx, by), 0
    for cx, cy in polygon:
        if (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) < 0.0:
            return False
        rose, rises = rises, (bx, by) < (cx, cy)
        changes += rises != rose
        ax, ay, bx, by = bx, by, cx, cy
    return changes == _THERE_AND_BACK


def _edges(polygon: Sequence[Vec2]) -> list[tuple[Vec2, Vec2]]:
    return list(zip(polygon, [*polygon[1:], *polygon[:1]], strict=True))


def _turn(a: Vec2, b: Vec2, c: Vec2) -> float:
    """Return twice the signed area of a triangle; positive if `c` is to the left of the line from `a` to `b`."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
