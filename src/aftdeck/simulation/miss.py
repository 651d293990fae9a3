"""By how much an automatic motion ends beside its target: one rule for flight and CMD CK."""

from __future__ import annotations

import math

from aftdeck.arrays import Array
from aftdeck.frames import angle_between
from aftdeck.kinematics.arm import Arm
from aftdeck.scenario.target import Target
from aftdeck.simulation.flight import Flight

REACHED, REACHED_TURN = 1e-3, math.radians(0.02)
"""How near to its target a motion has to end to have reached it [m], [rad], where the scenario's end sphere is smaller.

Assumed: ten times what mode 3 misses by on random straight moves in steps of 0.02 s
(`tests/steering/test_straight_moves.py`).
"""
_FINE = 0.01
"""Distances under this are told to a tenth of a millimetre [m]."""


def miss(flight: Flight, arm: Arm, angles: Array, target: Target) -> str:
    """How far the tip is beside a target, for people; empty where it has reached it.

    Args:
        flight: says what counts as reached.
        arm: with its telescope at the present length.
        angles: (6,) its joint angles [rad].
        target: where the tip should be.
    """
    tip = arm.forward(angles)
    distance = math.dist(tip.position, target.position)
    angle = angle_between(tip.rotation.tolist(), target.rotation)
    if distance <= max(REACHED, flight.scenario.near) and angle <= max(REACHED_TURN, flight.scenario.near_turn):
        return ""
    way = f"{distance:.2f} m" if distance >= 1.0 else f"{distance * 1e3:.{0 if distance >= _FINE else 1}f} mm"
    turn = math.degrees(angle)
    return f"{way}, {turn:.1f}° beside" if turn >= 1.0 else f"{way}, {turn:.2f}° beside"
