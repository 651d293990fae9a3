"""One factor for a whole motion, so that what limits it changes neither its line nor its proportions.

Modes 1 and 3 fly a plan: cut by different factors, translation and rotation would leave it. Here every limit gives a
range of factors, and the greatest factor that all of them take is flown. Joint rates, stops and singularities (RATLMT)
are never passed; joint accelerations come next; the accelerations of the point of resolution last, which are passed
where the joints demand it. Where no factor keeps a joint's acceleration, the line is kept and the joint is named.

Not in JSC-12628, whose AVCLMT and RATLMT cut translation, rotation and joint rates one after the other.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Rates, Twist
from aftdeck.law import law
from aftdeck.steering.layout import DT, MEASURED, MOST_UP, SPEED, SPEED_UP, TURN, TURN_UP
from aftdeck.steering.limiters import BY_ACCELERATION, PAST_ACCELERATION, Ratio

ROUNDING = 1e-11
"""Share by which rounding may pass a limit [1]."""
NO_RATE = 1e-12
"""A joint rate that no factor changes [rad/s]."""
SEARCHES = 60
"""Steps of the search for the factor that passes a joint's acceleration least: each leaves two thirds."""
UNBOUNDED = 1e9
"""A factor that stands for any factor [1]."""


class Factor(NamedTuple):
    """How much of a motion is flown, and which limits held it back.

    Attributes:
        factor: 0 to 1.
        cause: a number of `limiters.CAUSES`; 0 where nothing limits.
        culprit: the joint, or for a singularity 0 shoulder, 1 elbow, 2 wrist; -1 where nothing limits.
        por_cause: limits of the point of resolution, numbered as `limiters.avclmt` numbers them.
    """

    factor: float
    cause: int
    culprit: int
    por_cause: int


class Range(NamedTuple):
    """Factors that a limit takes, from `low` to `high`; none where `low` is the greater."""

    low: float
    high: float


@law
def one_factor(rules: Array, state: Array, rates: Rates, twist: Twist, present: Twist, limit: Ratio) -> Factor:
    """Return the factor of a motion that keeps every limit, and what holds it back.

    Args:
        rules: of the mode.
        state: with the measured joint rates.
        rates: joint rates of the whole motion [rad/s].
        twist: its twist of the point of resolution.
        present: the twist of that point now.
        limit: RATLMT's ratio of `rates`.
    """
    most, cause, culprit, por_cause = limit.ratio, limit.cause, limit.culprit, 0
    joints, slowest, quickest = _of_joints(rules, state, rates)
    low, high = max(joints.low, 0.0), min(joints.high, most)
    if low > high:
        if limit.cause != 0 and _excess(rules, state, rates, most)[0] <= _excess(rules, state, rates, 0.99 * most)[0]:
            return Factor(most, cause, culprit, 0)  # a stop, a singularity or a rate limit stops the joints so quickly
        factor = _least_excess(rules, state, rates, most)
        excess, joint = _excess(rules, state, rates, factor)
        if excess > 1.0 + ROUNDING:
            return Factor(factor, PAST_ACCELERATION, joint, 0)
        low = high = factor
    if high < most:
        cause, culprit = BY_ACCELERATION, slowest
    por = _of_point(rules, twist, present)
    factor = max(min(high, por.high), low)
    if factor < high:
        cause, culprit, por_cause = 0, -1, por.cause
        if factor > por.high:  # the joints do not stop as quickly as the point could
            cause, culprit = BY_ACCELERATION, quickest
    return Factor(factor, cause, culprit, por_cause)


class PointRange(NamedTuple):
    """The greatest factor that the limits of the point of resolution take, and which of them gives it."""

    high: float
    cause: int


@law
def _of_point(rules: Array, twist: Twist, present: Twist) -> PointRange:
    """Return what the point's greatest speeds and accelerations take: speed falls no faster than they permit."""
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
    """Return the factors that all joint accelerations take, and the joints that give the greatest and the least."""
    low, high, slowest, quickest = -UNBOUNDED, UNBOUNDED, -1, -1
    for i in range(6):
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
    """Return the factors of a vector that lie within `change` of the present one; the nearest where none does."""
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
    """Return the greatest joint acceleration over its limit [1] with this factor, and whose it is."""
    greatest, joint = 0.0, -1
    for i in range(6):
        share = abs(factor * rates[i] - state[MEASURED + i]) / (rules[MOST_UP + i] * rules[DT])
        if share > greatest:
            greatest, joint = share, i
    return greatest, joint


@law
def _least_excess(rules: Array, state: Array, rates: Rates, most: float) -> float:
    """Return the factor, at most `most`, with which joint accelerations are passed least."""
    low, high = 0.0, most
    for _ in range(SEARCHES):
        third = (high - low) / 3.0
        if _excess(rules, state, rates, low + third)[0] <= _excess(rules, state, rates, high - third)[0]:
            high -= third
        else:
            low += third
    return 0.5 * (low + high)
