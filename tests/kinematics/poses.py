"""Random joint angles for tests, and the structural coordinates in which sources give places."""

from __future__ import annotations

import math

import numpy as np

import aftdeck
from aftdeck.arrays import Array
from tests.reference.tables import table

INCH = 0.0254
CENTRES = table("srms-joint-centres")
_LEAN = math.radians(CENTRES["lean"])
AXES = np.array(
    [
        [1.0, 0.0, 0.0],
        [0.0, -math.cos(_LEAN), math.sin(_LEAN)],
        [0.0, -math.sin(_LEAN), -math.cos(_LEAN)],
    ]
)
"""L's axes as columns, in structural components: aft, port, down, leaning to port."""
ORIGIN = np.array(CENTRES["shoulder_yaw"]) * INCH
"""L's origin, structural [m]."""
BODY = np.diag([-1.0, 1.0, -1.0])
"""From structural components (aft, starboard, up) to the orbiter's body axes (forward, starboard, down)."""


def structural(position: Array) -> Array:
    """Structural coordinates [m] of places (..., 3) given in L."""
    return np.asarray(position @ AXES.T + ORIGIN)


def legal(arm: aftdeck.Arm, seed: int, count: int) -> Array:
    """(count, 6) angles inside the hard limits; a tenth of all angles stands at or just inside a limit."""
    rng = np.random.default_rng(seed)
    low, high = arm.limits.hard[:, 0], arm.limits.hard[:, 1]
    q = rng.uniform(low, high, (count, 6))
    inward = np.minimum(rng.choice([0.0, 1e-9, 1e-4], (count, 6)), high - low)
    edge = np.where(rng.random((count, 6)) < 0.5, low + inward, high - inward)
    q = np.where(rng.random((count, 6)) < 0.1, edge, q)
    assert (q >= low).all() and (q <= high).all()
    return q


def turned(a: Array, b: Array) -> Array:
    """(..., 3) rotation vector [rad] from b to a, rotation matrices (..., 3, 3), for small turns."""
    r = a @ np.swapaxes(b, -1, -2)
    return 0.5 * np.stack([r[..., 2, 1] - r[..., 1, 2], r[..., 0, 2] - r[..., 2, 0], r[..., 1, 0] - r[..., 0, 1]], -1)


def apart(a: Array, b: Array) -> Array:
    """Differences of angles [rad], whole turns left out."""
    return np.asarray(np.remainder(a - b + math.pi, math.tau) - math.pi)
