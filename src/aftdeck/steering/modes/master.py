"""Master arm: the arm follows six joint angles, those of a small arm that the operator moves.

Inputs: the master's six angles, from sliders or a device, at any time. At the entry of the mode the master has the
arm's angles.
Limits: each joint's coarse or vernier rate, ramped, and lower with a payload; soft stops: a joint moves up to its stop
if the master is beyond the stop, and a joint that is past its stop can only move back. Singularities and the limits of
the tip do not act, because the mode demands no twist of the tip.
Ends: when the operator leaves it; each joint comes to rest at its master's angle without passing it.
Source: Remote Manipulator Simulation, final report: the slave follows the six angles of a master arm. The rates and
the smooth arrival are ours.
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Rates
from aftdeck.law import law
from aftdeck.steering.layout import ANGLES, ARRIVED, CAUSE, DT, HIGH, LIMITING_JOINT, LOW, MASTER, RATE, RATE_UP, RATES
from aftdeck.steering.limiters import BY_STOP, braked
from aftdeck.steering.ramp import ramped, rate_towards
from aftdeck.steering.views import rates_at

THERE = 1e-9
"""A joint has arrived if its distance from its target angle, and its motion in one step, are at most this [rad]."""


@law
def _goal(rules: Array, command: Array, state: Array, i: int) -> float:
    """Return the target angle of joint i [rad]: the master's angle within the stops, or the present angle past one."""
    angle = state[ANGLES + i]
    return float(min(max(command[MASTER + i], min(rules[LOW + i], angle)), max(rules[HIGH + i], angle)))


@law
def rates(rules: Array, command: Array, state: Array, report: Array) -> Rates:
    """Return this step's joint rates [rad/s]; write them into the state, acting stops and arrival into the report."""
    there = 1.0
    for i in range(6):
        goal = _goal(rules, command, state, i)
        rate = ramped(rules, state, report, rate_towards(rules, state, goal, i), i, BY_STOP)
        left = abs(goal - state[ANGLES + i])
        if goal != command[MASTER + i] and braked(left, rules[RATE_UP + i], rules[DT]) < rules[RATE + i]:
            report[CAUSE], report[LIMITING_JOINT] = BY_STOP, i
        if left > THERE or abs(rate) * rules[DT] > THERE:
            there = 0.0
        state[RATES + i] = rate
    report[ARRIVED] = there
    return rates_at(state, RATES)
