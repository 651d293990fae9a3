"""Mode 4, manual augmented, orbiter frame: sticks along and about the orbiter's axes.

Flown by ORB UNL about the tip and by ORB LD about the payload's point of resolution.
Inputs: THC and RHC, full deflection = POR limits.
Limits: POR limits for speed and acceleration, servo maxima for the joints, soft stops, singularities.
Ends: when the operator leaves it, or at a scripted phase's time.
Source: JSC-12628, subroutine VOTRAN (MODE = 4).
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Twist
from aftdeck.law import law
from aftdeck.steering.layout import SPEED, STICKS, TURN
from aftdeck.steering.turn import from_orbiter


@law
def demand(rules: Array, command: Array) -> Twist:
    """Return the twist in L that the sticks demand: VOTRAN, orbiter specified."""
    w, v = rules[TURN], rules[SPEED]
    a, b, c = from_orbiter(rules, w * command[STICKS], w * command[STICKS + 1], w * command[STICKS + 2])
    x, y, z = from_orbiter(rules, v * command[STICKS + 3], v * command[STICKS + 4], v * command[STICKS + 5])
    return Twist(a, b, c, x, y, z)
