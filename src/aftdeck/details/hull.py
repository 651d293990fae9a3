"""The hull of a payload: the largest of its drawn shapes, and what its skin has to leave free.

Details are derived from the drawn shapes alone. A payload of any scenario therefore gets them, and what its file draws
on the hull (grapple fixture, target, trunnions, keel pin, bar, probe, marks) stays visible.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise
from math import pi, tau
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.elementary import atan2
from aftdeck.frames import Pose, endori
from aftdeck.matrices import product
from aftdeck.scene.mesh import moved
from aftdeck.scene.placed import Leaf, placed
from aftdeck.scene.solids import solid
from aftdeck.shapes import Box, Cylinder, Hexahedron, Shape, Turn
from aftdeck.tuples import Vec3

ROUND = 12
"""Number of strips into which the skin of a round hull is divided; one of them is on top (+z)."""
_COAXIAL = 0.5
"""A cylinder about the hull's axis belongs to the hull if its radius is at least this part of the hull's: it is a band,
or closes an end (assumed)."""
_SAME = 1e-6
"""Difference of lengths that counts as none [m]."""
_CENTRED = 1e-3
"""Greatest distance of two axes that count as one [m]: files round half a turn to 3.1416 rad."""
_TURNS: tuple[Turn, Turn, Turn] = ((0.0, 0.0, 0.0), (0.0, 0.0, pi / 2), (0.0, -pi / 2, 0.0))
"""Rotations that take the hull's own x axis to a payload's x, y and z axis."""


class Strip(NamedTuple):
    """A strip of the skin along the whole hull: a side of a prism, or a sector of a cylinder.

    Attributes:
        angle: direction of the outward normal in its middle, from y towards z [rad].
        half_width: half of its width, measured on the skin [m].
    """

    angle: float
    half_width: float


class Hull(NamedTuple):
    """A prism or cylinder along its own x axis, whose origin is its centre.

    Attributes:
        position: the centre in the payload's axes [m].
        rotation: rotation of the hull's own axes in the payload's.
        length: length of the skin [m].
        ends: x of the outermost faces across the axis: the skin's, or those of discs that close the ends [m].
        distance: distance of the skin from the axis: radius, or the least distance of a side [m].
        curved: whether the hull is a cylinder.
        strips: strips of the skin, counter-clockwise seen from +x.
        fixtures: (n, 2, 3) least and greatest corner of the box around everything else that is drawn [m].
    """

    position: Vec3
    rotation: Turn
    length: float
    ends: tuple[float, float]
    distance: float
    curved: bool
    strips: tuple[Strip, ...]
    fixtures: Array


class _Drawn(NamedTuple):
    leaf: Leaf
    pose: Pose
    box: Array
    """(2, 3) least and greatest corner in the payload's axes [m]."""
    vertices: Array


def hull_of(shapes: Iterable[Shape]) -> Hull | None:
    """Return the hull among a payload's shapes; None if the largest shape is neither a cylinder nor a prism."""
    leaves = [_drawn(leaf, pose) for leaf, pose in placed(shapes)]
    if not leaves:
        return None
    main = max(leaves, key=lambda each: float((each.box[1] - each.box[0]).prod()))
    match main.leaf:
        case Cylinder(axis=axis, radius=radius, radius_end=None) if _upright(main.pose):
            along = "xyz".index(axis)
            own = [each for each in leaves if _is_about(each, main, along, _COAXIAL * radius)]
            strips = tuple(Strip(pi / 2 + tau * k / ROUND, float(radius) * pi / ROUND) for k in range(ROUND))
            return _hull(leaves, main, own, along, float(radius), strips, curved=True)
        case Box() | Hexahedron():
            size = main.box[1] - main.box[0]
            along = int(size.argmax())
            own = [each for each in leaves if np.abs(each.box[:, along] - main.box[:, along]).max() < _SAME]
            return _prism(leaves, main, own, along)
        case _:
            return None


def _drawn(leaf: Leaf, pose: Pose) -> _Drawn:
    vertices = moved(solid(leaf), pose).vertices
    return _Drawn(leaf, pose, np.array([vertices.min(axis=0), vertices.max(axis=0)]), vertices)


def _upright(pose: Pose) -> bool:
    return bool(np.abs(pose.rotation - np.eye(3)).max() < _SAME)


def _is_about(each: _Drawn, main: _Drawn, along: int, least: float) -> bool:
    """Return whether a shape is a cylinder about the axis of `main`, with at least this radius [m]."""
    leaf, off = each.leaf, np.delete(each.pose.position - main.pose.position, along)
    if not isinstance(leaf, Cylinder) or "xyz".index(leaf.axis) != along:
        return False
    return leaf.radius >= least and bool(np.abs(off).max() < _CENTRED)


def _prism(leaves: list[_Drawn], main: _Drawn, own: list[_Drawn], along: int) -> Hull | None:
    """Return the hull whose cross-section is the convex polygon around the shapes `own`."""
    vertices = np.concatenate([each.vertices for each in own])
    middle = 0.5 * (vertices.min(axis=0) + vertices.max(axis=0))
    corners = _convex(product(vertices - middle, endori(*_TURNS[along]))[:, 1:])
    strips, distances = [], []
    for (y, z), (to_y, to_z) in pairwise([*corners, corners[0]]):
        width = float(np.hypot(to_y - y, to_z - z))
        strips.append(Strip(atan2(y - to_y, to_z - z), 0.5 * width))
        distances.append((y * to_z - z * to_y) / width)
    if max(distances) - min(distances) > _CENTRED:
        return None  # not a regular prism: its sides are not equally far from the axis
    placed_main = main._replace(pose=Pose(middle, main.pose.rotation))
    return _hull(leaves, placed_main, own, along, float(min(distances)), tuple(strips), curved=False)


def _hull(
    leaves: list[_Drawn],
    main: _Drawn,
    own: list[_Drawn],
    along: int,
    distance: float,
    strips: tuple[Strip, ...],
    *,
    curved: bool,
) -> Hull:
    middle, turn = main.pose.position, endori(*_TURNS[along])
    low, high = np.min([each.box[0] for each in own], axis=0), np.max([each.box[1] for each in own], axis=0)
    others = [product(each.vertices - middle, turn) for each in leaves if not any(each is one for one in own)]
    x, y, z = middle.tolist()
    return Hull(
        position=(x, y, z),
        rotation=_TURNS[along],
        length=float((main.box[1] - main.box[0])[along]),
        ends=(float((low - middle)[along]), float((high - middle)[along])),
        distance=distance,
        curved=curved,
        strips=strips,
        fixtures=np.array([(each.min(axis=0), each.max(axis=0)) for each in others]).reshape(-1, 2, 3),
    )


def _convex(points: Array) -> list[tuple[float, float]]:
    """Return the corners of the convex polygon around points (n, 2), counter-clockwise (Andrew's monotone chain)."""
    ordered = sorted(set(map(tuple, np.round(points, 9).tolist())))
    halves = []
    for run in (ordered, ordered[::-1]):
        half: list[tuple[float, float]] = []
        for p in run:
            while len(half) > 1 and _turn(half[-2], half[-1], p) <= _SAME:
                half.pop()
            half.append(p)
        halves.append(half[:-1])
    return [*halves[0], *halves[1]]


def _turn(a: tuple[float, float], b: tuple[float, float], c: tuple[float, float]) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
