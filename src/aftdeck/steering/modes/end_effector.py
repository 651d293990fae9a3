"""Mode 5, manual augmented, end effector: sticks along and about the end effector's axes.

The axes are E, those of the wrist camera's picture; with `strict` they are frame 7's, as in the source.
Inputs: THC and RHC, full deflection = POR limits.
Limits: POR limits for speed and acceleration, servo maxima for the joints, soft stops, singularities.
Ends: when the operator leaves it, or at a scripted phase's time.
Source: JSC-12628, subroutine VOTRAN (MODE = 5).
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Twist
from aftdeck.kinematics.linkage import Tip
from aftdeck.law import law
from aftdeck.steering.layout import HAND, SPEED, STICKS, STRICT, TURN
from aftdeck.steering.turn import from_hand


@law
def demand(rules: Array, command: Array, tip: Tip) -> Twist:
    """Return the twist in L that the sticks demand: VOTRAN, end effector specified."""
    strict = rules[STRICT] != 0.0
    c = 1.0 if strict else rules[HAND]
    s = 0.0 if strict else rules[HAND + 1]
    w, v = rules[TURN], rules[SPEED]
    b, d = w * command[STICKS + 1], w * command[STICKS + 2]
    y, z = v * command[STICKS + 4], v * command[STICKS + 5]
    ax, ay, az = from_hand(tip, w * command[STICKS], c * b - s * d, s * b + c * d)
    ux, uy, uz = from_hand(tip, v * command[STICKS + 3], c * y - s * z, s * y + c * z)
    return Twist(ax, ay, az, ux, uy, uz)
