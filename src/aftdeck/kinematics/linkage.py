"""LNKAGE: pose of the tip, for arms of two families, which differ in their wrists.

In both families, the first three joints are a rotation about the vertical (yaw or heading) and two pitches. Upper and
lower arm define the *arm's plane*. The wrist of JSC-12628 has pitch, yaw and roll. The wrist of the *Remote Manipulator
Simulation* has heading, pitch and roll; its axes intersect in one point. All vectors are in L. An arm is a packed
array; the constants below are indices into this array. Joint angles are those of the panel: for the Shuttle's arm they
are zero at the cradle. If the elbow joint is below the boom line, this module adds constant offsets to shoulder pitch
and elbow pitch.

Sources: JSC-12628, subroutine LNKAGE; Remote Manipulator Simulation, final report, "R(-HO) R(-PO) R(-P1) R(-H2) R(-P2)
R(-R2)", with heading about Z (restored) and with pitch positive upwards.
"""

from __future__ import annotations

from typing import NamedTuple, TypeAlias

from aftdeck.arms.geometry import HEADING_PITCH_ROLL, PITCH_YAW_ROLL
from aftdeck.arrays import Array
from aftdeck.elementary import sincos
from aftdeck.kinematics.finite import finite
from aftdeck.law import law

Floats: TypeAlias = Array | tuple[float, ...]
"""Floats as the argument of a law, such as the constants of an arm: an array; in loops over many arms, a tuple."""
Three: TypeAlias = tuple[float, float, float]
Nine: TypeAlias = tuple[float, float, float, float, float, float, float, float, float]

L1, L2, L3, L4, L5 = 0, 1, 2, 3, 4
"""Indices of the lengths in an arm's array [m]. L1: height of the shoulder pitch joint above L's origin. L2: upper arm.
L3: lower arm. L4: from wrist pitch to wrist yaw; 0 if the wrist's axes intersect in one point. L5: from wrist yaw to
the tip; if the wrist's axes intersect in one point, from this point to the tip."""
UPPER, LOWER = 5, 6
"""Indices of the slopes of upper arm and lower arm at zero joint angles, from the boom line upwards [rad]."""
WRIST = 7
"""Index of the kind of wrist, which identifies the solver."""
LINKS = 8
"""Number of values in an arm's array; one of the kind `GENERAL` ends with its packed chain (`arms.chain`) besides."""


class Sines(NamedTuple):
    """Sines and cosines of the angles that `link_angles` returns.

    In the names, 2 stands for the slope of the upper arm and 23 for the slope of the lower arm. w stands for the
    wrist's first angle: for a pitch-yaw-roll wrist the slope of the wrist, for a heading-pitch-roll wrist the wrist
    heading.
    """

    s1: float
    c1: float
    s2: float
    c2: float
    s23: float
    c23: float
    sw: float
    cw: float
    s5: float
    c5: float
    s6: float
    c6: float


class Tip(NamedTuple):
    """Tip position [m] and orientation (columns are the axes of frame 7, or system 2), in L."""

    x: float
    y: float
    z: float
    r11: float
    r12: float
    r13: float
    r21: float
    r22: float
    r23: float
    r31: float
    r32: float
    r33: float


@law
def link_angles(
    arm: Floats, q1: float, q2: float, q3: float, q4: float, q5: float, q6: float
) -> tuple[float, float, float, float, float, float]:
    """Return the angles whose sines and cosines LNKAGE uses [rad].

    They are yaw, the slope of the upper arm, the slope of the lower arm, and the wrist's three angles.
    """
    slope = q2 + q3 if arm[WRIST] == PITCH_YAW_ROLL else 0.0
    return q1, q2 + arm[UPPER], q2 + q3 + arm[LOWER], slope + q4, q5, q6


@law
def sines(arm: Floats, q1: float, q2: float, q3: float, q4: float, q5: float, q6: float) -> Sines:
    """Return the sines and cosines for joint angles [rad]."""
    t1, t2, t23, tw, t5, t6 = link_angles(arm, q1, q2, q3, q4, q5, q6)
    s1, c1 = sincos(t1)
    s2, c2 = sincos(t2)
    s23, c23 = sincos(t23)
    sw, cw = sincos(tw)
    s5, c5 = sincos(t5)
    s6, c6 = sincos(t6)
    return Sines(s1, c1, s2, c2, s23, c23, sw, cw, s5, c5, s6, c6)


@law
def spin(a: Sines, s: float, c: float, x: float, y: float, z: float) -> Three:
    """Return the components in L of a vector with the components x, y, z in a link's frame.

    The link lies in the arm's plane. x is along the link, y along the normal of the arm's plane, and z across the link.
    s and c are the sine and cosine of the link's slope.
    """
    out = c * x + s * z
    return a.c1 * out - a.s1 * y, a.s1 * out + a.c1 * y, -s * x + c * z


@law
def place(arm: Floats, a: Sines) -> Three:
    """Return LNKAGE's r: the tip's position in L [m]."""
    if arm[WRIST] == HEADING_PITCH_ROLL:
        out = arm[L2] * a.c2 + arm[L3] * a.c23
        hx, hy, hz = spin(a, a.s23, a.c23, a.cw * a.c5, a.sw * a.c5, -a.s5)
        down = -arm[L1] - arm[L2] * a.s2 - arm[L3] * a.s23
        return a.c1 * out + arm[L5] * hx, a.s1 * out + arm[L5] * hy, down + arm[L5] * hz
    hand = arm[L4] + arm[L5] * a.c5
    out = arm[L2] * a.c2 + arm[L3] * a.c23 + hand * a.cw
    side = arm[L5] * a.s5
    down = -arm[L1] - arm[L2] * a.s2 - arm[L3] * a.s23 - hand * a.sw
    return a.c1 * out - a.s1 * side, a.s1 * out + a.c1 * side, down


@law
def axes(arm: Floats, a: Sines) -> Nine:
    """Return LNKAGE's T_B7, row by row: columns are the axes of frame 7, or system 2, in L."""
    if arm[WRIST] == HEADING_PITCH_ROLL:
        return _axes_heading_pitch_roll(a)
    b11, b12 = a.c1 * a.cw, a.c1 * a.sw
    b21, b22 = a.s1 * a.cw, a.s1 * a.sw
    y1 = -b11 * a.s5 - a.s1 * a.c5
    y2 = -b21 * a.s5 + a.c1 * a.c5
    y3 = a.sw * a.s5
    return (
        b11 * a.c5 - a.s1 * a.s5,
        y1 * a.c6 + b12 * a.s6,
        -y1 * a.s6 + b12 * a.c6,
        b21 * a.c5 + a.c1 * a.s5,
        y2 * a.c6 + b22 * a.s6,
        -y2 * a.s6 + b22 * a.c6,
        -a.sw * a.c5,
        y3 * a.c6 + a.cw * a.s6,
        -y3 * a.s6 + a.cw * a.c6,
    )


@law
def _axes_heading_pitch_roll(a: Sines) -> Nine:
    """Return the axes of system 2 in L, row by row, for a heading-pitch-roll wrist (Remote Manipulator Simulation)."""
    r11, r21, r31 = spin(a, a.s23, a.c23, a.cw * a.c5, a.sw * a.c5, -a.s5)
    y1, y2, y3 = spin(a, a.s23, a.c23, -a.sw, a.cw, 0.0)
    z1, z2, z3 = spin(a, a.s23, a.c23, a.cw * a.s5, a.sw * a.s5, a.c5)
    return (
        r11,
        y1 * a.c6 + z1 * a.s6,
        -y1 * a.s6 + z1 * a.c6,
        r21,
        y2 * a.c6 + z2 * a.s6,
        -y2 * a.s6 + z2 * a.c6,
        r31,
        y3 * a.c6 + z3 * a.s6,
        -y3 * a.s6 + z3 * a.c6,
    )


@law
def tip(arm: Floats, a: Sines) -> Tip:
    """Return the tip's position and axes from the joints' sines and cosines (LNKAGE)."""
    x, y, z = place(arm, a)
    r11, r12, r13, r21, r22, r23, r31, r32, r33 = axes(arm, a)
    return Tip(x, y, z, r11, r12, r13, r21, r22, r23, r31, r32, r33)


@law
def lifted(t: Tip, by: float) -> Tip:
    """Return the tip's position and axes for the same arm raised as a whole by the length `by` [m]."""
    return Tip(t.x, t.y, t.z - by, t.r11, t.r12, t.r13, t.r21, t.r22, t.r23, t.r31, t.r32, t.r33)


@law
def put_tip(t: Tip, position: Array, rotation: Array) -> None:
    """Write the tip's position (3,) [m] and rotation (3, 3)."""
    position[0], position[1], position[2] = t.x, t.y, t.z
    rotation[0, 0], rotation[0, 1], rotation[0, 2] = t.r11, t.r12, t.r13
    rotation[1, 0], rotation[1, 1], rotation[1, 2] = t.r21, t.r22, t.r23
    rotation[2, 0], rotation[2, 1], rotation[2, 2] = t.r31, t.r32, t.r33


@law
def forward_many(arm: Array, angles: Array, position: Array, rotation: Array) -> bool:
    """Compute LNKAGE for each row of angles (n, 6) [rad].

    Write the results, in L, into `position` (n, 3) [m] and `rotation` (n, 3, 3).

    Returns:
        Whether all angles are finite.
    """
    whole = True
    for i in range(angles.shape[0]):
        q = angles[i]
        whole = whole and finite(q)
        put_tip(tip(arm, sines(arm, q[0], q[1], q[2], q[3], q[4], q[5])), position[i], rotation[i])
    return whole
