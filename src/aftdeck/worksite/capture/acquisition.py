"""MODE 1, acquisition: the conditions under which the concept arm's palm and two fingers enclose the bar of a payload.

The effector's hexahedra are numbered in the axes (-Z2, Y2, X2) of the end effector. Face d of the palm (HEX 1)
therefore faces the bar; face b of the fixed finger (HEX 2) and face e of the prong (HEX 3) face inwards. The bar
(RECPT) has its length along its own x axis; its front end is face a, and its top is face c. Source: the final report of
the Remote Manipulator Simulation, acquisition conditions 1 to 6 (restored).

`acquire` takes an array of placed bodies and the indices of the four bodies that it needs, and writes its results into
a packed array. `still_turns` computes the angles by which the end effector may still turn about the centre of face d
before one of the first three conditions fails. Such a turn does not affect the other conditions. With a long bar, the
angle of pitch is much smaller than the other angles.
"""

from __future__ import annotations

from math import inf, sqrt
from typing import Literal, NamedTuple

import msgspec
import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.bodies.hexahedron import CORNERS, VERTICES, D, X, Y, Z, face_normal, vertex
from aftdeck.bodies.planes import least, lesser
from aftdeck.bodies.vector import Vector, cross, dot, minus, times
from aftdeck.elementary import atan2
from aftdeck.law import law
from aftdeck.worksite.conditions import Condition, within
from aftdeck.worksite.within import Within, number_that_hold

PALM, FIXED, PRONG = 0, 1, 2
"""Least height of the bar's vertices above face d of the palm, face b of the fixed finger and face e of the prong
[m]."""
SPACING = 3
"""Height of the middle of the prong's face e above the fixed finger's face b [m]."""
HEIGHT = 4
"""Height of the centre of face d above the bar's face c [m]."""
ALONG = 5
"""Offset of the centre of face d from the bar's middle, along the bar's axis, positive towards its rear end [m]."""
HALF = 6
"""Half the bar's length [m]."""
AWAY = 7
"""Distance from the centre of face d to the centre of the bar's face c [m]."""
SIDE = 8
"""Dot product of Z2 and the bar's axis (UZ2·XR in the report) [1]. It is negative if the prong is at the bar's face b,
and positive if it is at face e."""
MEASURED = 9
"""Length of the array of the values above."""
PITCH, ROLL, YAW = 9, 10, 11
"""Angles by which the end effector may turn about Y2, Z2 and X2 through the centre of face d [rad].

A negative angle means that at least one of the first three conditions fails. Its magnitude is the turn needed.
"""
FOUND = 12
"""Length of the array of all values."""

SPACING_MOST, WINDOW, FRONT, REAR, FINGERS_WITHIN = 0, 1, 2, 3, 4
"""Indices of the fields of `Tolerances` in its packed form; the fields are in [m]."""

_A, _B, _C, _D, _E, _F = range(6)


class Tolerances(msgspec.Struct, frozen=True):
    """Tolerances of acquisition."""

    spacing: float
    """PRGSPC: greatest spacing of the fingers' inner faces [m]; the report's value is lost."""
    window: float
    """TOPB: greatest height of the palm above the bar [m]; the report has 1/16 ft [S]."""
    front: float
    """FRONT: least distance of the palm's centre from the bar's front end, inwards along the bar [m]; report: 0.5 ft
    [S]."""
    rear: float
    """REAR: least distance of the palm's centre from the bar's rear end, inwards along the bar [m]; report: 0.5 ft
    [S]."""
    fingers_within: float
    """Distance between palm and bar beyond which the fingers are not tested and the bar is not acquired [m]; report:
    8 ft [S]."""

    def packed(self) -> Array:
        """Return the tolerances as an array (5,) for the law."""
        return np.array([self.spacing, self.window, self.front, self.rear, self.fingers_within])


class Grasp(NamedTuple):
    """Orientation of the end effector around a bar, and the angles by which it may still turn.

    Attributes:
        prong_at: the bar's face at which the prong is.
        pitch: angle by which the end effector may turn about Y2 and still enclose the bar [rad]; if negative, the angle
            by which it has to turn to enclose the bar.
        roll: angle by which the end effector may turn about Z2, which is along the bar [rad]; sign as for `pitch`.
        yaw: angle by which the end effector may turn about X2, which points out of the palm [rad]; sign as for `pitch`.
    """

    prong_at: Literal["b", "e"]
    pitch: float
    roll: float
    yaw: float


@law
def _middle(body: Array, f: int) -> Vector:
    """Return the mean of the four vertices of face f."""
    p, q, r, s = CORNERS[f, 0], CORNERS[f, 1], CORNERS[f, 2], CORNERS[f, 3]
    return Vector(
        0.25 * (body[X + p] + body[X + q] + body[X + r] + body[X + s]),
        0.25 * (body[Y + p] + body[Y + q] + body[Y + r] + body[Y + s]),
        0.25 * (body[Z + p] + body[Z + q] + body[Z + r] + body[Z + s]),
    )


@law
def _over(body: Array, f: int, p: Vector) -> float:
    """Return the height of point p above the plane of face f."""
    return dot(face_normal(body, f), p) - float(body[D + f])


@law
def _turn(bar: Array, body: Array, f: int, centre: Vector, axis: Vector) -> float:
    """Return tan(t / 2) for the least rotation t of face f that brings a vertex of the bar into the plane of the face.

    The rotation is about an axis through `centre`. After a rotation t of the plane, the height of a vertex above the
    plane is B sin t + A cos t - d. The vertex is in the plane if (A + d) k² - 2 B k - h = 0, with k = tan(t / 2) and h
    the height before the rotation. Of the two roots k, the one of smaller magnitude is used, with the sign of h. The
    result is the least such value over all vertices; it is infinite if no rotation brings a vertex into the plane.
    """
    n = face_normal(body, f)
    along = dot(n, axis)
    swept = cross(axis, n)
    away = body[D + f] - dot(n, centre)
    best = np.inf
    for v in range(VERTICES):
        r = minus(vertex(bar, v), centre)
        height = dot(n, r) - away
        side = dot(swept, r)
        total = height + 2.0 * (away - along * dot(axis, r))
        square = side * side + total * height
        reached = abs(side) + sqrt(max(square, 0.0))
        if square >= 0.0 and reached > 0.0:
            best = lesser(best, height / reached)
        elif height < 0.0:
            best = -np.inf
    return best


@law
def acquire(bodies: Array, which: Indices, rules: Array, found: Array) -> bool:
    """Return whether the bar is acquired by the six conditions of mode 1, and write the values up to SIDE to `found`.

    Args:
        bodies: (n, 48) packed bodies, all placed in one coordinate frame.
        which: (4,) indices in `bodies` of the palm, the fixed finger, the prong and the bar.
        rules: (5,) packed tolerances.
        found: (9,) or more, output: measured values.
    """
    palm, fixed, prong, bar = bodies[which[0]], bodies[which[1]], bodies[which[2]], bodies[which[3]]
    x2, y2 = face_normal(palm, _D), face_normal(prong, _E)
    z2 = cross(x2, y2)
    centre = _middle(palm, _D)
    front, rear, top = _middle(bar, _A), _middle(bar, _F), _middle(bar, _C)
    to_rear, from_top = minus(rear, front), minus(centre, top)
    length = sqrt(dot(to_rear, to_rear))
    axis = times(1.0 / length, to_rear)
    found[PALM] = least(bar, x2) - palm[D + _D]
    found[FIXED] = least(bar, face_normal(fixed, _B)) - fixed[D + _B]
    found[PRONG] = least(bar, y2) - prong[D + _E]
    found[SPACING] = _over(fixed, _B, _middle(prong, _E))
    found[HEIGHT] = _over(bar, _C, centre)
    found[HALF] = 0.5 * length
    found[ALONG] = dot(axis, centre) - 0.5 * (dot(axis, front) + dot(axis, rear))
    found[AWAY] = sqrt(dot(from_top, from_top))
    found[SIDE] = dot(z2, axis)
    values = acquisition_values(found, rules)
    return number_that_hold(values) == len(values)


@law
def acquisition_values(found: Array, rules: Array) -> tuple[Within, Within, Within, Within, Within, Within]:
    """Return the values of the six conditions with their ranges [m], from the values `found` of `acquire`.

    If the palm is too far from the bar to test the fingers, the second and the third are that distance.
    """
    half, away = found[HALF], (found[AWAY], -inf, rules[FINGERS_WITHIN])
    far = found[AWAY] > rules[FINGERS_WITHIN]
    return (
        (found[PALM], 0.0, inf),
        away if far else (found[FIXED], 0.0, inf),
        away if far else (found[PRONG], 0.0, inf),
        (found[SPACING], -inf, rules[SPACING_MOST]),
        (found[HEIGHT], 0.0, rules[WINDOW]),
        (found[ALONG], rules[FRONT] - half, half - rules[REAR]),
    )


@law
def still_turns(bodies: Array, which: Indices, found: Array) -> None:
    """Write PITCH, ROLL and YAW to `found` (12,): angles by which the end effector may still turn.

    The other arguments are those of `acquire`.
    """
    palm, fixed, prong, bar = bodies[which[0]], bodies[which[1]], bodies[which[2]], bodies[which[3]]
    x2, y2 = face_normal(palm, _D), face_normal(prong, _E)
    z2 = cross(x2, y2)
    centre = _middle(palm, _D)
    roll = lesser(_turn(bar, palm, _D, centre, z2), _turn(bar, fixed, _B, centre, z2))
    yaw = lesser(_turn(bar, fixed, _B, centre, x2), _turn(bar, prong, _E, centre, x2))
    found[PITCH] = 2.0 * atan2(_turn(bar, palm, _D, centre, y2), 1.0)
    found[ROLL] = 2.0 * atan2(lesser(roll, _turn(bar, prong, _E, centre, z2)), 1.0)
    found[YAW] = 2.0 * atan2(yaw, 1.0)


@law
def acquired_bar(bodies: Array, bars: Indices, rules: Array) -> int:
    """Return the first payload whose bar is acquired; -1 if there is none.

    Args:
        bodies: as for `acquire`.
        bars: (c, 4) for each payload, the indices `which` of `acquire`; negative for a payload without a bar.
        rules: as for `acquire`.
    """
    found = np.empty(MEASURED)
    for k in range(len(bars)):
        if bars[k, 0] >= 0 and acquire(bodies, bars[k], rules, found):
            return k
    return -1


@law
def enclosed_bar(bodies: Array, bars: Indices, rules: Array, near: float) -> int:
    """Return the first payload whose bar is in front of the palm and between the fingers; -1 if there is none.

    Bars at a distance of `near` [m] or more from the palm are ignored. The other arguments are those of `acquired_bar`.
    """
    found = np.empty(MEASURED)
    for k in range(len(bars)):
        if bars[k, 0] < 0:
            continue
        acquire(bodies, bars[k], rules, found)
        if found[AWAY] < near and found[PALM] >= 0.0 and found[FIXED] >= 0.0 and found[PRONG] >= 0.0:
            return k
    return -1


def grasp(found: Array) -> Grasp:
    """Return the orientation of the end effector, and the angles by which it may still turn, from `found` (12,)."""
    return Grasp("b" if found[SIDE] < 0.0 else "e", float(found[PITCH]), float(found[ROLL]), float(found[YAW]))


def acquisition(found: Array, rules: Array) -> tuple[Condition, ...]:
    """Return the six conditions, in the report's order, from the values `found` of `acquire`; `rules` as there."""
    far = found[AWAY] > rules[FINGERS_WITHIN]
    fixed, prong = (_FIXED_FAR, _PRONG_FAR) if far else (_FIXED_SAYS, _PRONG_SAYS)
    says = (_PALM_SAYS, fixed, prong, _SPACING_SAYS, _HEIGHT_SAYS, _ALONG_SAYS)
    return tuple(
        within(name, *given, "m", text)
        for name, given, text in zip(_NAMES, acquisition_values(found, rules), says, strict=True)
    )


_NAMES = (
    "palm over bar",
    "fixed finger beside bar",
    "prong beside bar",
    "prong closed",
    "palm height",
    "palm along bar",
)
_PALM_SAYS = ("bar {} clear of the palm", "a corner of the bar {} past the palm's face")
_FIXED_SAYS = ("bar {} clear of the fixed finger", "bar {} past the fixed finger's face")
_PRONG_SAYS = ("bar {} clear of the prong", "bar {} past the prong's face")
_FIXED_FAR = ("fixed finger not tested with the palm {} from the bar", "")
_PRONG_FAR = ("prong not tested with the palm {} from the bar", "")
_SPACING_SAYS = ("fingers {} apart", "fingers crossed by {}")
_HEIGHT_SAYS = ("palm {} above the bar", "palm {} below the bar's top")
_ALONG_SAYS = ("palm {} from the bar's middle to its rear", "palm {} from the bar's middle to its front")
