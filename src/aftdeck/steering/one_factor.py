"""One factor that slows a whole motion, so that limits change the speed but not the path.

Modes 1 and 3 follow a plan, and mode 2 follows the line to its target. Different factors for translation and rotation
would take the arm off this path. Here every limit gives a range of allowed factors. The greatest factor that is in all
ranges is used. If the ranges have no factor in common, the limits have this priority:

1. Joint rates, stops and singularities (RATLMT). These limits are never exceeded.
2. Joint accelerations. If every factor exceeds the acceleration limit of some joint, the arm stays on the path, and the
   joint is reported.
3. Accelerations of the point of resolution. These limits are exceeded if limits 1 or 2 require it.

JSC-12628 does not have this factor: its AVCLMT and RATLMT limit translation, rotation and joint rates separately.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Rates, Twist
from aftdeck.kinematics.linkage import Floats
from aftdeck.law import law
from aftdeck.steering.layout import DT, JOINTS, MEASURED, MOST_UP, SPEED, SPEED_UP, TURN, TURN_UP
from aftdeck.steering.limiters import BY_ACCELERATION, Ratio

ROUNDING = 1e-11
"""Share of a limit by which rounding may exceed the limit [1]."""
NO_RATE = 1e-12
"""Demanded joint rate [rad/s] up to which the demand counts as zero: no factor changes such a joint's acceleration."""
SEARCHES = 60
"""Number of steps in the search for the factor of `_least_excess`; each step reduces the range to two thirds."""
UNBOUNDED = 1e9
"""Factor that represents the absence of a limit [1]."""


class Factor(NamedTuple):
    """Share of a motion that is commanded, and the limits that act.

    Attributes:
        factor: share that is commanded, 0 to 1.
        cause: index in `limiters.CAUSES`; 0 if none of these limits acts.
        culprit: the joint, or the singularity (`ArmModel.singularities`); -1 if `cause` is 0.
        por_cause: limit of the point of resolution, as `limiters.avclmt` numbers it; 0 if none acts.
    """

    factor: float
    cause: int
    culprit: int
    por_cause: int


class Range(NamedTuple):
    """Range of factors that a limit allows, from `low` to `high`. If `low` is above `high`, no factor is allowed."""

    low: float
    high: float


@law
def one_factor(rules: Array, state: Array, rates: Rates, twist: Twist, present: Twist, limit: Ratio) -> Factor:
    """Return the greatest factor of a motion that keeps every limit, and the limits that act.

    Args:
        rules: rules of the mode.
        state: state with the measured joint rates.
        rates: joint rates of the motion at a factor of 1 [rad/s].
        twist: twist of the point of resolution at a factor of 1.
        present: present twist of the point of resolution.
        limit: RATLMT's ratio of `rates`.
    """
    most, cause, culprit, por_cause = limit.ratio, limit.cause, limit.culprit, 0
    joints, slowest, quickest = _of_joints(rules, state, rates)
    low, high = max(joints.low, 0.0), min(joints.high, most)
    if low > high:
        if limit.cause != 0 and _excess(rules, state, rates, most)[0] <= _excess(rules, state, rates, 0.99 * most)[0]:
            # a stop, a singularity or a rate limit requires more than the maximum joint deceleration
            return Factor(most, cause, culprit, 0)
        factor = _least_excess(rules, state, rates, most)
        excess, joint = _excess(rules, state, rates, factor)
        if excess > 1.0 + ROUNDING:
            return Factor(factor, BY_ACCELERATION, joint, 0)
        low = high = factor
    if high < most:
        cause, culprit = BY_ACCELERATION, slowest
    por = of_point(rules, twist, present)
    factor = max(min(high, por.high), low)
    if factor < high:
        cause, culprit, por_cause = 0, -1, por.cause
        if factor > por.high:  # the joints cannot slow down as quickly as the point's limit requires
            cause, culprit = BY_ACCELERATION, quickest
    return Factor(factor, cause, culprit, por_cause)


class PointRange(NamedTuple):
    """Greatest factor that the limits of the point of resolution allow, and the number of the limit that gives it."""

    high: float
    cause: int


@law
def of_point(rules: Floats, twist: Twist, present: Twist) -> PointRange:
    """Return the greatest factor that the point's limits allow.

    A speed limit never requires more than the maximum deceleration.
    """
    dt = rules[DT]
    v = math.sqrt(twist.vx * twist.vx + twist.vy * twist.vy + twist.vz * twist.vz)
    w = math.sqrt(twist.wx * twist.wx + twist.wy * twist.wy + twist.wz * twist.wz)
    speed = _of_vector(twist.vx, twist.vy, twist.vz, present.vx, present.vy, present.vz, rules[SPEED_UP] * dt)
    turn = _of_vector(twist.wx, twist.wy, twist.wz, present.wx, present.wy, present.wz, rules[TURN_UP] * dt)
    most, cause = 1.0, 0
    if v > rules[SPEED] * (1.0 + ROUNDING):
        most, cause = rules[SPEED] / v, 2
    if most * w > rules[TURN] * (1.0 + ROUNDING):
        most, cause = rules[TURN] / w, 8
    most = max(most, min(1.0, max(speed.low, turn.low)))
    if min(speed.high, turn.high) < most:
        most, cause = min(speed.high, turn.high), 1 if speed.high <= turn.high else 4
    return PointRange(most, cause)


@law
def _of_joints(rules: Array, state: Array, rates: Rates) -> tuple[Range, int, int]:
    """Return the range of factors that all joint acceleration limits allow, and the joints that set its ends.

    Returns:
        The range, the joint that sets `high`, and the joint that sets `low`; -1 for an end that no joint sets.
    """
    low, high, slowest, quickest = -UNBOUNDED, UNBOUNDED, -1, -1
    for i in range(int(rules[JOINTS])):
        change = rules[MOST_UP + i] * rules[DT] * (1.0 + ROUNDING)
        rate, now = abs(rates[i]), math.copysign(1.0, rates[i]) * state[MEASURED + i]
        if rate > NO_RATE:
            if (now - change) / rate > low:
                low, quickest = (now - change) / rate, i
            if (now + change) / rate < high:
                high, slowest = (now + change) / rate, i
        elif abs(now) > change:
            low, quickest = UNBOUNDED, i
    return Range(low, high), slowest, quickest


@law
def _of_vector(x: float, y: float, z: float, px: float, py: float, pz: float, change: float) -> Range:
    """Return the range of factors for which (x, y, z) times the factor differs from (px, py, pz) by at most `change`.

    If every factor gives a greater difference, both ends of the range are the factor with the least difference.
    """
    square = x * x + y * y + z * z
    if square < NO_RATE * NO_RATE:
        return Range(-UNBOUNDED, UNBOUNDED)
    along = (x * px + y * py + z * pz) / square
    limit = change * (1.0 + ROUNDING)
    under = along * along - (px * px + py * py + pz * pz - limit * limit) / square
    half = math.sqrt(max(under, 0.0))
    return Range(along - half, along + half)


@law
def _excess(rules: Array, state: Array, rates: Rates, factor: float) -> tuple[float, int]:
    """Return, for a factor, the greatest ratio of a joint acceleration to its limit [1], and the joint concerned."""
    greatest, joint = 0.0, -1
    for i in range(int(rules[JOINTS])):
        share = abs(factor * rates[i] - state[MEASURED + i]) / (rules[MOST_UP + i] * rules[DT])
        if share > greatest:
            greatest, joint = share, i
    return greatest, joint


@law
def _least_excess(rules: Array, state: Array, rates: Rates, most: float) -> float:
    """Return the factor, 0 to `most`, with the least value of `_excess`."""
    low, high = 0.0, most
    for _ in range(SEARCHES):
        third = (high - low) / 3.0
        if _excess(rules, state, rates, low + third)[0] <= _excess(rules, state, rates, high - third)[0]:
            high -= third
        else:
            low += third
    return 0.5 * (low + high)
