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
_SAME = 7
"""Number of decimals up to which corners of neighbouring polygons are equal [of a metre]."""


def area(polygon: Sequence[Vec2]) -> float:
    """Return the area of a polygon [m^2]; negative if it is clockwise."""
    return 0.5 * sum(ax * by - ay * bx for (ax, ay), (bx, by) in _edges(polygon))


def hull(points: Iterable[Vec2]) -> Flat:
    """Return the convex hull of points (Andrew, 1979); empty if it has no area."""
    ordered = sorted(set(points))
    halves: list[Flat] = []
    for way in (ordered, ordered[::-1]):
        half: Flat = []
        for point in way:
            while len(half) > 1 and _turn(half[-2], half[-1], point) <= 0.0:
                half.pop()
            half.append(point)
        halves.append(half[:-1])
    found = halves[0] + halves[1]
    return found if len(found) >= FEWEST_CORNERS and area(found) > _LEAST else []


def is_convex(polygon: Sequence[Vec2]) -> bool:
    """Return whether a polygon turns to the left, or nowhere, at each corner."""
    count = len(polygon)
    return all(_turn(polygon[i - 2], polygon[i - 1], polygon[i]) >= -_LEAST for i in range(count))


def common(polygon: Flat, others: Flat) -> Flat:
    """Return the part of a polygon inside another one; empty if it has no area."""
    left = polygon
    for a, b in _edges(others):
        kept: Flat = []
        for p, q in _edges(left):
            from_p, from_q = _turn(a, b, p), _turn(a, b, q)
            if from_p >= 0.0:
                kept.append(p)
            if from_p * from_q < 0.0:
                part = from_p / (from_p - from_q)
                kept.append((p[0] + part * (q[0] - p[0]), p[1] + part * (q[1] - p[1])))
        left = kept
    left = [p for p, q in _edges(left) if abs(p[0] - q[0]) + abs(p[1] - q[1]) > _SHORT]
    return left if len(left) >= FEWEST_CORNERS and area(left) > _LEAST else []


def covers(polygon: Flat, other: Flat) -> bool:
    """Return whether a polygon contains another one."""
    return all(_turn(a, b, p) >= -_LEAST for a, b in _edges(polygon) for p in other)


def merged(polygons: Iterable[Flat]) -> list[Flat]:
    """Return polygons that fill the same area: two that share an edge become one if their union is convex."""
    left: list[Flat] = [[(round(x, _SAME), round(y, _SAME)) for x, y in polygon] for polygon in polygons]
    found: list[Flat] = []
    while left:
        polygon = left.pop()
        if area(polygon) <= _LEAST:
            continue
        at = {edge: k for k, other in enumerate(left) for edge in _edges(other)}
        for a, b in _edges(polygon):
            k = at.get((b, a))
            if k is None:
                continue
            # round the first polygon from b to a, then round the other one from a to b
            first, second = polygon.index(b), left[k].index(a)
            both = polygon[first:] + polygon[:first] + (left[k][second:] + left[k][:second])[1:-1]
            if area(hull(both)) <= area(polygon) + area(left[k]) + _LEAST:
                left[k] = both
                break
        else:
            found.append(hull(polygon))
    return [polygon for polygon in found if polygon]


def _edges(polygon: Sequence[Vec2]) -> list[tuple[Vec2, Vec2]]:
    return list(zip(polygon, [*polygon[1:], *polygon[:1]], strict=True))


def _turn(a: Vec2, b: Vec2, c: Vec2) -> float:
    """Return twice the signed area of a triangle; positive if `c` is to the left of the line from `a` to `b`."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
