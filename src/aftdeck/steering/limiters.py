"""AVCLMT and RATLMT: limits of the tip's twist and of the joint rates.

JSC-12628, subroutines AVCLMT and RATLMT. RATLMT's one ratio for all joints keeps the direction of motion. Here the
ratio also stops the joints before their stops and the arm before its singularities. Before a stop, the allowed rate is
proportional to the root of the remaining angle. Before a singularity, the allowed rate of approach is proportional to
the remaining distance. The arm therefore slows smoothly to rest.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.elementary import ceiling
from aftdeck.kinematics.jacobian import Rates, Twist
from aftdeck.kinematics.linkage import Floats
from aftdeck.kinematics.solver import Posture, closing, number_of_singularities
from aftdeck.law import law
from aftdeck.steering.layout import (
    ANGLES,
    AS_FLOWN,
    DT,
    GUARDED,
    HIGH,
    JOINTS,
    LOW,
    MOST_UP,
    RATE,
    RATE_UP,
    RATES,
    SPEED,
    SPEED_UP,
    STRICT,
    TOGETHER,
    TURN,
    TURN_UP,
)

CAUSES = ("", "joint rate", "soft stop", "singularity", "hard stop", "joint acceleration")
"""Limits that act on the joint rates; the index is the number in `report[CAUSE]`.

Number 4 occurs only in mode 8 and DIRECT, in which the hard stops are in force.
"""
BY_RATE, BY_STOP, BY_SINGULARITY, BY_HARD_STOP, BY_ACCELERATION = 1, 2, 3, 4, 5

NEAREST = 0.02
"""Normalised distance at which an approach to a singularity comes to rest (assumed); at the elbow, 1.1 deg."""
APPROACH = 0.5
"""Greatest rate of approach to a singularity, divided by the remaining distance [1/s] (assumed)."""
SLOWEST = 1e-9
"""Joint rate [rad/s] up to which a joint needs no time to come to rest."""
OUTSIDE = 1e-9
"""A joint counts as past a stop if its angle exceeds the stop by more than this value [rad]."""


@law
def rate_ratio(rules: Array, state: Array) -> float:
    """Return the largest ratio of a joint's commanded rate (magnitude) to the joint's rate limit in force."""
    greatest = 0.0
    for i in range(int(rules[JOINTS])):
        greatest = max(greatest, abs(state[RATES + i]) / rules[RATE + i])
    return greatest


class Ratio(NamedTuple):
    """Share of commanded rates that RATLMT allows, and the limit that acts.

    Attributes:
        ratio: allowed share, 0 to 1.
        cause: index in `CAUSES`; 0 if no limit acts.
        culprit: the joint, or the singularity (`ArmModel.singularities`); -1 if no limit acts.
    """

    ratio: float
    cause: int
    culprit: int


@law
def braked(gap: float, deceleration: float, dt: float) -> float:
    """Return the greatest rate that `deceleration` reduces to zero within `gap`, in steps of `dt`; 0 if gap <= 0.

    The motion takes n steps, which cover the gap exactly. The rate falls by deceleration * dt from each step to the
    next. In step n the rate is above zero and at most deceleration * dt.
    """
    if gap <= 0.0:
        return 0.0
    change = deceleration * dt
    n = max(ceiling(math.sqrt(0.25 + 2.0 * gap / (change * dt)) - 0.5), 1.0)
    return gap / (n * dt) + 0.5 * (n - 1.0) * change


@law
def avclmt(rules: Floats, demanded: Twist, present: Twist) -> tuple[Twist, int]:
    """Return the tip twist that the limits of speed and acceleration allow (AVCLMT).

    As published (`strict`), acceleration is limited first and speed second. The corrected version limits speed first.
    The results differ only if the present speed is above its limit, because the limit was just lowered. The published
    version then reduces the speed to the new limit in one step.

    Returns:
        The allowed twist, and the sum of the numbers of the limits that acted: 1 acceleration, 2 speed, 4 angular
        acceleration, 8 angular rate.
    """
    dt = rules[DT]
    wx, wy, wz, turn_active = _limited_vector(
        demanded.wx, demanded.wy, demanded.wz, present.wx, present.wy, present.wz,
        rules[TURN], rules[TURN_UP] * dt, rules[STRICT],
    )  # fmt: skip
    vx, vy, vz, speed_active = _limited_vector(
        demanded.vx, demanded.vy, demanded.vz, present.vx, present.vy, present.vz,
        rules[SPEED], rules[SPEED_UP] * dt, rules[STRICT],
    )  # fmt: skip
    return Twist(wx, wy, wz, vx, vy, vz), speed_active + 4 * turn_active


@law
def _limited_vector(
    x: float, y: float, z: float, px: float, py: float, pz: float, most: float, change: float, strict: float
) -> tuple[float, float, float, int]:
    """Return the vector (x, y, z) with limited length and limited change from (px, py, pz), and the active limits.

    The active limits are one number: 0 none, 1 the change, 2 the length, 3 both.
    """
    active = 0
    if strict == 0.0:
        k = _shortening_factor(x, y, z, most)
        active = _number_if_shortened(k, 2)
        x, y, z = k * x, k * y, k * z
    dx, dy, dz = x - px, y - py, z - pz
    k = _shortening_factor(dx, dy, dz, change)
    active += _number_if_shortened(k, 1)
    if k < 1.0:
        x, y, z = px + k * dx, py + k * dy, pz + k * dz
    if strict != 0.0:
        k = _shortening_factor(x, y, z, most)
        active += _number_if_shortened(k, 2)
        x, y, z = k * x, k * y, k * z
    return x, y, z, active


@law
def _number_if_shortened(shortening: float, number: int) -> int:
    """Return `number` if a shortening factor is below 1 by more than a rounding error, else 0."""
    return number if shortening < 1.0 - 1e-9 else 0


@law
def _shortening_factor(x: float, y: float, z: float, most: float) -> float:
    """Return the factor, at most 1, that reduces a vector's length to `most`."""
    length = math.sqrt(x * x + y * y + z * z)
    return most / length if length > most else 1.0


@law
def ratlmt(rules: Array, state: Array, a: Posture, rates: Rates) -> Ratio:
    """Return the ratio that reduces the commanded joint rates so that each is within its limit (RATLMT).

    If GUARDED is 1, the ratio also slows the arm before its singularities and, unless AS_FLOWN is 1, before its stops.
    The source limits rates only.
    """
    limit = joint_ratio(rules, state, rates)
    return singularity_ratio(rules, a, rates, limit) if rules[GUARDED] != 0.0 else limit


@law
def time_to_rest(rules: Floats, rates: Rates) -> float:
    """Return the shortest time [s] in which all joints come to rest together, within their acceleration limits."""
    return max(
        max(abs(rates.r1), SLOWEST) / rules[MOST_UP],
        max(abs(rates.r2), SLOWEST) / rules[MOST_UP + 1],
        max(abs(rates.r3), SLOWEST) / rules[MOST_UP + 2],
        max(abs(rates.r4), SLOWEST) / rules[MOST_UP + 3],
        max(abs(rates.r5), SLOWEST) / rules[MOST_UP + 4],
        max(abs(rates.r6), SLOWEST) / rules[MOST_UP + 5],
        max(abs(rates.r7), SLOWEST) / rules[MOST_UP + 6],
        max(abs(rates.r8), SLOWEST) / rules[MOST_UP + 7],
    )


@law
def joint_ratio(rules: Array, state: Array, rates: Rates) -> Ratio:
    """Return RATLMT's ratio for the joints' rate limits and, if GUARDED or AS_FLOWN is 1, for their stops.

    One ratio brings all joints to rest before a stop of one of them. This joint may be slow, and another one fast. If
    TOGETHER is 1, the deceleration before the stop is therefore so low that the other joints keep their limits.
    """
    ratio, cause, culprit = 1.0, 0, -1
    as_flown, guarded = rules[AS_FLOWN] != 0.0, rules[GUARDED] != 0.0
    per_second = 1.0 / time_to_rest(rules, rates) if rules[TOGETHER] != 0.0 else math.inf
    for i in range(int(rules[JOINTS])):
        rate, angle = rates[i], state[ANGLES + i]
        past = angle > rules[HIGH + i] + OUTSIDE or angle < rules[LOW + i] - OUTSIDE
        if as_flown and past:
            return Ratio(0.0, BY_STOP, i)
        most, here = rules[RATE + i], BY_RATE
        if guarded and not as_flown:
            gap = rules[HIGH + i] - angle if rate > 0.0 else angle - rules[LOW + i]
            allowed = braked(gap, min(rules[RATE_UP + i], per_second * max(abs(rate), SLOWEST)), rules[DT])
            if allowed < most:
                most, here = allowed, BY_STOP
        if abs(rate) > most * (1.0 + 1e-12):
            left = most / abs(rate)
            if left < ratio:
                ratio, cause, culprit = left, here, i
    return Ratio(ratio, cause, culprit)


@law
def singularity_ratio(rules: Array, a: Posture, rates: Rates, limit: Ratio) -> Ratio:
    """Return the ratio `limit`, or a smaller ratio that slows the arm before a singularity."""
    ratio, cause, culprit = limit.ratio, limit.cause, limit.culprit
    for k in range(number_of_singularities(rules)):
        distance, towards = closing(rules, a, rates, k)
        allowed = APPROACH * max(abs(distance) - NEAREST, 0.0)
        if towards > allowed * (1.0 + 1e-12) + 1e-12:
            left = allowed / towards
            if left < ratio:
                ratio, cause, culprit = left, BY_SINGULARITY, k
    return Ratio(ratio, cause, culprit)
