"""Mode 7, manual augmented, mixed: rotation in payload axes, translation in orbiter axes.

ORB LD selects this mode with its switch "rotate in payload axes". The commanded point is the payload's point of
resolution; with `strict` it is the tip, as in the source.
Inputs: THC and RHC, full deflection = POR limits for the payload's mass.
Limits: POR limits for speed and acceleration, servo maxima for the joints, soft stops, singularities.
Ends: when the operator leaves the mode, or at the end time of a scripted phase. Rejected without a payload.
Source: JSC-12628, subroutine VOTRAN (MODE = 7).
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Twist
from aftdeck.kinematics.linkage import Tip
from aftdeck.law import law
from aftdeck.steering.turn import from_orbiter, from_payload
from aftdeck.steering.views import stick_twist


@law
def demand(rules: Array, command: Array, tip: Tip) -> Twist:
    """Return the twist in L that the sticks demand: VOTRAN, mixed."""
    s = stick_twist(rules, command)
    a, b, c = from_payload(rules, tip, s.wx, s.wy, s.wz)
    x, y, z = from_orbiter(rules, s.vx, s.vy, s.vz)
    return Twist(a, b, c, x, y, z)
