"""DIRECT: the drive switch moves one joint directly, without steering or soft stops; the other joints stop at once.

Inputs: the JOINT rotary and the SINGLE/DIRECT DRIVE switch, full deflection = the joint's coarse or vernier rate.
Limits: that rate, without a ramp, and the hard stops.
Ends: when the operator leaves the mode, or at the end time of a scripted phase.
Source: the Shuttle Crew Operations Manual, section 2.21; JSC-12628 does not have this mode.
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Rates
from aftdeck.law import law
from aftdeck.steering.layout import ANGLES, CAUSE, DRIVE, DT, HIGH, JOINT, LIMITING_JOINT, LOW, RATE
from aftdeck.steering.limiters import BY_HARD_STOP


@law
def rates(rules: Array, command: Array, state: Array, report: Array) -> Rates:
    """Return the joint rates [rad/s] of this step; if a hard stop acts, write it into the report."""
    joint = int(command[JOINT])
    demanded = command[DRIVE] * rules[RATE + joint]
    room = rules[HIGH + joint] - state[ANGLES + joint] if demanded > 0.0 else state[ANGLES + joint] - rules[LOW + joint]
    most = max(room, 0.0) / rules[DT]
    if abs(demanded) > most:
        report[CAUSE], report[LIMITING_JOINT] = BY_HARD_STOP, joint
        demanded = most if demanded > 0.0 else -most
    return Rates(
        demanded if joint == 0 else 0.0,
        demanded if joint == 1 else 0.0,
        demanded if joint == 2 else 0.0,
        demanded if joint == 3 else 0.0,
        demanded if joint == 4 else 0.0,
        demanded if joint == 5 else 0.0,
        demanded if joint == 6 else 0.0,
        demanded if joint == 7 else 0.0,
    )
