"""Random arms, payloads and poses for the tests of dynamics."""

from __future__ import annotations

import numpy as np

from aftdeck.analysis.dynamics import Dynamics, dynamics
from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import MassProperties, box

KINDS = [("srms", False), ("srms", True), ("concept-1972", False)]
"""Arms, and whether they are flexible."""


def random_payload(rng: np.random.Generator) -> MassProperties:
    """Return an oblique box of 50 kg to 30 t, whose centre is off the tip."""
    axes = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    half = rng.uniform(0.5, 3.0, 3)
    one = box(float(np.exp(rng.uniform(np.log(50.0), np.log(30e3)))), -half, half)
    return MassProperties(one.mass, rng.uniform(-1.0, 3.0, 3), axes @ one.inertia @ axes.T)


def random_angles(found: Dynamics, rng: np.random.Generator) -> Array:
    """Return joint angles within the hard stops [rad]."""
    low, high = found.arm.limits.hard.T
    angles: Array = rng.uniform(np.maximum(low, -np.pi), np.minimum(high, np.pi))
    return angles


def random_dynamics(rng: np.random.Generator, name: str, *, flexible: bool, free: bool | None = None) -> Dynamics:
    """Return an arm with or without a payload, on a fixed or free orbiter."""
    payload = random_payload(rng) if rng.random() < 0.7 else None
    moves = rng.random() < 0.5 if free is None else free
    return dynamics(name, payload=payload, orbiter="free" if moves else "fixed", flexible=flexible)
