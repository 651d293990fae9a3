"""Making of marks: which part of which face each drawn shape covers.

Of the faces of its frame, a shape belongs to those over which it is lowest. Seen along their normals, higher shapes
cover lower ones.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Literal, NamedTuple

import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.matrices import cross
from aftdeck.scene.colours import material_of
from aftdeck.scene.mesh import Mesh
from aftdeck.scene.polygon import signed_area
from aftdeck.shapes import Box, Cylinder, Hexahedron, Light, Loft, Material, Plate, Sphere, Vec2
from aftdeck.visual.drawn import Drawn
from aftdeck.visual.flat import Flat, common, covers, hull, is_convex, merged
from aftdeck.visual.marks import MOST_MARK_CORNERS, Marks
from aftdeck.visual.store import Polyhedron

DEEP = 0.03
"""Depth under a face down to which a shape counts as visible on the face [m]: a collision solid may stand out of
what it encloses by this (assumed)."""
REACH = 0.35
"""Greatest height over a face at which a shape is drawn on the face [m]: a grapple fixture's pin ends at 0.28 m."""
_EQUAL = 0.02
"""Difference of two heights up to which a shape is drawn on both faces [m]: a handrail over two clusters."""
OVER = 1e-4
"""Distance over a face at which another cluster hides it [m]."""
_ROUNDING = 1e-6
"""Distance by which a point inside a cluster may be outside because of rounding [m]."""
_FACING = 1e-6
"""Least cosine between a face's normal and that of a triangle that is seen along it."""

Outcome = Literal["mark", "hull", "inside", "like its face", "covered", "no face"]
"""What became of a drawn shape. ``hull``: a loft is the hull that solids enclose. ``inside``: it is deeper than DEEP in
a cluster. ``like its face``: it has the material of the faces on which it lies. ``covered``: marks or clusters cover
it. ``no face``: its frame has no cluster, or no face is within REACH below it."""


class Painted(NamedTuple):
    """Marks of a scenario's clusters, and what became of each drawn shape.

    Attributes:
        marks: the marks.
        materials: (M,) material of each mark.
        shapes: (M,) drawn shape of each mark.
        outcomes: what became of each drawn shape.
    """

    marks: Marks
    materials: tuple[Material, ...]
    shapes: tuple[int, ...]
    outcomes: tuple[Outcome, ...]


class _Bodies:
    """Clusters of one frame, for the question whether one of them contains points."""

    def __init__(self, bodies: Sequence[Polyhedron]) -> None:
        self._planes = [body.planes for body in bodies]
        self._low = np.array([body.points.min(axis=0) for body in bodies]) - _ROUNDING
        self._high = np.array([body.points.max(axis=0) for body in bodies]) + _ROUNDING

    def contain(self, points: Array, depth: float) -> bool:
        """Return whether each point is deeper than `depth` in one of the bodies."""
        left = points
        for k in self._near(points):
            left = left[self._heights(k, left) > _ROUNDING - depth]
            if not len(left):
                return True
        return False

    def one_contains(self, points: Array, but: int) -> bool:
        """Return whether one of the bodies, other than body `but`, contains all points."""
        return any(k != but and bool((self._heights(k, points) <= _ROUNDING).all()) for k in self._near(points))

    def _near(self, points: Array) -> list[int]:
        low, high = points.min(axis=0), points.max(axis=0)
        near: list[int] = np.flatnonzero((self._low < high).all(axis=1) & (self._high > low).all(axis=1)).tolist()
        return near

    def _heights(self, k: int, points: Array) -> Array:
        """Return the height (n,) of each point over the nearest plane of a body; negative inside it."""
        return np.asarray((points @ self._planes[k][:, :3].T - self._planes[k][:, 3]).max(axis=1))


class _Face(NamedTuple):
    """Face of a cluster.

    Attributes:
        number: number of the face.
        material: its own material.
        plane: (4,) its plane.
        axes: (2, 3) two axes in it.
        polygon: its polygon along these axes.
        bounds: (2, 2) least and greatest coordinates of the polygon.
        among: clusters of its frame, and the number of its own among them.
    """

    number: int
    material: Material
    plane: Array
    axes: Array
    polygon: Flat
    bounds: Array
    among: tuple[_Bodies, int]


class _Layer(NamedTuple):
    """A shape over a face: its number, the shape, and the height of each of its vertices over the face [m]."""

    number: int
    drawn: Drawn
    heights: Array


def painted(bodies: Sequence[tuple[str, Polyhedron]], materials: Sequence[Material], drawn: Sequence[Drawn]) -> Painted:
    """Return the marks of clusters.

    Args:
        bodies: frame and surface of each cluster.
        materials: own material of each of their faces.
        drawn: the drawn shapes.
    """
    faces: dict[str, list[_Face]] = {}
    groups: dict[str, list[Polyhedron]] = {}
    for frame, body in bodies:
        groups.setdefault(frame, []).append(body)
    frames = {frame: _Bodies(own) for frame, own in groups.items()}
    number = 0
    counts = dict.fromkeys(frames, 0)
    for frame, body in bodies:
        k, counts[frame] = counts[frame], counts[frame] + 1
        for plane, loop in zip(body.planes, body.loops, strict=True):
            points = body.points[list(loop)]
            if not frames[frame].one_contains(points + OVER * plane[:3], k):
                faces.setdefault(frame, []).append(_face(number, materials[number], plane, points, (frames[frame], k)))
            number += 1
    layers: dict[int, list[_Layer]] = {}
    outcomes: list[Outcome] = []
    for k, one in enumerate(drawn):
        outcome: Outcome = "hull" if isinstance(one.shape, Loft) else "no face"
        if outcome == "no face" and one.frame in frames and frames[one.frame].contain(_samples(one.surface), DEEP):
            outcome = "inside"
        if outcome == "no face":
            for face, layer in _nearest(k, one, faces.get(one.frame, ())):
                layers.setdefault(face.number, []).append(layer)
                outcome = "covered"
        outcomes.append(outcome)
    kept = {face.number: face for own in faces.values() for face in own}
    return _collected([kept.get(n) for n in range(number)], layers, outcomes)


def _face(number: int, material: Material, plane: Array, points: Array, among: tuple[_Bodies, int]) -> _Face:
    normal = plane[:3]
    along = np.eye(3)[int(np.abs(normal).argmin())]
    first = cross(normal, along)
    first /= np.sqrt(first @ first)
    axes = np.array([first, cross(normal, first)])
    polygon = hull(_flat(points, axes))
    corners = np.array(polygon)
    return _Face(number, material, plane, axes, polygon, np.array([corners.min(axis=0), corners.max(axis=0)]), among)


def _flat(points: Array, axes: Array) -> list[Vec2]:
    return [(x, y) for x, y in (points @ axes.T).tolist()]


def _samples(surface: Mesh) -> Array:
    """Return the vertices of a surface, the middles of its edges, and those of its triangles, (n, 3) [m]."""
    corners = surface.vertices[surface.faces]
    middles = 0.5 * (corners + corners[:, [1, 2, 0]])
    return np.concatenate([corners.reshape(-1, 3), middles.reshape(-1, 3), corners.mean(axis=1)])


def _nearest(k: int, one: Drawn, faces: Sequence[_Face]) -> Iterator[tuple[_Face, _Layer]]:
    """Yield the faces over which a shape is lowest."""
    if not faces:
        return
    points = one.surface.vertices
    heights = points @ np.array([face.plane[:3] for face in faces]).T - [face.plane[3] for face in faces]
    near = np.flatnonzero((heights.max(axis=0) > -DEEP) & (heights.min(axis=0) < REACH))
    found: list[tuple[float, _Face, _Layer]] = []
    for n in near[_over(points, [faces[n] for n in near.tolist()])].tolist():
        face, height = faces[n], heights[:, n]
        if common(hull(_flat(points[height >= -DEEP], face.axes)) or hull(_flat(points, face.axes)), face.polygon):
            found.append((max(float(height.min()), 0.0), face, _Layer(k, one, height)))
    least = min((height for height, _, _ in found), default=0.0)
    for height, face, layer in found:
        if height <= least + _EQUAL:
            yield face, layer


def _over(points: Array, faces: Sequence[_Face]) -> Indices:
    """Return the indices of faces whose bounds overlap those of points (n, 3), both seen along the face's normal."""
    if not faces:
        return np.zeros(0, dtype=np.int64)
    axes, bounds = np.array([face.axes for face in faces]), np.array([face.bounds for face in faces])
    flat = (axes.reshape(-1, 3) @ points.T).reshape(len(faces), 2, -1)
    overlap = (flat.min(axis=2) < bounds[:, 1]) & (flat.max(axis=2) > bounds[:, 0])
    return np.flatnonzero(overlap.all(axis=1))


def _outlines(one: Drawn, face: _Face, heights: Array) -> list[Flat]:
    """Return convex polygons that cover what is seen of a shape along the normal of a face, above the depth DEEP."""
    points, faces = one.surface.vertices, one.surface.faces
    if _is_convex(one):
        edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
        cut = _cut(points, heights, edges)
        return [outline] if (outline := hull(_flat(np.concatenate([points[heights >= -DEEP], cut]), face.axes))) else []
    a, b, c = (points[faces[:, i]] for i in range(3))
    normals = cross(b - a, c - a)
    facing = normals @ face.plane[:3] > _FACING * np.sqrt((normals**2).sum(axis=1))
    flat, lowest = _flat(points, face.axes), heights[faces].min(axis=1)
    seen = [[flat[i] for i in triangle] for triangle in faces[facing & (lowest >= -DEEP)].tolist()]
    for triangle in faces[facing & (lowest < -DEEP) & (heights[faces].max(axis=1) > -DEEP)]:
        sides = np.column_stack([triangle, triangle[[1, 2, 0]]])
        above = points[triangle[heights[triangle] >= -DEEP]]
        seen.append(hull(_flat(np.concatenate([above, _cut(points, heights, sides)]), face.axes)))
    return merged(polygon for polygon in seen if polygon)


def _cut(points: Array, heights: Array, edges: Indices) -> Array:
    """Return the points (n, 3) at which edges (e, 2) cross the depth DEEP."""
    ends = heights[edges] + DEEP
    crossing = ends[:, 0] * ends[:, 1] < 0.0
    (p, q), ends = (points[edges[crossing, i]] for i in range(2)), ends[crossing]
    return np.asarray(p + (ends[:, :1] / (ends[:, :1] - ends[:, 1:])) * (q - p))


def _is_convex(one: Drawn) -> bool:
    match one.shape:
        case Box() | Cylinder() | Hexahedron() | Light() | Sphere():
            return True
        case Plate(outline=outline):
            return is_convex(outline if signed_area(outline) > 0.0 else outline[::-1])
    return False


def _collected(faces: Sequence[_Face | None], layers: dict[int, list[_Layer]], outcomes: list[Outcome]) -> Painted:
    """Return the marks of all faces, lowest first; what is like its face or covered is left out."""
    points: list[Array] = []
    first: list[int] = [0]
    materials: list[Material] = []
    shapes: list[int] = []
    for number, face in enumerate(faces):
        if face is None:
            first.append(len(materials))
            continue
        for layer, polygon in _seen_on(face, layers.get(number, ()), outcomes):
            outcomes[layer.number] = "mark"
            points.append(_on(face, polygon, 0.0))
            materials.append(material_of(layer.drawn.shape))
            shapes.append(layer.number)
        first.append(len(materials))
    if points and max(map(len, points)) > MOST_MARK_CORNERS:
        raise AssertionError("a mark has too many corners")
    begins = np.cumsum([0, *map(len, points)], dtype=np.int64)
    marks = Marks(np.concatenate([np.empty((0, 3)), *points]), begins, np.array(first, np.int64))
    return Painted(marks, tuple(materials), tuple(shapes), tuple(outcomes))


def _seen_on(face: _Face, layers: Iterable[_Layer], outcomes: list[Outcome]) -> list[tuple[_Layer, Flat]]:
    """Return the polygons to paint on a face, lowest first; note which shapes are like their face."""
    found: list[tuple[_Layer, Flat]] = []
    bodies, own = face.among
    for layer in sorted(layers, key=lambda layer: float(layer.heights.max())):
        like = material_of(layer.drawn.shape) == face.material
        if like and outcomes[layer.number] == "covered":
            outcomes[layer.number] = "like its face"
        if like and not found:
            continue
        for outline in _outlines(layer.drawn, face, layer.heights):
            polygon = common(outline, face.polygon)
            if not polygon or bodies.one_contains(_on(face, polygon, OVER), own):
                continue
            if like and not any(common(polygon, other) for _, other in found):
                continue
            found.append((layer, polygon))
    return [
        (layer, polygon)
        for n, (layer, polygon) in enumerate(found)
        if not any(covers(other, polygon) for _, other in found[n + 1 :])
    ]


def _on(face: _Face, polygon: Flat, height: float) -> Array:
    """Return the corners (n, 3) of a polygon at a height over its face."""
    return np.asarray(np.array(polygon) @ face.axes + (face.plane[3] + height) * face.plane[:3])
