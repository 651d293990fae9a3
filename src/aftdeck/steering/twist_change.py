"""Limits on the change of the point's twist in one step.

AVCLMT limits the accelerations of translation and rotation. Mode 2 has a line to keep: its change keeps both in
proportion. The manual modes have none, but near a singularity a change of the twist by a few millimetres a second
changes some joint rates by many times their acceleration limits. The arm therefore makes only a share of the change:
the greatest one that keeps every joint within its acceleration limit. JSC-12628 has no such limits.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Rates, Twist
from aftdeck.kinematics.linkage import Floats
from aftdeck.law import law
from aftdeck.steering.layout import DT, JOINTS, MEASURED, MOST_UP, SPEED_UP, TURN_UP
from aftdeck.steering.limiters import avclmt
from aftdeck.steering.one_factor import NO_RATE, UNBOUNDED, Range, of_point

INEXACT = 1e-7
"""Share of an acceleration limit by which the factor of `of_point` may exceed it: a root of a small difference [1]."""


class Share(NamedTuple):
    """Share of a change that is made, 0 to 1, and the joint whose acceleration limits it; -1 if none does."""

    share: float
    joint: int


@law
def in_proportion(rules: Floats, demanded: Twist, present: Twist) -> tuple[Twist, int]:
    """Return the twist that AVCLMT's limits allow, by one factor for translation and rotation if one factor suffices.

    Separate limits let the motion with the smaller demand reach its full rate first. Translation and rotation are then
    not in the demanded proportion, and the arm leaves its path. If no factor keeps the limits, because the direction
    has changed, AVCLMT limits translation and rotation separately.

    Returns:
        The allowed twist, and the limits that acted, as `limiters.avclmt` numbers them.
    """
    point = of_point(rules, demanded, present)
    k = max(point.high, 0.0)
    d = Twist(k * demanded.wx, k * demanded.wy, k * demanded.wz, k * demanded.vx, k * demanded.vy, k * demanded.vz)
    turn = _length(d.wx - present.wx, d.wy - present.wy, d.wz - present.wz)
    speed = _length(d.vx - present.vx, d.vy - present.vy, d.vz - present.vz)
    most = rules[DT] * (1.0 + INEXACT)
    if turn <= rules[TURN_UP] * most and speed <= rules[SPEED_UP] * most:
        return d, point.cause
    return avclmt(rules, demanded, present)


@law
def _length(x: float, y: float, z: float) -> float:
    return math.sqrt(x * x + y * y + z * z)


@law
def share_of_change(rules: Array, state: Array, before: Rates, after: Rates) -> Share:
    """Return the greatest share of a change of the joint rates that keeps every joint acceleration limit.

    Args:
        rules: rules of the mode.
        state: state with the rates from which the accelerations count.
        before: joint rates that keep the present twist at the arm's new angles [rad/s].
        after: joint rates of the changed twist [rad/s].
    """
    low, high, joint = -UNBOUNDED, UNBOUNDED, -1
    for i in range(int(rules[JOINTS])):
        one = joint_shares(rules[MOST_UP + i] * rules[DT], before[i], after[i], state[MEASURED + i])
        low = max(low, one.low)
        if one.high < high:
            high, joint = one.high, i
    share = greatest_share(low, high)
    return Share(share, joint if share < 1.0 else -1)


@law
def joint_shares(change: float, before: float, after: float, now: float) -> Range:
    """Return the range of shares for which a joint's rate differs from `now` by at most `change`; see above."""
    step, drift = after - before, before - now
    changes = abs(step) > NO_RATE
    divisor = step if changes else 1.0
    one, other = (-change - drift) / divisor, (change - drift) / divisor
    return Range(min(one, other) if changes else -UNBOUNDED, max(one, other) if changes else UNBOUNDED)


@law
def greatest_share(low: float, high: float) -> float:
    """Return the greatest share, 0 to 1, in a range; if the range is empty, the share in the middle of its ends."""
    return min(max(high if low <= high else 0.5 * (low + high), 0.0), 1.0)


@law
def between(before: float, after: float, share: float) -> float:
    """Return `before` plus a share of the change to `after`; exactly `after` if the share is 1."""
    return after - (1.0 - share) * (after - before)


@law
def rates_between(before: Rates, after: Rates, share: float) -> Rates:
    """Return joint rates that make a share of the change from `before` to `after`."""
    return Rates(
        between(before.r1, after.r1, share),
        between(before.r2, after.r2, share),
        between(before.r3, after.r3, share),
        between(before.r4, after.r4, share),
        between(before.r5, after.r5, share),
        between(before.r6, after.r6, share),
        between(before.r7, after.r7, share),
        between(before.r8, after.r8, share),
    )


@law
def twist_between(before: Twist, after: Twist, share: float) -> Twist:
    """Return a twist that makes a share of the change from `before` to `after`."""
    return Twist(
        between(before.wx, after.wx, share),
        between(before.wy, after.wy, share),
        between(before.wz, after.wz, share),
        between(before.vx, after.vx, share),
        between(before.vy, after.vy, share),
        between(before.vz, after.vz, share),
    )
