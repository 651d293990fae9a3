"""RMSRAT: the closed-form resolved-rate law, from a tip twist to joint rates.

Source: JSC-12628, subroutine RMSRAT. Its equations are written in frame 5. Here the two equations for shoulder and
elbow pitch are written in the arm's plane, where most terms vanish and the coefficients are sines and cosines of the
links' slopes. With a heading-pitch-roll wrist, whose three axes intersect in one point, the first three joints move
that point and the last three produce the remaining rotation.

The three denominators are zero at the arm's singularities. If a denominator is nearer to zero than `floor`, the law
divides by the floor instead, and the rates remain finite. At a singularity, the law's rates are almost a multiple of
joint rates that do not move the tip. `kinematics.arm` rejects or masks singular poses; the steering slows the arm
before the arm reaches them.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from aftdeck.arms.geometry import HEADING_PITCH_ROLL
from aftdeck.arrays import Array
from aftdeck.kinematics.finite import finite
from aftdeck.kinematics.jacobian import Rates, Twist, of_six
from aftdeck.kinematics.linkage import L2, L3, L4, L5, WRIST, Floats, Sines, sines
from aftdeck.kinematics.singular import distances
from aftdeck.law import law

FLOOR = 1e-7
"""Normalised distance [1] below which a pose counts as singular: rates are then over 1e7 times their usual values."""


@law
def _away_from_zero(value: float, floor: float) -> float:
    """Return the value, or the floor with the value's sign if the value is nearer to zero than the floor."""
    return math.copysign(max(abs(value), floor), value)


@law
def per_distance(arm: Floats, a: Sines, floor: float) -> tuple[float, float, float]:
    """Return the reciprocals of RMSRAT's denominators, limited by the floor: shoulder [1/m], elbow [1], wrist [1]."""
    shoulder, elbow, wrist = distances(arm, a)
    return (
        1.0 / (_away_from_zero(shoulder, floor) * (arm[L2] + arm[L3] + abs(arm[L4]))),
        1.0 / _away_from_zero(elbow, floor),
        1.0 / _away_from_zero(wrist, floor),
    )


@law
def rmsrat(arm: Floats, a: Sines, t: Twist, floor: float) -> Rates:
    """Return joint rates [rad/s] for a tip twist in L (RMSRAT)."""
    return resolved(arm, a, t, per_distance(arm, a, floor))


@law
def resolved(arm: Floats, a: Sines, t: Twist, per: tuple[float, float, float]) -> Rates:
    """Return joint rates [rad/s] for a tip twist in L: RMSRAT without its divisions, which `per_distance` did."""
    if arm[WRIST] == HEADING_PITCH_ROLL:
        return _resolved_heading_pitch_roll(arm, a, t, per)
    per_shoulder, per_elbow, per_wrist = per
    side, ahead = arm[L5] * a.s5, arm[L5] * a.c5
    # twist outwards in the arm's plane (w1, v1) and along the plane's normal (b2, b5); downwards it is t.wz and t.vz
    w1, b2 = a.c1 * t.wx + a.s1 * t.wy, a.c1 * t.wy - a.s1 * t.wx
    v1, b5 = a.c1 * t.vx + a.s1 * t.vy, a.c1 * t.vy - a.s1 * t.vx
    # in frame 5
    b1, b3 = a.cw * w1 - a.sw * t.wz, a.sw * w1 + a.cw * t.wz
    r1 = (b5 - ahead * b3) * per_shoulder
    r5 = b3 - a.cw * r1
    roll = a.sw * r1
    r6 = (b1 + roll) * per_wrist
    # c1: sum of the three pitch rates; out, down: velocity that the lower arm's end has to have [m/s]
    c1 = b2 - a.s5 * r6
    c2, c3 = side * b3, side * roll + (arm[L4] + ahead) * c1
    out, down = v1 + (a.cw * c2 + a.sw * c3), t.vz + (a.cw * c3 - a.sw * c2)
    r2, r23 = _booms(arm, a, out, down, per_elbow)
    return of_six(r1, r2, r23 - r2, c1 - r23, r5, r6)


@law
def _booms(arm: Floats, a: Sines, out: float, down: float, per_elbow: float) -> tuple[float, float]:
    """Return the angular rates of upper and lower arm [rad/s].

    With these rates, the lower arm's end has the velocities `out` and `down` [m/s].
    """
    return (
        (down * a.s23 - out * a.c23) * (per_elbow * (1.0 / arm[L2])),
        (out * a.c2 - down * a.s2) * (per_elbow * (1.0 / arm[L3])),
    )


@law
def _resolved_heading_pitch_roll(arm: Floats, a: Sines, t: Twist, per: tuple[float, float, float]) -> Rates:
    """Return joint rates [rad/s] of an arm with a heading-pitch-roll wrist: RMSRAT without its divisions.

    Shoulder heading, shoulder pitch and elbow pitch move the point in which the wrist's axes intersect. The wrist
    produces the remaining rotation.
    """
    per_shoulder, per_elbow, per_wrist = per
    # twist outwards in the arm's plane (w1, v1) and along the plane's normal (w2, v2); downwards it is t.wz and t.vz
    w1, w2 = a.c1 * t.wx + a.s1 * t.wy, a.c1 * t.wy - a.s1 * t.wx
    v1, v2 = a.c1 * t.vx + a.s1 * t.vy, a.c1 * t.vy - a.s1 * t.vx
    # vector from the intersection of the wrist's axes to the tip: along and across the lower arm, and to the side
    ahead, across, side = arm[L5] * (a.cw * a.c5), -arm[L5] * a.s5, arm[L5] * (a.sw * a.c5)
    # components of this vector outwards and down
    out, down = a.c23 * ahead + a.s23 * across, a.c23 * across - a.s23 * ahead
    r1 = (v2 - t.wz * out + w1 * down) * per_shoulder
    r2, r23 = _booms(arm, a, v1 - w2 * down + t.wz * side, t.vz - w1 * side + w2 * out, per_elbow)
    # angular velocity that the wrist has to produce: along the lower arm, about the pitch axis, across the lower arm
    d1, d2, d3 = a.c23 * w1 - a.s23 * (t.wz - r1), w2 - r23, a.s23 * w1 + a.c23 * (t.wz - r1)
    r6 = (a.cw * d1 + a.sw * d2) * per_wrist
    return of_six(r1, r2, r23 - r2, d3 + a.s5 * r6, a.cw * d2 - a.sw * d1, r6)


@law
def rates_many(arm: Array, angles: Array, twists: Array, rates: Array, singular: NDArray[np.bool_]) -> bool:
    """Compute RMSRAT for each row.

    Args:
        arm: packed arm, as in `kinematics.linkage`.
        angles: (n, 6) joint angles [rad].
        twists: (n, 6) twists of the tip, in L.
        rates: (n, 6) output: joint rates [rad/s].
        singular: (n,) output: whether the pose is singular.

    Returns:
        Whether all angles and twists are finite.
    """
    whole = True
    for i in range(angles.shape[0]):
        q, t = angles[i], twists[i]
        whole = whole and finite(q) and finite(t)
        a = sines(arm, q[0], q[1], q[2], q[3], q[4], q[5])
        shoulder, elbow, wrist = distances(arm, a)
        singular[i] = abs(shoulder) < FLOOR or abs(elbow) < FLOOR or abs(wrist) < FLOOR
        r = rmsrat(arm, a, Twist(t[0], t[1], t[2], t[3], t[4], t[5]), FLOOR)
        rates[i, 0], rates[i, 1], rates[i, 2] = r.r1, r.r2, r.r3
        rates[i, 3], rates[i, 4], rates[i, 5] = r.r4, r.r5, r.r6
    return whole
