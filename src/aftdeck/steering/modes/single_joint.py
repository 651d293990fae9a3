"""Mode 8, single joint rate: the drive switch moves one joint, with a ramp; all other joints hold their angles.

Inputs: the JOINT rotary and the SINGLE/DIRECT DRIVE switch, full deflection = the joint's coarse or vernier rate.
Limits: that rate, with a ramp; hard stops, before which the joint slows to rest. Soft stops do not act, because on the
Shuttle this mode cradles and uncradles the arm, and moves a joint back from its soft stop.
Holds: every other joint at theta_0, its angle when the mode was selected. When the operator selects another joint,
the present angle of the previous joint becomes its theta_0. A joint that was still moving when theta_0 was stored, or
that is disturbed, returns to theta_0.
Ends: when the operator leaves the mode, or at the time or joint angle that ends a scripted phase.
Source: JSC-12628, introduction (mode 8); section 3, subroutine OPERIN.
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Rates
from aftdeck.law import law
from aftdeck.steering.layout import DRIVE, JOINT, JOINTS, KEPT, RATE, RATES
from aftdeck.steering.limiters import BY_HARD_STOP
from aftdeck.steering.ramp import ramped, rate_towards
from aftdeck.steering.views import rates_at


@law
def rates(rules: Array, command: Array, state: Array, report: Array) -> Rates:
    """Return this step's joint rates [rad/s].

    Also write the rates into the state. If a hard stop acts, write it into the report.
    """
    selected = int(command[JOINT])
    for i in range(int(rules[JOINTS])):
        driven = command[DRIVE] * rules[RATE + i]
        demanded = driven if i == selected else rate_towards(rules, state, command[KEPT + i], i)
        state[RATES + i] = ramped(rules, state, report, demanded, i, BY_HARD_STOP)
    return rates_at(state, RATES)
