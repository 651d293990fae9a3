"""Mode 8, single joint rate: one joint by the drive switch, ramped, the others held.

Inputs: the JOINT rotary and the SINGLE/DIRECT DRIVE switch, full deflection = the joint's coarse or vernier rate.
Limits: that rate, ramped; hard stops, before which the joint slows to rest. Soft stops do not act: as flown, this
is the mode that cradles and uncradles the arm and that leads back from a soft stop.
Ends: when the operator leaves it, or at a scripted phase's time or angle.
Source: JSC-12628, introduction (mode 8); section 3, subroutine OPERIN.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from aftdeck.kinematics.jacobian import Rates
from aftdeck.law import law
from aftdeck.steering.layout import (
    ANGLES,
    CAUSE,
    CULPRIT,
    DRIVE,
    DT,
    HIGH,
    JOINT,
    LOW,
    RATE,
    RATE_UP,
    RATES,
    RATIO,
)
from aftdeck.steering.limiters import BY_HARD_STOP, braked

Array = NDArray[np.float64]


@law
def _ramped(rules: Array, command: Array, state: Array, report: Array, i: int) -> float:
    """Rate of joint i [rad/s]: towards what is asked by at most its acceleration, and in time for its stop."""
    asked = command[DRIVE] * rules[RATE + i] if i == int(command[JOINT]) else 0.0
    change = rules[RATE_UP + i] * rules[DT]
    before = state[RATES + i]
    rate = before + min(max(asked - before, -change), change)
    gap = rules[HIGH + i] - state[ANGLES + i] if rate > 0.0 else state[ANGLES + i] - rules[LOW + i]
    allowed = braked(gap, rules[RATE_UP + i], rules[DT])
    if abs(rate) > allowed:
        report[RATIO] = min(report[RATIO], allowed / abs(rate))
        report[CAUSE], report[CULPRIT] = BY_HARD_STOP, i
        rate = allowed if rate > 0.0 else -allowed
    most: float = rules[RATE + i]
    return float(min(max(rate, -most), most))


@law
def rates(rules: Array, command: Array, state: Array, report: Array) -> Rates:
    """The joint rates [rad/s] of this step, into the state too; a hard stop that acts is written into the report."""
    for i in range(6):
        state[RATES + i] = _ramped(rules, command, state, report, i)
    return Rates(
        state[RATES], state[RATES + 1], state[RATES + 2], state[RATES + 3], state[RATES + 4], state[RATES + 5]
    )  # fmt: skip
