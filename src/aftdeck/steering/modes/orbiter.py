"""Mode 4, manual augmented, orbiter frame: sticks along and about the orbiter's axes.

ORB UNL applies this mode to the tip, ORB LD to the payload's point of resolution.
Inputs: THC and RHC, full deflection = POR limits.
Limits: POR limits for speed and acceleration, servo maxima for the joints, soft stops, singularities.
Ends: when the operator leaves the mode, or at the end time of a scripted phase.
Source: JSC-12628, subroutine VOTRAN (MODE = 4).
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Twist
from aftdeck.law import law
from aftdeck.steering.turn import from_orbiter
from aftdeck.steering.views import stick_twist


@law
def demand(rules: Array, command: Array) -> Twist:
    """Return the twist in L that the sticks demand: VOTRAN, orbiter specified."""
    s = stick_twist(rules, command)
    a, b, c = from_orbiter(rules, s.wx, s.wy, s.wz)
    x, y, z = from_orbiter(rules, s.vx, s.vy, s.vz)
    return Twist(a, b, c, x, y, z)
