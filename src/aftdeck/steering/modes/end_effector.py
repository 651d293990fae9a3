"""Mode 5, manual augmented, end effector: sticks along and about the end effector's axes.

The axes are E, the axes of the wrist camera's picture. With `strict` they are the axes of frame 7, as in the source.
Inputs: THC and RHC, full deflection = POR limits.
Limits: POR limits for speed and acceleration, servo maxima for the joints, soft stops, singularities.
Ends: when the operator leaves the mode, or at the end time of a scripted phase.
Source: JSC-12628, subroutine VOTRAN (MODE = 5).
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Twist
from aftdeck.kinematics.linkage import Tip
from aftdeck.law import law
from aftdeck.steering.layout import HAND_COSINE, HAND_SINE, STRICT
from aftdeck.steering.turn import from_hand
from aftdeck.steering.views import stick_twist


@law
def demand(rules: Array, command: Array, tip: Tip) -> Twist:
    """Return the twist in L that the sticks demand: VOTRAN, end effector specified."""
    strict = rules[STRICT] != 0.0
    cosine, sine = (1.0, 0.0) if strict else (rules[HAND_COSINE], rules[HAND_SINE])
    s = stick_twist(rules, command)
    ax, ay, az = from_hand(tip, s.wx, cosine * s.wy - sine * s.wz, sine * s.wy + cosine * s.wz)
    ux, uy, uz = from_hand(tip, s.vx, cosine * s.vy - sine * s.vz, sine * s.vy + cosine * s.vz)
    return Twist(ax, ay, az, ux, uy, uz)
