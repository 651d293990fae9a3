"""Joint rates in mode 8 and MASTER: ramps to a rate or an angle, within the acceleration limit and the stops."""

from __future__ import annotations

import math

from aftdeck.arrays import Array
from aftdeck.law import law
from aftdeck.steering.layout import AIMS, CAUSE, DT, HIGH, LIMITING_JOINT, LOW, MEASURED, RATE, RATE_UP, RATIO
from aftdeck.steering.limiters import braked


@law
def rate_towards(rules: Array, state: Array, goal: float, i: int) -> float:
    """Return the greatest rate [rad/s] towards the angle `goal` [rad] from which joint i can stop at `goal`.

    The result is at most the joint's rate limit.
    """
    angle = goal - state[AIMS + i]
    return math.copysign(min(braked(abs(angle), rules[RATE_UP + i], rules[DT]), rules[RATE + i]), angle)


@law
def ramped(rules: Array, state: Array, report: Array, demanded: float, i: int, stop: int) -> float:
    """Return the rate of joint i [rad/s] in this step, as near the demanded rate as acceleration and stops allow.

    Args:
        rules: rules of the mode.
        state: measured angles and rates.
        report: receives cause and joint if a stop acts.
        demanded: the demanded rate [rad/s].
        i: the joint, from 0.
        stop: index in `limiters.CAUSES` that tells whether the stops in `rules` are soft or hard.
    """
    change, before = rules[RATE_UP + i] * rules[DT], state[MEASURED + i]
    rate = before + min(max(demanded - before, -change), change)
    gap = rules[HIGH + i] - state[AIMS + i] if rate > 0.0 else state[AIMS + i] - rules[LOW + i]
    allowed = braked(gap, rules[RATE_UP + i], rules[DT])
    if abs(rate) > allowed:
        report[RATIO] = min(report[RATIO], allowed / abs(rate))
        report[CAUSE], report[LIMITING_JOINT] = stop, i
        rate = math.copysign(allowed, rate)
    return float(min(max(rate, -rules[RATE + i]), rules[RATE + i]))
