"""VOTRAN's rotation of stick commands: vectors in orbiter, frame 7 or payload components, expressed in L."""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.linkage import Tip
from aftdeck.law import law
from aftdeck.steering.layout import HELD, MOUNT

Vector = tuple[float, float, float]


@law
def turned(array: Array, start: int, x: float, y: float, z: float) -> Vector:
    """Return the vector rotated by the matrix whose nine elements begin at `start`."""
    return (
        array[start] * x + array[start + 1] * y + array[start + 2] * z,
        array[start + 3] * x + array[start + 4] * y + array[start + 5] * z,
        array[start + 6] * x + array[start + 7] * y + array[start + 8] * z,
    )


@law
def from_orbiter(rules: Array, x: float, y: float, z: float) -> Vector:
    """Return a vector given in orbiter components, expressed in L."""
    return turned(rules, MOUNT, x, y, z)


@law
def from_hand(t: Tip, x: float, y: float, z: float) -> Vector:
    """Return a vector given in frame 7, expressed in L."""
    return (
        t.r11 * x + t.r12 * y + t.r13 * z,
        t.r21 * x + t.r22 * y + t.r23 * z,
        t.r31 * x + t.r32 * y + t.r33 * z,
    )


@law
def from_payload(rules: Array, t: Tip, x: float, y: float, z: float) -> Vector:
    """Return a vector given in payload axes, expressed in L (T_B8 = T_B7 T_78)."""
    a, b, c = turned(rules, HELD, x, y, z)
    return from_hand(t, a, b, c)
