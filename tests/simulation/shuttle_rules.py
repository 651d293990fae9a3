"""Rules of the Shuttle's worksite, computed independently from a frame: capture envelope and latching."""

from __future__ import annotations

import functools
import math

import numpy as np

import aftdeck
from aftdeck import Inputs
from aftdeck.arrays import Array
from aftdeck.simulation.frame import Frame

INCH = 0.0254
FIXTURE = np.array([-1.0, 0.0, 2.26])
"""Position of the payload's grapple fixture, in the payload's axes [m]."""
FIXTURE_AXES = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]])
"""Axes of the fixture, rotated by 90 deg of pitch: its axis 1 points into the payload."""
RADIAL, DEPTH, ANGLE = 4.0 * INCH, 4.0 * INCH, math.radians(10.0)
"""Capture envelope [m], [m], [rad]."""
TRUNNIONS = INCH * np.array([
    *([x, y, 14.05] for x in (-82.595, 82.595) for y in (-93.925, 93.925)),
    [0.0, 0.0, -94.975],
])  # fmt: skip
KEEL = 4
SEATED, STOWED = 0.05, math.radians(1.0)
"""Greatest distance of a trunnion from its seat [m], and greatest rotation of the payload [rad]."""
HEIGHT, HALF_ANGLE, THROAT, PLAY = 0.51, math.radians(17.0), 0.044, 0.025
"""Dimensions of a V-guide [m], [rad], [m], [m]."""
GIVES = 0.002
"""Depth below its seat at which a trunnion is still at its seat [m]: guides give under a load."""


@functools.cache
def stowed() -> tuple[Array, Array]:
    """Return the payload's position in the bay [m] and its axes, in L, at the start of a run."""
    (payload,) = aftdeck.Simulation("srms-deploy").step(Inputs()).work.cargo
    return np.array(payload.position), np.array(payload.orientation)


def envelope(frame: Frame, roll: float) -> Array:
    """Return the (6,) margins of the conditions of capture [m], [rad]."""
    (payload,) = frame.work.cargo
    s, c = math.sin(roll), math.cos(roll)
    effector = np.array(frame.orientation) @ [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]]
    axes = np.array(payload.orientation)
    out, y, z = effector.T @ (np.array(payload.position) + axes @ FIXTURE - frame.position)
    turn = effector.T @ axes @ FIXTURE_AXES
    pitch = math.asin(-turn[2, 0])
    yaw, turned = math.atan2(turn[1, 0], turn[0, 0]), math.atan2(turn[2, 1], turn[2, 2])
    return np.array([
        RADIAL - math.hypot(y, z), out, DEPTH - out, ANGLE - abs(pitch), ANGLE - abs(yaw), ANGLE - abs(turned),
    ])  # fmt: skip


def latching(frame: Frame) -> Array:
    """Return the margins of the conditions of latching [m], [rad]: seats, guides, attitude."""
    (payload,) = frame.work.cargo
    place, scene = stowed()
    turn = scene.T @ payload.orientation
    off = (TRUNNIONS @ turn.T + scene.T @ (payload.position - place)) - TRUNNIONS
    margins = [SEATED - np.linalg.norm(offset) for offset in off]
    for k, (x, y, z) in enumerate(off):
        along, across = (y, x) if k == KEEL else (x, y)
        room = THROAT + max(z, 0.0) * math.tan(HALF_ANGLE)
        margins += [z + GIVES, HEIGHT - z, room - abs(along), PLAY - abs(across)]
    angle = math.acos(min(1.0, max(-1.0, (np.trace(turn) - 1.0) / 2.0)))
    return np.array([*margins, STOWED - angle])
