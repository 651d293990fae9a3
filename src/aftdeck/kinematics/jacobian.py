"""JACOBI and ERATES: the Jacobian, and the tip's twist from joint rates.

Source: JSC-12628, subroutines JACOBI and ERATES. The Jacobian is given in the frame of a link that lies in
the arm's plane, because many elements are zero in this frame. For a pitch-yaw-roll wrist it is frame 5, the wrist-pitch
frame, as in the source. For a heading-pitch-roll wrist it is system 1, the lower arm's frame. `spin` rotates vectors
from these frames into L.
"""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.arms.geometry import HEADING_PITCH_ROLL
from aftdeck.arrays import Array
from aftdeck.kinematics.finite import finite
from aftdeck.kinematics.linkage import L2, L3, L4, L5, WRIST, Floats, Sines, sines, spin
from aftdeck.law import law


class Jacobian(NamedTuple):
    """Matrix a in twist = a * rates, without the elements that are constant and equal in both families.

    The elements without a field are a22 and a23, which are 1, and elements that are 0. The matrix is given in a link's
    frame; s and c are the sine and cosine of that link's slope.
    """

    s: float
    c: float
    a11: float
    a15: float
    a16: float
    a24: float
    a25: float
    a26: float
    a31: float
    a34: float
    a35: float
    a36: float
    a41: float
    a42: float
    a43: float
    a44: float
    a45: float
    a51: float
    a54: float
    a55: float
    a61: float
    a62: float
    a63: float
    a64: float
    a65: float


class Twist(NamedTuple):
    """Angular velocity [rad/s], then translational velocity [m/s], of the tip."""

    wx: float
    wy: float
    wz: float
    vx: float
    vy: float
    vz: float


class Rates(NamedTuple):
    """Joint rates [rad/s], or other values of the joints: as many as an arm can have joints, 0 for the others."""

    r1: float
    r2: float
    r3: float
    r4: float
    r5: float
    r6: float
    r7: float
    r8: float


@law
def of_six(r1: float, r2: float, r3: float, r4: float, r5: float, r6: float) -> Rates:
    """Return the values of the joints of an arm with six joints."""
    return Rates(r1, r2, r3, r4, r5, r6, 0.0, 0.0)


@law
def of_array(values: Array) -> Rates:
    """Return the values (n,) of an arm's joints."""
    n = values.shape[0]
    return Rates(
        values[0],
        values[1] if n > 1 else 0.0,
        values[2] if n > 2 else 0.0,
        values[3] if n > 3 else 0.0,
        values[4] if n > 4 else 0.0,
        values[5] if n > 5 else 0.0,
        values[6] if n > 6 else 0.0,
        values[7] if n > 7 else 0.0,
    )


@law
def jacobi(arm: Floats, a: Sines) -> Jacobian:
    """Return the Jacobian in a link's frame (JACOBI): three angular rows, then three translational rows."""
    if arm[WRIST] == HEADING_PITCH_ROLL:
        return _jacobi_heading_pitch_roll(arm, a)
    s34, c34 = a.sw * a.c2 - a.cw * a.s2, a.cw * a.c2 + a.sw * a.s2
    s4, c4 = a.sw * a.c23 - a.cw * a.s23, a.cw * a.c23 + a.sw * a.s23
    hand = arm[L4] + arm[L5] * a.c5
    fore = arm[L3] * c4 + hand
    return Jacobian(
        s=a.sw,
        c=a.cw,
        a11=-a.sw,
        a15=0.0,
        a16=a.c5,
        a24=1.0,
        a25=0.0,
        a26=a.s5,
        a31=a.cw,
        a34=0.0,
        a35=1.0,
        a36=0.0,
        a41=-arm[L5] * a.cw * a.s5,
        a42=arm[L2] * s34 + arm[L3] * s4,
        a43=arm[L3] * s4,
        a44=0.0,
        a45=-arm[L5] * a.s5,
        a51=arm[L2] * a.c2 + arm[L3] * a.c23 + hand * a.cw,
        a54=0.0,
        a55=arm[L5] * a.c5,
        a61=-arm[L5] * a.sw * a.s5,
        a62=-arm[L2] * c34 - fore,
        a63=-fore,
        a64=-hand,
        a65=0.0,
    )


@law
def _jacobi_heading_pitch_roll(arm: Floats, a: Sines) -> Jacobian:
    """Return the Jacobian in system 1, from the axes of the joints and the moments of these axes about the tip."""
    s3, c3 = a.s23 * a.c2 - a.c23 * a.s2, a.c23 * a.c2 + a.s23 * a.s2
    x, y, z = a.cw * a.c5, a.sw * a.c5, -a.s5  # the end effector's direction
    hx, hy, hz = arm[L5] * x, arm[L5] * y, arm[L5] * z
    return Jacobian(
        s=a.s23,
        c=a.c23,
        a11=-a.s23,
        a15=-a.sw,
        a16=x,
        a24=0.0,
        a25=a.cw,
        a26=y,
        a31=a.c23,
        a34=1.0,
        a35=0.0,
        a36=z,
        a41=-a.c23 * hy,
        a42=arm[L2] * s3 + hz,
        a43=hz,
        a44=-hy,
        a45=-arm[L5] * a.cw * a.s5,
        a51=arm[L2] * a.c2 + arm[L3] * a.c23 + a.c23 * hx + a.s23 * hz,
        a54=hx,
        a55=-arm[L5] * a.sw * a.s5,
        a61=-a.s23 * hy,
        a62=-arm[L2] * c3 - arm[L3] - hx,
        a63=-arm[L3] - hx,
        a64=0.0,
        a65=-arm[L5] * a.c5,
    )


@law
def erates(a: Sines, j: Jacobian, r: Rates) -> Twist:
    """Return the tip's twist in L from joint rates (ERATES)."""
    wx, wy, wz = spin(
        a,
        j.s,
        j.c,
        j.a11 * r.r1 + j.a15 * r.r5 + j.a16 * r.r6,
        r.r2 + r.r3 + j.a24 * r.r4 + j.a25 * r.r5 + j.a26 * r.r6,
        j.a31 * r.r1 + j.a34 * r.r4 + j.a35 * r.r5 + j.a36 * r.r6,
    )
    vx, vy, vz = spin(
        a,
        j.s,
        j.c,
        j.a41 * r.r1 + j.a42 * r.r2 + j.a43 * r.r3 + j.a44 * r.r4 + j.a45 * r.r5,
        j.a51 * r.r1 + j.a54 * r.r4 + j.a55 * r.r5,
        j.a61 * r.r1 + j.a62 * r.r2 + j.a63 * r.r3 + j.a64 * r.r4 + j.a65 * r.r5,
    )
    return Twist(wx, wy, wz, vx, vy, vz)


@law
def jacobian_many(arm: Array, angles: Array, matrix: Array) -> bool:
    """Compute JACOBI for each row of angles (n, 6) [rad], and write it, in L, into `matrix` (n, 6, 6).

    Returns:
        Whether all angles are finite.
    """
    whole = True
    for i in range(angles.shape[0]):
        q = angles[i]
        whole = whole and finite(q)
        a = sines(arm, q[0], q[1], q[2], q[3], q[4], q[5])
        j = jacobi(arm, a)
        for k in range(6):
            unit = of_six(
                1.0 if k == 0 else 0.0,
                1.0 if k == 1 else 0.0,
                1.0 if k == 2 else 0.0,
                1.0 if k == 3 else 0.0,
                1.0 if k == 4 else 0.0,
                1.0 if k == 5 else 0.0,
            )
            t = erates(a, j, unit)
            matrix[i, 0, k], matrix[i, 1, k], matrix[i, 2, k] = t.wx, t.wy, t.wz
            matrix[i, 3, k], matrix[i, 4, k], matrix[i, 5, k] = t.vx, t.vy, t.vz
    return whole
