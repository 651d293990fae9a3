"""By how much an automatic motion ends beside its target.

Modes 1 and 3 end when their clock has run out, wherever the arm then is: what they miss is theirs to show, and is
told once it is more than steps of finite length make of it.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from aftdeck.frames import angle_between
from aftdeck.kinematics.arm import Arm
from aftdeck.scenario.target import Target
from aftdeck.simulation.flight import Flight

THERE, THERE_TURN = 0.025, 0.004
"""How near to its target a motion has to end to have reached it [m], [rad], where the scenario's end sphere is smaller.

Assumed: what mode 3 may miss on the STS-400 move. Clear of the singularities its steps of 0.02 to 0.2 s cost at most
8 mm and 0.001 rad (449 motions between random poses, up to 40 deg a joint).
"""


def miss(flight: Flight, arm: Arm, angles: NDArray[np.float64], target: Target) -> str:
    """How far the tip is beside a target, for people; empty where it is there.

    Args:
        flight: says what counts as there.
        arm: as it stands.
        angles: (6,) its joint angles [rad].
        target: where the tip should be.
    """
    tip = arm.forward(angles)
    distance = math.dist(tip.position, target.position)
    angle = angle_between(tip.rotation.tolist(), target.rotation)
    if distance <= max(THERE, flight.scenario.near) and angle <= max(THERE_TURN, flight.scenario.near_turn):
        return ""
    way = f"{distance:.2f} m" if distance >= 1.0 else f"{distance * 1e3:.0f} mm"
    turn = math.degrees(angle)
    return f"{way}, {turn:.1f}° beside" if turn >= 1.0 else f"{way}, {turn:.2f}° beside"
