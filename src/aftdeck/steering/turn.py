"""VOTRAN's conversion of stick commands to L, from the orbiter's frame, frame 7 or the payload's axes."""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.linkage import Floats, Tip
from aftdeck.law import law
from aftdeck.steering.layout import HELD, MOUNT

Vector = tuple[float, float, float]


@law
def turned(array: Floats, start: int, x: float, y: float, z: float) -> Vector:
    """Return the vector (x, y, z) multiplied by the matrix whose nine elements begin at index `start` of the array."""
    return (
        array[start] * x + array[start + 1] * y + array[start + 2] * z,
        array[start + 3] * x + array[start + 4] * y + array[start + 5] * z,
        array[start + 6] * x + array[start + 7] * y + array[start + 8] * z,
    )


@law
def from_orbiter(rules: Floats, x: float, y: float, z: float) -> Vector:
    """Convert a vector from the orbiter's frame to L."""
    return turned(rules, MOUNT, x, y, z)


@law
def from_hand(t: Tip, x: float, y: float, z: float) -> Vector:
    """Convert a vector from frame 7 to L; `t` is the tip's pose."""
    return (
        t.r11 * x + t.r12 * y + t.r13 * z,
        t.r21 * x + t.r22 * y + t.r23 * z,
        t.r31 * x + t.r32 * y + t.r33 * z,
    )


@law
def from_payload(rules: Array, t: Tip, x: float, y: float, z: float) -> Vector:
    """Convert a vector from the payload's axes to L (T_B8 = T_B7 T_78); `t` is the tip's pose."""
    a, b, c = turned(rules, HELD, x, y, z)
    return from_hand(t, a, b, c)
