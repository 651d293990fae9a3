"""RMANGS: closed-form inverse kinematics, with all branches.

Source: JSC-12628, subroutine RMANGS. The source returns one branch. It computes the shoulder pitch by an arc cosine,
which loses the sign. Here arc tangents give all eight branches: two for the shoulder (theta1 and theta1 + pi), times
two for the wrist (theta5 and pi - theta5), times two for the elbow (up and down). A pitch-yaw-roll wrist is solved
before the elbow, as in the source. A heading-pitch-roll wrist, whose axes intersect in one point, is solved after the
elbow.
"""

from __future__ import annotations

import math

from aftdeck.arms.geometry import HEADING_PITCH_ROLL
from aftdeck.arrays import Array
from aftdeck.elementary import acos, atan2, nearest, sincos
from aftdeck.kinematics.linkage import L1, L2, L3, L4, L5, LOWER, UPPER, WRIST
from aftdeck.law import law

BRANCHES = 8


@law
def _within_pi(angle: float) -> float:
    """Return the equivalent angle in [-pi, pi]."""
    return angle - math.tau * nearest(angle / math.tau)


@law
def _triangle(upper: float, lower: float, out: float, up: float) -> tuple[float, float, float, float]:
    """Solve the triangle of upper arm, lower arm, and the line from the shoulder pitch joint to the lower arm's end.

    Args:
        upper: length of the upper arm [m].
        lower: length of the lower arm [m].
        out: distance of the lower arm's end outwards from the shoulder pitch joint [m].
        up: distance of the lower arm's end upwards from the shoulder pitch joint [m].

    Returns:
        Slope of the line to the lower arm's end [rad]; angle between this line and the upper arm [rad]; angle between
        upper and lower arm [rad]; and the distance by which the end is out of reach [m]. This distance is positive
        beyond the reach of the stretched arm, negative inside the reach of the folded arm, and 0 within reach.
    """
    square = out * out + up * up
    ck = (square - upper * upper - lower * lower) / (2.0 * upper * lower)
    beyond = 0.0
    if ck > 1.0 + 1e-14:
        beyond = math.sqrt(square) - upper - lower
    if ck < -1.0 - 1e-14:
        beyond = math.sqrt(square) - abs(upper - lower)
    ck = min(max(ck, -1.0), 1.0)
    along, across = upper + lower * ck, lower * math.sqrt(1.0 - ck * ck)
    return atan2(up, out), atan2(across, along), acos(ck), beyond


@law
def rmangs(arm: Array, pose: Array, angles: Array, excess: Array) -> tuple[float, float]:
    """Write every set of joint angles that puts the tip at a pose (RMANGS).

    Args:
        arm: packed arm, as in `kinematics.linkage`.
        pose: (12,) tip position in L [m], then the rotation row by row.
        angles: (8, 6) output: panel angles in [-pi, pi] [rad]. Each pair of a shoulder branch and a wrist branch has
            two rows. In the first row the elbow is bent as usual, with the lower arm below the upper arm's line; in the
            second row it is bent in the opposite direction.
        excess: (8,) output: distance by which the row's wrist is out of reach [m]: positive beyond the reach of the
            stretched arm, negative inside the reach of the folded arm, 0 if the row is a solution.

    Returns:
        Distance of the fifth joint from the first joint's axis [m], and the greatest cosine of the fifth angle on any
        row. If one of these values is about zero, the pose is singular on every row, and the angles are not unique.
        With a heading-pitch-roll wrist, it is also possible that only some rows are singular. Then only the angles of
        these rows are not unique.
    """
    r1 = pose[0] - pose[3] * arm[L5]
    r2 = pose[1] - pose[6] * arm[L5]
    r3 = pose[2] - pose[9] * arm[L5] + arm[L1]
    off_axis = math.sqrt(r1 * r1 + r2 * r2)
    cosine = 0.0
    row = 0
    for side in (1.0, -1.0):
        # theta1, or theta1 + pi
        q1 = atan2(side * r2, side * r1)
        c1 = side * r1 / off_axis if off_axis > 0.0 else side
        s1 = side * r2 / off_axis if off_axis > 0.0 else 0.0
        out, up = r1 * c1 + r2 * s1, -r3
        if arm[WRIST] == HEADING_PITCH_ROLL:
            cosine = max(cosine, _heading_rows(arm, pose, q1, s1, c1, out, up, angles, excess, row))
            row += 4
            continue
        b11 = c1 * pose[3] + s1 * pose[6]
        b21 = -s1 * pose[3] + c1 * pose[6]
        b22 = -s1 * pose[4] + c1 * pose[7]
        b23 = -s1 * pose[5] + c1 * pose[8]
        b31 = pose[9]
        cosine = math.sqrt(b22 * b22 + b23 * b23)
        for sign in (1.0, -1.0):
            # theta5, or pi - theta5; beta is the slope of the link after wrist pitch: the sum of the three pitch angles
            q5 = atan2(b21, sign * cosine)
            q6 = atan2(-sign * b23, sign * b22)
            beta = atan2(-sign * b31, sign * b11)
            flat = math.sqrt(b11 * b11 + b31 * b31)
            cb = sign * b11 / flat if flat > 0.0 else 1.0
            sb = -sign * b31 / flat if flat > 0.0 else 0.0
            slope, lift, bend, beyond = _triangle(arm[L2], arm[L3], out - arm[L4] * cb, up - arm[L4] * sb)
            for elbow in (-1.0, 1.0):
                # lower arm bent below the upper arm's line, then above it
                q2 = slope - elbow * lift - arm[UPPER]
                q3 = elbow * bend + arm[UPPER] - arm[LOWER]
                excess[row] = beyond
                angles[row, 0], angles[row, 1], angles[row, 2] = q1, _within_pi(q2), _within_pi(q3)
                angles[row, 3], angles[row, 4], angles[row, 5] = _within_pi(beta - q2 - q3), q5, q6
                row += 1
    return off_axis, cosine


@law
def _heading_rows(
    arm: Array,
    pose: Array,
    q1: float,
    s1: float,
    c1: float,
    out: float,
    up: float,
    angles: Array,
    excess: Array,
    first: int,
) -> float:
    """Write the four rows of one branch of the shoulder heading, from row `first` on.

    The wrist is at the distances `out` and `up` from the shoulder pitch joint [m].

    Returns:
        Greatest cosine of the wrist pitch on any of these rows.
    """
    b11, b12, b13 = c1 * pose[3] + s1 * pose[6], c1 * pose[4] + s1 * pose[7], c1 * pose[5] + s1 * pose[8]
    b21, b22, b23 = c1 * pose[6] - s1 * pose[3], c1 * pose[7] - s1 * pose[4], c1 * pose[8] - s1 * pose[5]
    slope, lift, bend, beyond = _triangle(arm[L2], arm[L3], out, up)
    greatest = 0.0
    for other in (0, 1):
        # lower arm bent below the upper arm's line, then above it
        elbow = 2.0 * other - 1.0
        q2 = slope - elbow * lift - arm[UPPER]
        q3 = elbow * bend + arm[UPPER] - arm[LOWER]
        s, c = sincos(q2 + q3 + arm[LOWER])
        d11, d12, d13 = c * b11 - s * pose[9], c * b12 - s * pose[10], c * b13 - s * pose[11]
        d31 = s * b11 + c * pose[9]
        cosine = math.sqrt(d11 * d11 + b21 * b21)
        greatest = max(greatest, cosine)
        for turned in (0, 1):
            # theta5, or pi - theta5; the roll is computed from the pitch axis, so that roll and heading agree even
            # where the heading is ill-defined
            sign = 1.0 - 2.0 * turned
            q4 = atan2(sign * b21, sign * d11)
            sh, ch = sincos(q4)
            row = first + 2 * turned + other
            excess[row] = beyond
            angles[row, 0], angles[row, 1], angles[row, 2] = q1, _within_pi(q2), _within_pi(q3)
            angles[row, 3], angles[row, 4] = q4, atan2(-d31, sign * cosine)
            angles[row, 5] = atan2(sh * d13 - ch * b23, ch * b22 - sh * d12)
    return greatest
