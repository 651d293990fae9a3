"""One closed-loop step towards a target, with the same laws for one arm and for blocks of arms.

A step computes the tip pose (LNKAGE), the remaining error to the target, the joint rates for a twist proportional to
this error (RMSRAT), their reduction to the rate limits (RATLMT), and the joint angles after one control period. A block
holds `LANES` arms. Each row of a block holds one value of every arm, so that one instruction of the processor handles
several arms. A computation of one arm alone gives the same result, bit for bit, except with `fast`.
Source: JSC-12628, subroutines LNKAGE, RMSRAT, RATLMT.
"""

from __future__ import annotations

from aftdeck import elementary
from aftdeck.arms.geometry import HEADING_PITCH_ROLL, PITCH_YAW_ROLL
from aftdeck.arrays import Array
from aftdeck.elementary import reduced, sincos_near_zero, turned_on
from aftdeck.kinematics.jacobian import Rates, Twist, of_six
from aftdeck.kinematics.linkage import Floats, Nine, Sines, Three, axes, link_angles, place, sines
from aftdeck.kinematics.rates import per_distance, resolved, rmsrat
from aftdeck.law import fused, law
from aftdeck.steering.msteer import NEAR_FLOOR
from aftdeck.tuples import Joints, Six

LANES = 40
"""Number of arms in a block.

A row of this length is a whole number of processor vectors and of cache lines, and its size is not a power of two.
"""
TARGET, LEFT, FIELDS = 6, 18, 24
"""Rows of a block. Rows 0 to 5: joint angles [rad]. From TARGET on: the target (12), as in `latraj`. From LEFT on: the
remaining error (6). FIELDS is the number of rows."""

PER, QUARTERS, WORK = 12, 15, 21
"""Rows of the work array.

Rows 0 to 5: sines. Rows 6 to 11: cosines. From PER on: reciprocals of the rate law's denominators (3). From QUARTERS
on: number of whole quarter turns in each link's angle (6). WORK is the number of rows.
"""

PERIOD, GAIN, PER_RATE = 0, 1, 2
"""Indices in a `pace`: control period [s], gain [1/s]. From PER_RATE on: reciprocals of maximum joint rates [s/rad]."""


@law
def remaining_rotation(t: Nine, target: Floats) -> Three:
    """Return the rotation from the tip's axes to the axes of a target (12,), in L: axis times sine of the angle.

    The result is half the sum of three cross products: each axis of the tip times the corresponding axis of the target.
    At 180 deg the result is zero, and the tip does not rotate.
    """
    r11, r12, r13, r21, r22, r23, r31, r32, r33 = t
    return (
        0.5 * ((r21 * target[9] - r31 * target[6]) + (r22 * target[10] - r32 * target[7])
               + (r23 * target[11] - r33 * target[8])),
        0.5 * ((r31 * target[3] - r11 * target[9]) + (r32 * target[4] - r12 * target[10])
               + (r33 * target[5] - r13 * target[11])),
        0.5 * ((r11 * target[6] - r21 * target[3]) + (r12 * target[7] - r22 * target[4])
               + (r13 * target[8] - r23 * target[5])),
    )  # fmt: skip


@law
def remaining_distance(t: Three, target: Floats) -> Three:
    """Return the vector from the tip to the target's position, in L [m]; the position is `target[0:3]`."""
    return target[0] - t[0], target[1] - t[1], target[2] - t[2]


@law
def angles_after_step(pace: Floats, r: Rates, q: Floats) -> Joints:
    """Return the joint angles [rad] after one control period at the demanded rates, reduced by RATLMT.

    `r` holds the joint rates for a twist equal to the remaining error. The demanded twist is gain times this error. The
    rate law is linear, and the demanded rates are therefore gain times `r`.
    """
    upper = max(abs(r.r1) * pace[PER_RATE], abs(r.r2) * pace[PER_RATE + 1], abs(r.r3) * pace[PER_RATE + 2])
    lower = max(abs(r.r4) * pace[PER_RATE + 3], abs(r.r5) * pace[PER_RATE + 4], abs(r.r6) * pace[PER_RATE + 5])
    k = pace[GAIN] * pace[PERIOD] / max(1.0, pace[GAIN] * max(upper, lower))
    return q[0] + k * r.r1, q[1] + k * r.r2, q[2] + k * r.r3, q[3] + k * r.r4, q[4] + k * r.r5, q[5] + k * r.r6


@law
def steer_one(arm: Array, pace: Array, angles: Array, target: Array) -> None:
    """Make one step of one arm towards a target (12,); the joint angles [rad] are changed in place."""
    a = sines(arm, angles[0], angles[1], angles[2], angles[3], angles[4], angles[5])
    wx, wy, wz = remaining_rotation(axes(arm, a), target)
    vx, vy, vz = remaining_distance(place(arm, a), target)
    rates = rmsrat(arm, a, Twist(wx, wy, wz, vx, vy, vz), NEAR_FLOOR)
    angles[0], angles[1], angles[2], angles[3], angles[4], angles[5] = angles_after_step(pace, rates, angles)


@law
def three(rows: Array, first: int, i: int) -> Three:
    """Read arm `i`'s values from three rows; the first of them is row `first`."""
    n = first * LANES + i
    return rows[n], rows[n + LANES], rows[n + 2 * LANES]


@law
def put_three(rows: Array, first: int, i: int, values: tuple[float, ...]) -> None:
    """Write arm `i`'s values into three rows; the first of them is row `first`."""
    n = first * LANES + i
    rows[n], rows[n + LANES], rows[n + 2 * LANES] = values


@law
def six(rows: Array, first: int, i: int) -> Six:
    """Read arm `i`'s values from six rows; the first of them is row `first`."""
    return three(rows, first, i) + three(rows, first + 3, i)


@law
def put_six(rows: Array, first: int, i: int, values: tuple[float, ...]) -> None:
    """Write the first six of arm `i`'s values into six rows; the first of them is row `first`."""
    put_three(rows, first, i, values[:3])
    put_three(rows, first + 3, i, values[3:6])


@law
def sines_in(work: Array, i: int) -> Sines:
    """Return the sines and cosines of arm `i`."""
    s1, s2, s23, sw, s5, s6 = six(work, 0, i)
    c1, c2, c23, cw, c5, c6 = six(work, 6, i)
    return Sines(s1, c1, s2, c2, s23, c23, sw, cw, s5, c5, s6, c6)


_fused_reduced, _fused_sincos_near_zero = fused(elementary.reduced), fused(elementary.sincos_near_zero)
_fused_turned_on = fused(elementary.turned_on)


@law
def replace_by_sines(work: Array) -> None:
    """Replace the link angles in `work` by their sines and cosines.

    `elementary.sincos` is split into three short loops, in which the processor handles several vectors of arms at the
    same time.
    """
    for n in range(6 * LANES):
        work[n], work[n + QUARTERS * LANES] = reduced(work[n])
    for n in range(6 * LANES):
        work[n], work[n + 6 * LANES] = sincos_near_zero(work[n])
    for n in range(6 * LANES):
        work[n], work[n + 6 * LANES] = turned_on(work[n], work[n + 6 * LANES], work[n + QUARTERS * LANES])


@law
def _fused_sines(work: Array) -> None:
    """Do the same as `replace_by_sines` with fused products and sums."""
    for n in range(6 * LANES):
        work[n], work[n + QUARTERS * LANES] = _fused_reduced(work[n])
    for n in range(6 * LANES):
        work[n], work[n + 6 * LANES] = _fused_sincos_near_zero(work[n])
    for n in range(6 * LANES):
        work[n], work[n + 6 * LANES] = _fused_turned_on(work[n], work[n + 6 * LANES], work[n + QUARTERS * LANES])


@law
def _evaluate(arm: Floats, block: Array, work: Array, fast: bool) -> None:
    """Compute a block's remaining errors, and the values that the rate law needs, from the link angles in `work`.

    `work` receives sines and cosines, and the reciprocal of each denominator.
    """
    if fast:
        _fused_sines(work)
    else:
        replace_by_sines(work)
    for i in range(LANES):
        a = sines_in(work, i)
        put_three(work, PER, i, per_distance(arm, a, NEAR_FLOOR))
        put_three(block, LEFT + 3, i, remaining_distance(place(arm, a), three(block, TARGET, i)))
    for i in range(LANES):
        target = six(block, TARGET, i) + six(block, TARGET + 6, i)
        put_three(block, LEFT, i, remaining_rotation(axes(arm, sines_in(work, i)), target))


@law
def steer_blocks(arm: Floats, pace: Floats, blocks: Array, work: Array, steps: int, fast: bool) -> None:
    """Make many steps of many arms, in place.

    Each arm family has its own loops, in which the kind of wrist is a constant. With a test of the family inside the
    loops, the steps would take a quarter more time.

    Args:
        arm: the arm's constants, as a tuple.
        pace: the values of `pace_of`, as a tuple.
        blocks: (blocks, FIELDS * LANES), each block row by row.
        work: (WORK * LANES,) work array, overwritten.
        steps: number of control periods.
        fast: whether sines are computed with fused products and sums.
    """
    l1, l2, l3, l4, l5, upper, lower, wrist = arm
    if wrist == PITCH_YAW_ROLL:
        _steer_wrist((l1, l2, l3, l4, l5, upper, lower, PITCH_YAW_ROLL), pace, blocks, work, steps, fast)
    else:
        _steer_wrist((l1, l2, l3, l4, l5, upper, lower, HEADING_PITCH_ROLL), pace, blocks, work, steps, fast)


@law
def _steer_wrist(arm: Floats, pace: Floats, blocks: Array, work: Array, steps: int, fast: bool) -> None:
    """Call `_steer_family` with `fast` as a constant for the compiler."""
    if fast:
        _steer_family(arm, pace, blocks, work, steps, True)
    else:
        _steer_family(arm, pace, blocks, work, steps, False)


@law
def _steer_family(arm: Floats, pace: Floats, blocks: Array, work: Array, steps: int, fast: bool) -> None:
    """Make the steps of `steer_blocks` for a kind of wrist that is a constant for the compiler.

    A step makes several passes over a block, because in a short loop the processor handles more arms at the same time.
    The rows are in one array, with constant distances, so that the compiler can see that they do not overlap.
    """
    for b in range(blocks.shape[0]):
        block = blocks[b]
        for i in range(LANES):
            q1, q2, q3, q4, q5, q6 = six(block, 0, i)
            put_six(work, 0, i, link_angles(arm, q1, q2, q3, q4, q5, q6))
        _evaluate(arm, block, work, fast)
        for _ in range(steps):
            for i in range(LANES):
                wx, wy, wz, vx, vy, vz = six(block, LEFT, i)
                twist = Twist(wx, wy, wz, vx, vy, vz)
                put_six(block, LEFT, i, resolved(arm, sines_in(work, i), twist, three(work, PER, i)))
            for i in range(LANES):
                r1, r2, r3, r4, r5, r6 = six(block, LEFT, i)
                q = angles_after_step(pace, of_six(r1, r2, r3, r4, r5, r6), six(block, 0, i))
                put_six(block, 0, i, q)
                put_six(work, 0, i, link_angles(arm, q[0], q[1], q[2], q[3], q[4], q[5]))
            _evaluate(arm, block, work, fast)
