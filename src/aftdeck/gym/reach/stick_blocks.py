"""Mode 4 (ORB UNL) on the kinematic plant, for blocks of arms without a payload: one control step from the sticks.

Every arm gets the joint rates that `msteer` commands and the angles that the kinematic plant then has, bit for bit
(`tests/gym/test_stick_blocks.py`). `msteer` needs 0.7 us for an arm; a block needs 0.05 us for each. A step makes
several passes over a block (`steering/blocks.py`), in which one instruction of the processor handles several arms.

Preconditions: a pitch-yaw-roll wrist; rules with GUARDED and without STRICT and AS_FLOWN; joints inside their hard
stops.
Source: JSC-12628, subroutines VOTRAN (MODE = 4), AVCLMT, RMSRAT, RATLMT.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Rates, Twist, of_six
from aftdeck.kinematics.linkage import Floats, Sines, link_angles
from aftdeck.kinematics.rates import per_distance, resolved
from aftdeck.kinematics.singular import closing
from aftdeck.law import law
from aftdeck.steering.blocks import LANES, PER, QUARTERS, put_six, put_three, replace_by_sines, sines_in, six, three
from aftdeck.steering.layout import DT, HIGH, LOW, MEASURED, MOST_UP, RATE, RATE_UP, RULES, SPEED, TURN
from aftdeck.steering.limiters import APPROACH, NEAREST, SLOWEST, Ratio, avclmt, braked, time_to_rest
from aftdeck.steering.msteer import NEAR_FLOOR
from aftdeck.steering.one_factor import NO_RATE, ROUNDING, UNBOUNDED, Range, of_point, one_factor
from aftdeck.steering.turn import from_orbiter
from aftdeck.steering.twist_change import greatest_share, joint_shares, rates_between, twist_between
from aftdeck.tuples import Six

JOINT_ANGLES, JOINT_RATES, TIP_TWIST, DEFLECTIONS = 0, 6, 12, 18
"""Rows of a block, six each: joint angles [rad], commanded joint rates [rad/s], commanded twist of the tip in L, and
sticks in [-1, 1]: rotation about the orbiter's axes, then translation along them."""
STICK_ROWS = 24
"""Number of rows of a block that this module uses; a caller's own rows may follow."""

DEMANDED, RATES_AT_ONE, KEPT, SHARE, LEAST, GREATEST = (
    QUARTERS + 6,
    QUARTERS + 12,
    QUARTERS + 18,
    QUARTERS + 24,
    QUARTERS + 25,
    QUARTERS + 26,
)
"""Rows of the work array: twist that is demanded (6), its joint rates (6), the rates that keep the present twist (6),
RATLMT's ratio or the share of the change, and a range of factors."""
STICK_WORK = QUARTERS + 27
"""Number of rows of the work array."""

HARD_LOW, HARD_HIGH = RULES, RULES + 6
"""Hard stops in the constants, (6,) each [rad]; the constants before them are the rules (`steering/layout.py`)."""
CONSTANTS = RULES + 12
"""Number of constants."""


class JointLimits(NamedTuple):
    """Limits of one joint: greatest rate [rad/s], deceleration before a stop [rad/s2] and soft stops [rad].

    `change` is the greatest change of the rate in a step [rad/s].
    """

    rate: float
    braking: float
    change: float
    low: float
    high: float


@law
def _limits(c: Floats, i: int) -> JointLimits:
    """Return the limits of joint i."""
    return JointLimits(c[RATE + i], c[RATE_UP + i], c[MOST_UP + i] * c[DT], c[LOW + i], c[HIGH + i])


@law
def _joint_share(limits: JointLimits, dt: float, per_second: float, rate: float, angle: float) -> float:
    """Return the share of a joint's rate that `limiters.joint_ratio` allows, 0 to 1."""
    gap = limits.high - angle if rate > 0.0 else angle - limits.low
    most = min(limits.rate, braked(gap, min(limits.braking, per_second * max(abs(rate), SLOWEST)), dt))
    return most / abs(rate) if abs(rate) > most * (1.0 + 1e-12) else 1.0


@law
def _singularity_share(c: Floats, a: Sines, rates: Rates, which: int) -> float:
    """Return the share of the rates that `limiters.singularity_ratio` allows before one singularity, 0 to 1."""
    distance, towards = closing(c, a, rates, which)
    allowed = APPROACH * max(abs(distance) - NEAREST, 0.0)
    return allowed / towards if towards > allowed * (1.0 + 1e-12) + 1e-12 else 1.0


@law
def _ratio(c: Floats, joints: tuple[JointLimits, ...], a: Sines, r: Rates, q: Six) -> float:
    """Return RATLMT's ratio of joint rates, as `limiters.ratlmt` computes it."""
    dt, per_second = c[DT], 1.0 / time_to_rest(c, r)
    joint_share = min(
        _joint_share(joints[0], dt, per_second, r.r1, q[0]),
        _joint_share(joints[1], dt, per_second, r.r2, q[1]),
        _joint_share(joints[2], dt, per_second, r.r3, q[2]),
        _joint_share(joints[3], dt, per_second, r.r4, q[3]),
        _joint_share(joints[4], dt, per_second, r.r5, q[4]),
        _joint_share(joints[5], dt, per_second, r.r6, q[5]),
    )
    return min(
        joint_share, _singularity_share(c, a, r, 0), _singularity_share(c, a, r, 1), _singularity_share(c, a, r, 2)
    )


@law
def _factors(change: float, rate: float, measured: float) -> Range:
    """Return the range of factors that a joint's acceleration limit allows, as `one_factor` computes it."""
    speed, now, change = abs(rate), math.copysign(1.0, rate) * measured, change * (1.0 + ROUNDING)
    low = (now - change) / speed if speed > NO_RATE else (UNBOUNDED if abs(now) > change else -UNBOUNDED)
    high = (now + change) / speed if speed > NO_RATE else UNBOUNDED
    return Range(low, high)


@law
def _range(joints: tuple[JointLimits, ...], r: Rates, measured: Six) -> Range:
    """Return the range of factors that the acceleration limits of all joints allow."""
    f1, f2 = _factors(joints[0].change, r.r1, measured[0]), _factors(joints[1].change, r.r2, measured[1])
    f3, f4 = _factors(joints[2].change, r.r3, measured[2]), _factors(joints[3].change, r.r4, measured[3])
    f5, f6 = _factors(joints[4].change, r.r5, measured[4]), _factors(joints[5].change, r.r6, measured[5])
    low = max(f1.low, f2.low, f3.low, f4.low, f5.low, f6.low)
    high = min(f1.high, f2.high, f3.high, f4.high, f5.high, f6.high)
    return Range(low, high)


@law
def _share_of_change(joints: tuple[JointLimits, ...], before: Rates, after: Rates, measured: Six) -> float:
    """Return the share of a change that `twist_change.share_of_change` allows, 0 to 1."""
    s1 = joint_shares(joints[0].change, before.r1, after.r1, measured[0])
    s2 = joint_shares(joints[1].change, before.r2, after.r2, measured[1])
    s3 = joint_shares(joints[2].change, before.r3, after.r3, measured[2])
    s4 = joint_shares(joints[3].change, before.r4, after.r4, measured[3])
    s5 = joint_shares(joints[4].change, before.r5, after.r5, measured[4])
    s6 = joint_shares(joints[5].change, before.r6, after.r6, measured[5])
    low = max(-UNBOUNDED, s1.low, s2.low, s3.low, s4.low, s5.low, s6.low)
    return greatest_share(low, min(UNBOUNDED, s1.high, s2.high, s3.high, s4.high, s5.high, s6.high))


@law
def _moved(low: float, high: float, angle: float, step: float) -> float:
    """Return a joint's angle after a step, which a hard stop can end (`plant.kinematic.follow`)."""
    return min(max(angle + step, min(low, angle)), max(high, angle))


@law
def _within(value: float, most: float) -> float:
    return min(max(value, -most), most)


@law
def sines_at_angles(c: Floats, block: Array, work: Array, ahead: float) -> None:
    """Write into `work` the sines and cosines of all link angles, a time `ahead` [s] later at the present rates."""
    for i in range(LANES):
        q, r = six(block, JOINT_ANGLES, i), six(block, JOINT_RATES, i)
        angles = link_angles(
            c,
            q[0] + ahead * r[0],
            q[1] + ahead * r[1],
            q[2] + ahead * r[2],
            q[3] + ahead * r[3],
            q[4] + ahead * r[4],
            q[5] + ahead * r[5],
        )
        put_six(work, 0, i, angles)
    replace_by_sines(work)


@law
def steer_by_sticks(c: Floats, rules: Array, block: Array, work: Array, scratch: Array) -> None:
    """Make one control step of a block.

    Args:
        c: (CONSTANTS,) the rules of ORB UNL, then the hard stops, as a tuple.
        rules: (RULES,) the same rules as an array, for the arms that need `one_factor`'s search.
        block: (rows * LANES,) the block, row by row; updated in place.
        work: (STICK_WORK * LANES,) overwritten.
        scratch: (STATE,) overwritten.
    """
    joints = (_limits(c, 0), _limits(c, 1), _limits(c, 2), _limits(c, 3), _limits(c, 4), _limits(c, 5))
    sines_at_angles(c, block, work, 0.5 * c[DT])
    for i in range(LANES):
        put_three(work, PER, i, per_distance(c, sines_in(work, i), NEAR_FLOOR))
    for i in range(LANES):
        wx, wy, wz, vx, vy, vz = six(block, DEFLECTIONS, i)
        w, v = c[TURN], c[SPEED]
        p, q, r = from_orbiter(c, w * wx, w * wy, w * wz)
        x, y, z = from_orbiter(c, v * vx, v * vy, v * vz)
        twist = Twist(p, q, r, x, y, z)
        put_six(work, DEMANDED, i, twist)
        put_six(work, RATES_AT_ONE, i, resolved(c, sines_in(work, i), twist, three(work, PER, i)))
    for i in range(LANES):
        rates, angles = _rates(work, RATES_AT_ONE, i), six(block, JOINT_ANGLES, i)
        work[SHARE * LANES + i] = _ratio(c, joints, sines_in(work, i), rates, angles)
    for i in range(LANES):
        k, t = work[SHARE * LANES + i], _twist(work, DEMANDED, i)
        t = Twist(k * t.wx, k * t.wy, k * t.wz, k * t.vx, k * t.vy, k * t.vz)
        twist, _ = avclmt(c, t, _twist(block, TIP_TWIST, i))
        put_six(work, DEMANDED, i, twist)
    for i in range(LANES):
        twist = _twist(work, DEMANDED, i)
        put_six(work, RATES_AT_ONE, i, resolved(c, sines_in(work, i), twist, three(work, PER, i)))
    for i in range(LANES):
        present = _twist(block, TIP_TWIST, i)
        put_six(work, KEPT, i, resolved(c, sines_in(work, i), present, three(work, PER, i)))
    for i in range(LANES):
        kept, rates = _rates(work, KEPT, i), _rates(work, RATES_AT_ONE, i)
        work[SHARE * LANES + i] = _share_of_change(joints, kept, rates, six(block, JOINT_RATES, i))
    for i in range(LANES):
        kept, rates = _rates(work, KEPT, i), _rates(work, RATES_AT_ONE, i)
        put_six(work, RATES_AT_ONE, i, rates_between(kept, rates, work[SHARE * LANES + i]))
    for i in range(LANES):
        present, twist = _twist(block, TIP_TWIST, i), _twist(work, DEMANDED, i)
        put_six(work, DEMANDED, i, twist_between(present, twist, work[SHARE * LANES + i]))
    for i in range(LANES):
        rates, angles = _rates(work, RATES_AT_ONE, i), six(block, JOINT_ANGLES, i)
        work[SHARE * LANES + i] = _ratio(c, joints, sines_in(work, i), rates, angles)
    for i in range(LANES):
        allowed = _range(joints, _rates(work, RATES_AT_ONE, i), six(block, JOINT_RATES, i))
        work[LEAST * LANES + i] = max(allowed.low, 0.0)
        work[GREATEST * LANES + i] = min(allowed.high, work[SHARE * LANES + i])
    conflicts = 0
    for i in range(LANES):
        low, high = work[LEAST * LANES + i], work[GREATEST * LANES + i]
        conflicts += 1 if low > high else 0
        por = of_point(c, _twist(work, DEMANDED, i), _twist(block, TIP_TWIST, i))
        work[GREATEST * LANES + i] = max(min(high, por.high), low)
        work[LEAST * LANES + i] = 1.0 if low > high else 0.0
    if conflicts > 0:
        _resolve_conflicts(rules, block, work, scratch)
    _move(c, block, work)


@law
def _rates(rows: Array, first: int, i: int) -> Rates:
    r1, r2, r3, r4, r5, r6 = six(rows, first, i)
    return of_six(r1, r2, r3, r4, r5, r6)


@law
def _twist(rows: Array, first: int, i: int) -> Twist:
    wx, wy, wz, vx, vy, vz = six(rows, first, i)
    return Twist(wx, wy, wz, vx, vy, vz)


@law
def _resolve_conflicts(rules: Array, block: Array, work: Array, scratch: Array) -> None:
    """Compute the factor of each arm whose limits have no factor in common by `one_factor`, which then searches."""
    for i in range(LANES):
        if work[LEAST * LANES + i] != 0.0:
            for joint in range(6):
                scratch[MEASURED + joint] = block[(JOINT_RATES + joint) * LANES + i]
            share = work[SHARE * LANES + i]
            limit = Ratio(share, 1 if share < 1.0 else 0, -1)
            demanded, present = _twist(work, DEMANDED, i), _twist(block, TIP_TWIST, i)
            result = one_factor(rules, scratch, _rates(work, RATES_AT_ONE, i), demanded, present, limit)
            work[GREATEST * LANES + i] = result.factor


@law
def _move(c: Floats, block: Array, work: Array) -> None:
    """Command the rates times the factor, and move the joints for one control period."""
    for i in range(LANES):
        k, r = work[GREATEST * LANES + i], _rates(work, RATES_AT_ONE, i)
        put_six(
            block,
            JOINT_RATES,
            i,
            (
                _within(k * r.r1, c[RATE]),
                _within(k * r.r2, c[RATE + 1]),
                _within(k * r.r3, c[RATE + 2]),
                _within(k * r.r4, c[RATE + 3]),
                _within(k * r.r5, c[RATE + 4]),
                _within(k * r.r6, c[RATE + 5]),
            ),
        )
    for i in range(LANES):
        k, t = work[GREATEST * LANES + i], six(work, DEMANDED, i)
        put_six(block, TIP_TWIST, i, (k * t[0], k * t[1], k * t[2], k * t[3], k * t[4], k * t[5]))
    for i in range(LANES):
        q, rates, dt = six(block, JOINT_ANGLES, i), six(block, JOINT_RATES, i), c[DT]
        put_six(
            block,
            JOINT_ANGLES,
            i,
            (
                _moved(c[HARD_LOW], c[HARD_HIGH], q[0], rates[0] * dt),
                _moved(c[HARD_LOW + 1], c[HARD_HIGH + 1], q[1], rates[1] * dt),
                _moved(c[HARD_LOW + 2], c[HARD_HIGH + 2], q[2], rates[2] * dt),
                _moved(c[HARD_LOW + 3], c[HARD_HIGH + 3], q[3], rates[3] * dt),
                _moved(c[HARD_LOW + 4], c[HARD_HIGH + 4], q[4], rates[4] * dt),
                _moved(c[HARD_LOW + 5], c[HARD_HIGH + 5], q[5], rates[5] * dt),
            ),
        )
