"""MODE 1, acquisition: the palm and two fingers of the concept arm about the bar of a payload.

The effector's hexahedra are numbered in the axes (-Z2, Y2, X2) of the hand, so that face d of the palm (HEX 1) looks to
the bar, b of the fixed finger (HEX 2) and e of the prong (HEX 3) look inwards. The bar (RECPT) has its length along its
own x axis, front end face a, and face c on top. Source: the final report of the Remote Manipulator Simulation,
acquisition conditions 1 to 6 (restored).

The law takes many placed bodies and says which of them are meant; what it finds is a packed array. Beside the six
conditions it finds how far the hand may still turn about the centre of face d before one of the first three fails; such
a turn changes none of the others. With a long bar the pitch is by far the tightest.
"""

from __future__ import annotations

from math import atan, inf, sqrt
from typing import Literal, NamedTuple

import msgspec
import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.bodies.hexahedron import CORNERS, NX, NY, NZ, VERTICES, D, X, Y, Z
from aftdeck.bodies.planes import least, lesser
from aftdeck.law import law
from aftdeck.worksite.conditions import Condition, Units, within

PALM, FIXED, PRONG = 0, 1, 2
"""Least height of the bar's vertices over face d of the palm, b of the fixed finger, e of the prong [m]."""
SPACING = 3
"""From the middle of the prong's face e to the fixed finger's face b [m]."""
HEIGHT = 4
"""Of the centre of face d over the bar's face c [m]."""
ALONG = 5
"""Of the centre of face d from the middle of the bar, along the bar's axis, positive to its rear end [m]."""
HALF = 6
"""Half the bar's length [m]."""
AWAY = 7
"""From the centre of face d to that of the bar's face c [m]."""
SIDE = 8
"""Z2 times the bar's axis, UZ2·XR of the report: negative where the prong stands at the bar's face b [1]."""
PITCH, ROLL, YAW = 9, 10, 11
"""How far the hand may turn about Y2, Z2 and X2 through the centre of face d; negative: has to, to be right [rad]."""
FOUND = 12
"""Length of what is found."""

SPACING_MOST, WINDOW, FRONT, REAR, FINGERS_WITHIN = 0, 1, 2, 3, 4
"""Where the fields of `Tolerances` stand in its packed form [m]."""

_A, _B, _C, _D, _E, _F = range(6)


class Tolerances(msgspec.Struct, frozen=True):
    """What acquisition allows."""

    spacing: float
    """PRGSPC: greatest spacing of the fingers' inner faces [m]; the report's value is lost."""
    window: float
    """TOPB: greatest height of the palm over the bar [m]; the report has 1/16 ft [S]."""
    front: float
    """FRONT: how far inside the bar's front end the palm's centre has to be [m]; the report has 0.5 ft [S]."""
    rear: float
    """REAR: the same at its rear end [m]; 0.5 ft [S]."""
    fingers_within: float
    """Between palm and bar; beyond it the fingers are not tested and hold nothing [m]; the report has 8 ft [S]."""

    def packed(self) -> Array:
        """(5,) as the law takes it."""
        return np.array([self.spacing, self.window, self.front, self.rear, self.fingers_within])


class Grasp(NamedTuple):
    """How a hand stands about a bar.

    Attributes:
        prong_at: the bar's face that the prong touches.
        pitch: how far the hand may turn about Y2 before it is no more about the bar; negative: has to, to be [rad].
        roll: the same about Z2, which is along the bar [rad].
        yaw: the same about X2, out of the palm [rad].
    """

    prong_at: Literal["b", "e"]
    pitch: float
    roll: float
    yaw: float


class _Vector(NamedTuple):
    x: float
    y: float
    z: float


@law
def _middle(body: Array, f: int) -> _Vector:
    """The mean of a face's four vertices."""
    p, q, r, s = CORNERS[f, 0], CORNERS[f, 1], CORNERS[f, 2], CORNERS[f, 3]
    return _Vector(
        0.25 * (body[X + p] + body[X + q] + body[X + r] + body[X + s]),
        0.25 * (body[Y + p] + body[Y + q] + body[Y + r] + body[Y + s]),
        0.25 * (body[Z + p] + body[Z + q] + body[Z + r] + body[Z + s]),
    )


@law
def _normal(body: Array, f: int) -> _Vector:
    """A face's outward unit normal."""
    return _Vector(body[NX + f], body[NY + f], body[NZ + f])


@law
def _cross(p: _Vector, q: _Vector) -> _Vector:
    return _Vector(p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x)


@law
def _dot(p: _Vector, q: _Vector) -> float:
    return p.x * q.x + p.y * q.y + p.z * q.z


@law
def _over(body: Array, f: int, p: _Vector) -> float:
    """Height of a point over a face's plane."""
    return _dot(_normal(body, f), p) - float(body[D + f])


@law
def _turn(bar: Array, body: Array, f: int, centre: _Vector, axis: _Vector) -> float:
    """The tangent of half the turn about an axis that brings the first vertex of the bar into a face's plane.

    A vertex of height h over the plane, h = B sin t + A cos t - d after a turn t of the plane, comes to it where
    (A + d) k² - 2 B k - h = 0, k = tan(t / 2). Taken is the root of smaller size, with the sign of h, and the least of
    all vertices; infinite where no turn brings any there.
    """
    n = _normal(body, f)
    along = _dot(n, axis)
    swept = _cross(axis, n)
    away = body[D + f] - _dot(n, centre)
    best = np.inf
    for v in range(VERTICES):
        r = _Vector(bar[X + v] - centre.x, bar[Y + v] - centre.y, bar[Z + v] - centre.z)
        height = _dot(n, r) - away
        side = _dot(swept, r)
        total = height + 2.0 * (away - along * _dot(axis, r))
        square = side * side + total * height
        reached = abs(side) + sqrt(max(square, 0.0))
        if square >= 0.0 and reached > 0.0:
            best = lesser(best, height / reached)
        elif height < 0.0:
            best = -np.inf
    return best


@law
def acquire(bodies: Array, which: Indices, rules: Array, found: Array) -> bool:
    """Whether the bar is acquired: the six conditions of mode 1. Fills `found` (12,).

    Args:
        bodies: (n, 48) packed bodies, all placed in one frame.
        which: (4,) of them, the palm, the fixed finger, the prong and the bar.
        rules: (5,) packed tolerances.
        found: (12,) what is measured and what is left.
    """
    palm, fixed, prong, bar = bodies[which[0]], bodies[which[1]], bodies[which[2]], bodies[which[3]]
    x2, y2 = _normal(palm, _D), _normal(prong, _E)
    z2 = _cross(x2, y2)
    centre = _middle(palm, _D)
    front, rear, top = _middle(bar, _A), _middle(bar, _F), _middle(bar, _C)
    length = sqrt((rear.x - front.x) ** 2 + (rear.y - front.y) ** 2 + (rear.z - front.z) ** 2)
    per = 1.0 / length
    axis = _Vector((rear.x - front.x) * per, (rear.y - front.y) * per, (rear.z - front.z) * per)
    found[PALM] = least(bar, palm[NX + _D], palm[NY + _D], palm[NZ + _D]) - palm[D + _D]
    found[FIXED] = least(bar, fixed[NX + _B], fixed[NY + _B], fixed[NZ + _B]) - fixed[D + _B]
    found[PRONG] = least(bar, prong[NX + _E], prong[NY + _E], prong[NZ + _E]) - prong[D + _E]
    found[SPACING] = _over(fixed, _B, _middle(prong, _E))
    found[HEIGHT] = _over(bar, _C, centre)
    found[HALF] = 0.5 * length
    found[ALONG] = _dot(axis, centre) - 0.5 * (_dot(axis, front) + _dot(axis, rear))
    found[AWAY] = sqrt((centre.x - top.x) ** 2 + (centre.y - top.y) ** 2 + (centre.z - top.z) ** 2)
    found[SIDE] = _dot(z2, axis)
    roll = lesser(_turn(bar, palm, _D, centre, z2), _turn(bar, fixed, _B, centre, z2))
    yaw = lesser(_turn(bar, fixed, _B, centre, x2), _turn(bar, prong, _E, centre, x2))
    found[PITCH] = 2.0 * atan(_turn(bar, palm, _D, centre, y2))
    found[ROLL] = 2.0 * atan(lesser(roll, _turn(bar, prong, _E, centre, z2)))
    found[YAW] = 2.0 * atan(yaw)
    return bool(
        found[AWAY] <= rules[FINGERS_WITHIN]
        and found[PALM] >= 0.0
        and found[FIXED] >= 0.0
        and found[PRONG] >= 0.0
        and found[SPACING] <= rules[SPACING_MOST]
        and 0.0 <= found[HEIGHT] <= rules[WINDOW]
        and rules[FRONT] - found[HALF] <= found[ALONG] <= found[HALF] - rules[REAR]
    )


def grasp(found: Array) -> Grasp:
    """Which way round the hand stands, and how far it may turn: what the law found, by name."""
    return Grasp("b" if found[SIDE] < 0.0 else "e", float(found[PITCH]), float(found[ROLL]), float(found[YAW]))


def acquisition(found: Array, tolerances: Tolerances, units: Units) -> tuple[Condition, ...]:
    """The six conditions, in the report's order, from what the law found (12,)."""
    value = found.tolist()
    half = value[HALF]
    return (
        within("palm over bar", value[PALM], 0.0, inf, "m", units, _PALM_SAYS),
        _beside("fixed finger", value[FIXED], value[AWAY], tolerances, units, _FIXED_SAYS, _FIXED_FAR),
        _beside("prong", value[PRONG], value[AWAY], tolerances, units, _PRONG_SAYS, _PRONG_FAR),
        within("prong closed", value[SPACING], -inf, tolerances.spacing, "m", units, _SPACING_SAYS),
        within("palm height", value[HEIGHT], 0.0, tolerances.window, "m", units, _HEIGHT_SAYS),
        within(
            "palm along bar",
            value[ALONG],
            tolerances.front - half,
            half - tolerances.rear,
            "m",
            units,
            _ALONG_SAYS,
        ),
    )


_PALM_SAYS = ("bar {} clear of the palm", "a corner of the bar {} past the palm's face")
_FIXED_SAYS = ("bar {} clear of the fixed finger", "bar {} past the fixed finger's face")
_PRONG_SAYS = ("bar {} clear of the prong", "bar {} past the prong's face")
_FIXED_FAR = ("fixed finger not tested with the palm {} from the bar", "")
_PRONG_FAR = ("prong not tested with the palm {} from the bar", "")
_SPACING_SAYS = ("fingers {} apart", "fingers crossed by {}")
_HEIGHT_SAYS = ("palm {} above the bar", "palm {} below the bar's top")
_ALONG_SAYS = ("palm {} from the bar's middle to its rear", "palm {} from the bar's middle to its front")


def _beside(
    finger: str,
    height: float,
    away: float,
    tolerances: Tolerances,
    units: Units,
    says: tuple[str, str],
    far: tuple[str, str],
) -> Condition:
    """Condition 2 or 3: all of the bar inside a finger; far from the bar, that it is too far to be tested."""
    name = f"{finger} beside bar"
    if away > tolerances.fingers_within:
        return within(name, away, -inf, tolerances.fingers_within, "m", units, far)
    return within(name, height, 0.0, inf, "m", units, says)
