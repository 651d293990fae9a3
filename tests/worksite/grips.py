"""Vertices of the concept arm's end effector and of a payload's bar, as in their files; heights over a face."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron_check import hexahedron
from aftdeck.frames import rotation_x, rotation_y, rotation_z
from aftdeck.units import FOOT
from aftdeck.worksite.capture.acquisition import FOUND, Tolerances, acquire, still_turns

TOLERANCES = Tolerances(
    spacing=0.8 * FOOT, window=FOOT / 16.0, front=0.5 * FOOT, rear=0.5 * FOOT, fingers_within=8.0 * FOOT
)
BAR = np.array([3.0, 0.5, 0.75]) * FOOT
"""Length, width and height of the bar [m]."""
OUT = 2.0
"""x2 of the palm's outer face [ft]."""
WHICH = np.arange(4)


def box(least: list[float], most: list[float]) -> Array:
    """Return the vertices (8, 3) [m] of a box between two corners [ft]."""
    ends = np.array([least, most]) * FOOT
    return np.array([(ends[x, 0], ends[y, 1], ends[z, 2]) for y in (0, 1) for x in (0, 1) for z in (0, 1)])


def end_effector(spacing: float = 0.75) -> list[Array]:
    """Return palm, fixed finger and prong (8, 3) [m] in axes (x, y, z) = (-Z2, Y2, X2), at a finger spacing [ft]."""
    inner = 0.375 - spacing
    return [
        box([-0.5, -1.75, 1.5], [0.5, 1.75, OUT]),
        box([-0.25, 0.375, 2.0], [0.25, 0.625, 2.6]),
        box([-0.25, inner - 0.25, 2.0], [0.25, inner, 2.6]),
    ]


def bar() -> Array:
    """Return the bar (8, 3) [m] with the centre of its top at the origin, z down."""
    return np.array([(x, y, z) for y in (-0.5, 0.5) for x in (-0.5, 0.5) for z in (0.0, 1.0)]) * BAR


def over(
    along: float = 0.0,
    across: float = 0.0,
    height: float = 0.03,
    pitch: float = 0.0,
    roll: float = 0.0,
    yaw: float = 0.0,
    spacing: float = 0.75,
    side: int = 1,
) -> list[Array]:
    """Return the three bodies of the end effector in the bar's frame.

    The offsets [ft] are from the centre of the bar's top to the palm's centre. Pitch is about the bar's y axis, roll
    about its length, yaw about the vertical, all through the palm's centre [rad]. With `side` -1, the end effector is
    rotated by 180 deg in yaw, so that its prong is on the other side of the bar.
    """
    turn = rotation_z(yaw) @ rotation_y(pitch) @ rotation_x(roll)
    if side < 0:
        turn = turn @ rotation_z(np.pi)
    centre = np.array([along, across, -height]) * FOOT
    return [(body - [0.0, 0.0, OUT * FOOT]) @ turn.T + centre for body in end_effector(spacing)]


def found_at(bodies: list[Array], tolerances: Tolerances = TOLERANCES) -> tuple[bool, Array]:
    """Return the results of `acquire` and `still_turns` for palm, fixed finger, prong and bar (8, 3) in one frame."""
    found = np.full(FOUND, np.nan)
    packed = np.array([hexahedron(body, "a body") for body in bodies])
    still_turns(packed, WHICH, found)
    return bool(acquire(packed, WHICH, tolerances.packed(), found)), found


def over_face(body: Array, rim: tuple[int, int, int, int], points: Array) -> Array:
    """Return the heights of points (n, 3) over a face's plane, positive outside; `rim` numbers the face's vertices."""
    p, q, r, _ = (body[v - 1] for v in rim)
    normal = np.cross(q - p, r - p)
    normal /= np.linalg.norm(normal)
    normal *= np.sign(normal @ (p - body.mean(axis=0)))
    return np.asarray((points - p) @ normal)
