"""MASTER: the arm follows the joint angles of a master arm, a small arm that the operator moves.

Inputs: the master arm's angles, from sliders or a device, at any time. When the mode is selected, the master arm is
set to the arm's angles.
Limits: each joint's coarse or vernier rate (lower with a payload), reached by a ramp; soft stops. If the master angle
is beyond a soft stop, the joint comes to rest at the stop. A joint that is past its stop can only move back.
Singularities and the limits of the tip do not act, because the mode demands no twist of the tip.
Ends: when the operator leaves the mode. Each joint comes to rest at its master angle without passing it.
Source: Remote Manipulator Simulation, final report: the slave follows the six angles of a master arm. The rates and
the smooth arrival are ours.
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Rates
from aftdeck.law import law
from aftdeck.steering.layout import (
    AIMS,
    ARRIVED,
    CAUSE,
    DT,
    HIGH,
    JOINTS,
    LIMITING_JOINT,
    LOW,
    MASTER,
    RATE,
    RATE_UP,
    RATES,
)
from aftdeck.steering.limiters import BY_STOP, braked
from aftdeck.steering.ramp import ramped, rate_towards
from aftdeck.steering.views import rates_at

ARRIVAL = 1e-9
"""Greatest distance from the target angle, and greatest motion in one step, of a joint that has arrived [rad]."""


@law
def _target_angle(rules: Array, command: Array, state: Array, i: int) -> float:
    """Return the target angle of joint i [rad]: the master angle, limited to the range between the soft stops.

    If the joint is past a stop, its present angle replaces that stop.
    """
    angle = state[AIMS + i]
    return float(min(max(command[MASTER + i], min(rules[LOW + i], angle)), max(rules[HIGH + i], angle)))


@law
def rates(rules: Array, command: Array, state: Array, report: Array) -> Rates:
    """Return this step's joint rates [rad/s].

    Also write the rates into the state, and write arrival and an active stop into the report.
    """
    arrived = 1.0
    for i in range(int(rules[JOINTS])):
        target = _target_angle(rules, command, state, i)
        rate = ramped(rules, state, report, rate_towards(rules, state, target, i), i, BY_STOP)
        left = abs(target - state[AIMS + i])
        if target != command[MASTER + i] and braked(left, rules[RATE_UP + i], rules[DT]) < rules[RATE + i]:
            report[CAUSE], report[LIMITING_JOINT] = BY_STOP, i
        if left > ARRIVAL or abs(rate) * rules[DT] > ARRIVAL:
            arrived = 0.0
        state[RATES + i] = rate
    report[ARRIVED] = arrived
    return rates_at(state, RATES)
