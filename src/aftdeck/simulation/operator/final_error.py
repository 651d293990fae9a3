"""Final error of an automatic motion. For the motion and CMD CK, one rule decides whether the target is reached."""

from __future__ import annotations

import math

from aftdeck.arrays import Array
from aftdeck.bodies.placed import rows_of
from aftdeck.frames import angle_between
from aftdeck.kinematics.arm import Arm
from aftdeck.matrices import distance
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.target import Target

REACHED, REACHED_TURN = 1e-3, math.radians(0.02)
"""Greatest final error with which the target counts as reached [m], [rad].

If the scenario's end sphere is larger, the values of the end sphere are used. Assumed: ten times the final error of
mode 3, measured on random straight motions with a control period of 0.02 s (`tests/steering/test_straight_moves.py`).
"""
_FINE = 0.01
"""Distances below this value [m] are written with tenths of a millimetre."""


def final_error_text(scenario: Scenario, arm: Arm, angles: Array, target: Target) -> str:
    """Return the tip's final error (distance and angle) as text; "" if the tip has reached the target.

    Args:
        scenario: the scenario, with its end sphere.
        arm: the arm, with its telescope at the present length.
        angles: (n,) joint angles [rad].
        target: final pose of the motion.
    """
    tip = arm.forward(angles)
    away = distance(tip.position.tolist(), target.position)
    angle = angle_between(rows_of(tip.rotation), target.rotation)
    if away <= max(REACHED, scenario.near) and angle <= max(REACHED_TURN, scenario.near_turn):
        return ""
    length = f"{away:.2f} m" if away >= 1.0 else f"{away * 1e3:.{0 if away >= _FINE else 1}f} mm"
    degrees = math.degrees(angle)
    return f"{length}, {degrees:.1f}°" if degrees >= 1.0 else f"{length}, {degrees:.2f}°"
