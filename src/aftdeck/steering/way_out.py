"""Escape direction: stick direction that leads out of a singularity or away from a stop.

For each of the 12 directions of the six stick axes, these laws compute the joint rates after RMSRAT and RATLMT. From
these rates they compute the speed at which the arm leaves the singularity or the stop. If no stick direction leads
away, the escape direction is a motion of one joint in SINGLE.
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Rates
from aftdeck.kinematics.linkage import Tip
from aftdeck.kinematics.solver import Posture, closing, rates_of, tip_of
from aftdeck.law import law
from aftdeck.steering.layout import JOINTS, STICKS
from aftdeck.steering.limiters import ratlmt
from aftdeck.steering.modes import manual
from aftdeck.steering.msteer import NEAR_FLOOR, carried_to_tip
from aftdeck.steering.views import posture_now

DIRECTIONS = 12
"""Number of stick directions: + and - of roll, pitch, yaw, X, Y, Z, in that order."""


@law
def way_out(
    rules: Array, command: Array, state: Array, singularity: int, joint: int, inward: float, speeds: Array
) -> None:
    """Write into `speeds` the speed at which each stick direction leads away from a singularity or a limit.

    Args:
        rules: rules of a manual mode.
        command: command whose law is used; its sticks are overwritten.
        state: state of the arm.
        singularity: a singularity (`ArmModel.singularities`); `speeds` are the rates at which its distance grows
            [1/s]. If `singularity` is -1, `joint` and `inward` apply instead.
        joint: joint at its limit; `speeds` are its rates [rad/s].
        inward: sign, +1 or -1, of the joint's rate that leads away from its limit.
        speeds: (12,) output, one speed for each stick direction; positive if the direction leads away.
    """
    a = posture_now(rules, state)
    here = tip_of(rules, a)
    for k in range(DIRECTIONS):
        rates = _stick_rates(rules, command, a, here, k)
        ratio = ratlmt(rules, state, a, rates).ratio
        if singularity >= 0:
            speeds[k] = -ratio * closing(rules, a, rates, singularity)[1]
        else:
            speeds[k] = ratio * inward * rates[joint]


@law
def _stick_rates(rules: Array, command: Array, a: Posture, here: Tip, k: int) -> Rates:
    """Return the joint rates that stick direction k demands, before limits."""
    for i in range(6):
        command[STICKS + i] = 0.0
    command[STICKS + k // 2] = 1.0 if k % 2 == 0 else -1.0
    demanded = manual.demand(rules, command, here)
    return rates_of(rules, a, carried_to_tip(rules, here, demanded), NEAR_FLOOR)


@law
def stick_rates(rules: Array, command: Array, state: Array, speeds: Array) -> None:
    """Write the joint rates of each stick direction, after limits, into `speeds` (12, n) [rad/s].

    See `way_out` for the other arguments.
    """
    a = posture_now(rules, state)
    here = tip_of(rules, a)
    for k in range(DIRECTIONS):
        rates = _stick_rates(rules, command, a, here, k)
        ratio = ratlmt(rules, state, a, rates).ratio
        for i in range(int(rules[JOINTS])):
            speeds[k, i] = ratio * rates[i]
