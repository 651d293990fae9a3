"""Random and singular joint angles for tests, and conversion to the structural coordinates of the sources."""

from __future__ import annotations

import math

import numpy as np
from scipy.optimize import brentq

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
"""L's axes (aft, port, down) as columns, in structural components. L leans to port."""
ORIGIN = np.array(CENTRES["shoulder_yaw"]) * INCH
"""L's origin, structural [m]."""
BODY = np.diag([-1.0, 1.0, -1.0])
"""Conversion of structural components (aft, starboard, up) to the orbiter's axes (forward, starboard, down)."""
STRAIGHT = -(math.atan2(6.0, 251.05) + math.atan2(6.0, 277.95))
"""Elbow angle at which upper and lower arm are in line [rad]. The elbow is 6 inches off the boom line."""


def structural(position: Array) -> Array:
    """Return the structural coordinates [m] of positions (..., 3) in L."""
    return np.asarray(position @ AXES.T + ORIGIN)


def legal(arm: aftdeck.Arm, seed: int, count: int) -> Array:
    """Return random angles (count, 6) inside the hard limits; about one angle in ten is at or just inside a limit."""
    rng = np.random.default_rng(seed)
    low, high = arm.limits.hard[:, 0], arm.limits.hard[:, 1]
    q = rng.uniform(low, high, (count, 6))
    inward = np.minimum(rng.choice([0.0, 1e-9, 1e-4], (count, 6)), high - low)
    edge = np.where(rng.random((count, 6)) < 0.5, low + inward, high - inward)
    q = np.where(rng.random((count, 6)) < 0.1, edge, q)
    assert (q >= low).all() and (q <= high).all()
    return q


def over_the_shoulder(arm: aftdeck.Arm) -> Array:
    """Return legal angles at which the wrist yaw joint is on the shoulder yaw axis."""
    tip = 56 * 0.0254

    def off_axis(elbow: float) -> float:
        pose = arm.forward([0.0, 2.0, elbow, 0.3, 0.1, 0.2])
        return float(pose.position[0] - tip * pose.rotation[0, 0])

    return np.array([0.0, 2.0, brentq(off_axis, -2.5, -0.1, xtol=1e-15), 0.3, 0.1, 0.2])


def singular_poses(arm: aftdeck.Arm) -> dict[str, Array]:
    """Return joint angles exactly at each singularity and away from the other two."""
    return {
        "shoulder": over_the_shoulder(arm),
        "elbow": np.array([0.3, 1.0, STRAIGHT, 0.4, 0.2, 0.1]),
        "wrist": np.array([0.3, 1.0, -1.3, 0.4, math.pi / 2, 0.1]),
    }


def turned(a: Array, b: Array) -> Array:
    """Return the rotation vectors (..., 3) [rad] from matrices `b` (..., 3, 3) to matrices `a`; for small rotations."""
    r = a @ np.swapaxes(b, -1, -2)
    return 0.5 * np.stack([r[..., 2, 1] - r[..., 1, 2], r[..., 0, 2] - r[..., 2, 0], r[..., 1, 0] - r[..., 0, 1]], -1)


def apart(a: Array, b: Array) -> Array:
    """Return the differences of angles [rad], without full turns."""
    return np.asarray(np.remainder(a - b + math.pi, math.tau) - math.pi)
