"""LATRAJ: distance and direction (line of sight), angle and axis of rotation (angle of sight) from a pose to a target.

JSC-12628, subroutine LATRAJ. The angle is computed by an arc tangent, which is accurate at small angles. Beyond 90 deg
the axis is computed from the symmetric part of the rotation matrix. This method is accurate even at 180 deg.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.elementary import atan2
from aftdeck.kinematics.linkage import Tip
from aftdeck.law import law


class Aim(NamedTuple):
    """Distance [m] and direction (u) to a target, and angle [rad] and axis (a) of the rotation to the target, in L."""

    distance: float
    ux: float
    uy: float
    uz: float
    angle: float
    ax: float
    ay: float
    az: float


@law
def latraj(tip: Tip, target: Array) -> Aim:
    """Return the aim from the tip to a target (12,): position [m], then rotation row by row (LATRAJ)."""
    dx, dy, dz = target[0] - tip.x, target[1] - tip.y, target[2] - tip.z
    distance = math.sqrt(dx * dx + dy * dy + dz * dz)
    per = 1.0 / distance if distance > 0.0 else 0.0
    b11 = target[3] * tip.r11 + target[4] * tip.r12 + target[5] * tip.r13
    b12 = target[3] * tip.r21 + target[4] * tip.r22 + target[5] * tip.r23
    b13 = target[3] * tip.r31 + target[4] * tip.r32 + target[5] * tip.r33
    b21 = target[6] * tip.r11 + target[7] * tip.r12 + target[8] * tip.r13
    b22 = target[6] * tip.r21 + target[7] * tip.r22 + target[8] * tip.r23
    b23 = target[6] * tip.r31 + target[7] * tip.r32 + target[8] * tip.r33
    b31 = target[9] * tip.r11 + target[10] * tip.r12 + target[11] * tip.r13
    b32 = target[9] * tip.r21 + target[10] * tip.r22 + target[11] * tip.r23
    b33 = target[9] * tip.r31 + target[10] * tip.r32 + target[11] * tip.r33
    sx, sy, sz = 0.5 * (b32 - b23), 0.5 * (b13 - b31), 0.5 * (b21 - b12)
    sine = math.sqrt(sx * sx + sy * sy + sz * sz)
    cosine = 0.5 * (b11 + b22 + b33 - 1.0)
    angle = atan2(sine, cosine)
    if cosine >= 0.0:
        turn = 1.0 / sine if sine > 0.0 else 0.0
        ax, ay, az = turn * sx, turn * sy, turn * sz
    else:
        ax, ay, az = _axis_of_large_turn(b11, b22, b33, b12 + b21, b13 + b31, b23 + b32, cosine)
        if ax * sx + ay * sy + az * sz < 0.0:
            ax, ay, az = -ax, -ay, -az
    return Aim(distance, per * dx, per * dy, per * dz, angle, ax, ay, az)


@law
def _axis_of_large_turn(
    b11: float, b22: float, b33: float, b12: float, b13: float, b23: float, cosine: float
) -> tuple[float, float, float]:
    """Return the axis of a rotation beyond 90 deg; the sign of the axis is arbitrary.

    All three components are computed from one column of the matrix: the column of the axis's largest component
    (LATRAJ's 180 deg case).

    Args:
        b11: first element on the matrix's diagonal; b22 and b33 are the second and third element.
        b22: see b11.
        b33: see b11.
        b12: sum of the elements 12 and 21; b13 and b23 are the corresponding sums.
        b13: see b12.
        b23: see b12.
        cosine: cosine of the angle.
    """
    xx, yy, zz = b11 - cosine, b22 - cosine, b33 - cosine
    if xx >= yy and xx >= zz:
        ax, ay, az = xx, 0.5 * b12, 0.5 * b13
    elif yy >= zz:
        ax, ay, az = 0.5 * b12, yy, 0.5 * b23
    else:
        ax, ay, az = 0.5 * b13, 0.5 * b23, zz
    per = 1.0 / math.sqrt(ax * ax + ay * ay + az * az)
    return per * ax, per * ay, per * az
