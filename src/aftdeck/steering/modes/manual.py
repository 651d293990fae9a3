"""The report's manual modes, 4 to 7: the twist that each mode demands for the point of resolution.

`msteer` steers in these modes, and `way_out` evaluates their stick directions. Each manual mode has a file in this
folder, a row in `steering.mode.MODES`, and a line in this module.
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Twist
from aftdeck.kinematics.linkage import Tip
from aftdeck.law import law
from aftdeck.steering.layout import LAW
from aftdeck.steering.modes import end_effector, mixed, orbiter, payload


@law
def demand(rules: Array, command: Array, here: Tip) -> Twist:
    """Return the twist that the sticks demand in the mode whose number is in `command`; zero in other modes."""
    number = command[LAW]
    if number == 4.0:
        return orbiter.demand(rules, command)
    if number == 5.0:
        return end_effector.demand(rules, command, here)
    if number == 6.0:
        return payload.demand(rules, command, here)
    if number == 7.0:
        return mixed.demand(rules, command, here)
    return Twist(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
