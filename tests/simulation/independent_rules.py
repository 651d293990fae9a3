"""Rules of the concept worksite, computed independently in plain NumPy from a frame and the report's numbers."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.simulation.frame import Frame

FOOT = 0.3048
SCENE = np.diag([1.0, -1.0, -1.0])
"""Conversion between components in the scene (x aft, y starboard, z up) and in R (x aft, y port, z down)."""
BAR = np.array([[x, y, z] for x in (-1.5, 1.5) for y in (-0.25, 0.25) for z in (0.0, 0.75)])
"""RECPT [ft], relative to the middle of the payload's top."""
X, Z = np.eye(3)[[0, 2]]
FIXED_FINGER = 0.375
"""y2 of HEX 2's face b [ft]."""
PALM = 2.0
"""x2 of HEX 1's face d [ft]."""
SPACING, WINDOW, INWARD, TESTED = 0.8, 1.0 / 16.0, 0.5, 8.0
"""PRGSPC, TOPB, FRONT (equal to REAR), and the greatest distance at which the fingers are tested [ft]."""
CAE = np.array([-11.5, -16.0, 22.0])
"""Centre of the CAE in the scene [ft]."""
CAE_APOTHEM, CAE_HALF = 7.5, 7.5
DISTANCE, ANGLE = 0.25, math.radians(2.533333)
"""Tolerances of docking [ft], [rad]."""
BAY = np.array([[3.0, -7.5, -13.5], [63.0, 7.5, 0.0]])
"""Least and greatest coordinates of the inside of the bay, in the scene [ft]."""


class Size(NamedTuple):
    """Size of a payload's body [ft]."""

    length: float
    across: float

    @property
    def top(self) -> float:
        """Height of the upper side of the body above its axis."""
        return self.across / 2.0 * math.cos(math.pi / 6.0)


SIZES = {"payload": Size(30.0, 13.0), "free flyer": Size(24.0, 10.0)}


def pose(frame: Frame, k: int = 0) -> tuple[Array, Array]:
    """Return a payload's centre [ft] and axes in R."""
    cargo = frame.work.cargo[k]
    return np.array(cargo.position) / FOOT, np.array(cargo.orientation)


def hexagon(across: float, x: float) -> Array:
    """Return the (6, 3) corners of a hexagon normal to x, with a corner on the positive y axis [ft]."""
    turns = np.arange(6) * math.pi / 3.0
    return np.column_stack([np.full(6, x), across / 2.0 * np.cos(turns), across / 2.0 * np.sin(turns)])


def probe(size: Size) -> Array:
    """Return the (12, 3) vertices of a payload's probe in the payload's axes [ft]."""
    forward = -size.length / 2.0
    return np.concatenate([hexagon(1.0, forward), hexagon(1.0, forward - 1.0)])


def vertices(size: Size) -> Array:
    """Return all vertices of a payload in its axes: of body, probe and bar [ft]."""
    body = [hexagon(size.across, side * size.length / 2.0) for side in (-1.0, 1.0)]
    return np.concatenate([*body, probe(size), BAR + size.top * Z])


def acquisition(frame: Frame, k: int = 0) -> Array:
    """Return the (8,) margins of acquisition [ft].

    Each of the six conditions has one margin, except the fifth: it has two bounds, and therefore two margins. The last
    margin is for the distance at which the fingers are tested.
    """
    centre, axes = pose(frame, k)
    size = SIZES[frame.work.cargo[k].name]
    palm, system_2 = np.array(frame.position) / FOOT, np.array(frame.orientation)
    bar = centre + (BAR + size.top * Z) @ axes.T
    in_system_2 = (bar - palm) @ system_2  # relative to the palm's centre, in system 2
    spacing = frame.work.hand.spacing
    assert spacing is not None
    over = axes.T @ (palm - centre) - [0.0, 0.0, size.top + 0.75]
    return np.array([
        in_system_2[:, 0].min(),
        FIXED_FINGER - in_system_2[:, 1].max(),
        in_system_2[:, 1].min() - (FIXED_FINGER - spacing / FOOT),
        SPACING - spacing / FOOT,
        over[2],
        WINDOW - over[2],
        1.5 - INWARD - abs(over[0]),
        TESTED - math.hypot(*over),
    ])  # fmt: skip


def port(frame: Frame) -> tuple[Array, Array]:
    """Return the port's centre [ft] and the axes of a docked payload, in R; the port does not move with the orbiter."""
    away = np.array(frame.work.orbiter) / FOOT
    return SCENE @ (CAE + CAE_APOTHEM * X) - away, SCENE


def docking(frame: Frame, k: int = 0, axes: str = "xyz") -> Array:
    """Return the (n,) margins of docking: distances [ft], then angles [rad]."""
    centre, turned = pose(frame, k)
    size = SIZES[frame.work.cargo[k].name]
    at, own = port(frame)
    points = (centre + probe(size) @ turned.T - at) @ own  # in the port's axes
    tip = (centre + turned @ [-size.length / 2.0 - 1.0, 0.0, 0.0] - at) @ own
    sixty = math.radians(60.0)
    beside = [
        CAE_APOTHEM - ((points[:, 0] + CAE_APOTHEM) * math.cos(sixty) + side * points[:, 1] * math.sin(sixty)).max()
        for side in (-1.0, 1.0)
    ]
    compared = own.T @ turned
    angles = [
        math.atan2(math.hypot(*np.delete(compared[:, i], i)), compared[i, i]) for i in range(3) if "xyz"[i] in axes
    ]
    return np.array([
        points[:, 0].min(),
        *beside,
        CAE_HALF - np.abs(points[:, 2]).max(),
        DISTANCE - math.hypot(*tip),
        *(ANGLE - angle for angle in angles),
    ])  # fmt: skip


def depth_in_bay(frame: Frame, k: int = 0) -> float:
    """Return the depth of a payload's deepest vertex in the bay [ft]; negative if no vertex is in the bay."""
    centre, axes = pose(frame, k)
    points = (centre + vertices(SIZES[frame.work.cargo[k].name]) @ axes.T) @ SCENE
    inside = np.minimum(points[:, :2] - BAY[0, :2], BAY[1, :2] - points[:, :2]).min(axis=1)
    return float(np.minimum(BAY[1, 2] - points[:, 2], inside).max())
