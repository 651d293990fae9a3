"""Velocities with which an operator brings the point of resolution to the place of a step."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from aftdeck.arms.load import PorLimits
from aftdeck.arrays import Array
from aftdeck.matrices import dots, lengths
from aftdeck.task.along_sticks import AlongSticks
from aftdeck.task.remaining import Remaining

STRAIGHT = 4.0
"""Least ratio of the distance to a payload or berth to the error beside it, while the operator moves closer."""
HOVER_M = 0.5
"""Height over a payload or berth below which the operator is only when lined up [m]."""
PER_ANGLE_M = 2.0
"""Distance that the operator keeps from a payload or berth for each radian of misalignment [m]."""
CLEAR_M = 0.3
"""Remaining distance on the way out, below which the operator also moves aside and turns [m]."""
BESIDE_M, CLEAR_RAD = 0.1, 0.1
"""Errors beside the way out [m] and in attitude [rad] up to which they are corrected on the way, too."""
LINED_UP = 0.5
"""Part of the tolerance that an axis may miss when the next axis of the way begins."""
LEAST_M = 0.02
"""Least error of an axis at which the next axis of the way begins [m]."""
MATTERS = 0.2
"""Part of the tolerance below which an error does not matter."""
BRAKING = 0.7
"""Part of the greatest deceleration that the operator uses."""


class Speeds(NamedTuple):
    """Speeds with which an operator flies.

    Attributes:
        speed: greatest speed [m/s].
        rate: greatest angular rate [rad/s].
        gain: demanded speed for each metre of distance, and angular rate for each radian [1/s].
        por: limits of the point of resolution, for the decelerations.
        least: least deflection with which the operator corrects an error that matters.
    """

    speed: float
    rate: float
    gain: float
    por: PorLimits
    least: float = 0.0


def deflections(
    left: AlongSticks, remaining: Remaining, out: Array | None, way: tuple[int, ...], speeds: Speeds
) -> tuple[Array, Array]:
    """Return the deflections of THC and RHC (3,), (3,) that reduce the remaining motion.

    Args:
        left: remaining motion, along the sticks.
        remaining: the remaining motion.
        out: direction (3,) along the sticks' axes that leads away from the payload or berth; None if the place is
            neither.
        way: axes of the THC in the order in which the place is approached; empty if all are used at once.
        speeds: speeds with which the operator flies.
    """
    move, turn = np.array(left.translation), np.array(left.rotation)
    if way:
        move, turn = _in_order(move, turn, way, remaining)
    elif out is not None:
        along = float(dots(out, move))
        beside = move - along * out
        if along > 0.0:
            move, turn = _outwards(move, turn, along, beside)
        else:
            move = beside - out * _closer(-along, beside, remaining)
    near_m, near_rad = remaining.near
    return (
        _in_its_direction(move, Axis(speeds.speed, speeds.por.acceleration, MATTERS * near_m), speeds),
        _in_its_direction(turn, Axis(speeds.rate, speeds.por.angular_acceleration, MATTERS * near_rad), speeds),
    )


class Axis(NamedTuple):
    """Limits of one axis.

    Attributes:
        limit: speed at full deflection [m/s] or [rad/s].
        acceleration: greatest acceleration [m/s2] or [rad/s2].
        matters: error above which a correction is worth it [m] or [rad].
    """

    limit: float
    acceleration: float
    matters: float


def deflection(left: float, axis: Axis, speeds: Speeds) -> float:
    """Return the deflection of one axis: the gain times what is left, slow enough to stop there, at most 1.

    Args:
        left: what is left [m] or [rad].
        axis: limits of the axis.
        speeds: speeds with which the operator flies.
    """
    size = abs(left)
    speed = min(speeds.gain * size, math.sqrt(2.0 * BRAKING * axis.acceleration * size), axis.limit)
    least = speeds.least if size > axis.matters else 0.0
    return math.copysign(max(speed / axis.limit, least), left)


def _in_its_direction(left: Array, axis: Axis, speeds: Speeds) -> Array:
    """Return the deflections for a vector: those of its magnitude, in its direction."""
    size = float(lengths(left))
    return left * (deflection(size, axis, speeds) / size) if size > 0.0 else left


def _closer(height: float, beside: Array, remaining: Remaining) -> float:
    """Return how far the operator moves closer now: not below a cone over the place, and last if lined up."""
    error = max(0.0, float(lengths(beside)) - LINED_UP * remaining.near[0])
    angle = max(0.0, abs(remaining.angle) - LINED_UP * remaining.near[1])
    least = STRAIGHT * error + PER_ANGLE_M * angle
    return max(0.0, height - (max(HOVER_M, least) if least > 0.0 else 0.0))


def _outwards(move: Array, turn: Array, along: float, beside: Array) -> tuple[Array, Array]:
    """Return the motion on the way out: first straight out, with small corrections only."""
    if along < CLEAR_M:
        return move, turn
    small = float(lengths(beside)) < BESIDE_M
    turned = float(lengths(turn))
    return (move if small else move - beside), turn if turned < CLEAR_RAD else turn * 0.0


def _in_order(move: Array, turn: Array, way: tuple[int, ...], remaining: Remaining) -> tuple[Array, Array]:
    """Return the motion of the axes up to the first of the way that is not lined up; it turns after the first axis."""
    arrived = max(LEAST_M, LINED_UP * remaining.near[0])
    for i, axis in enumerate(way):
        if abs(move[axis]) > arrived:
            later = list(way[i + 1 :])
            move = move.copy()
            move[later] = 0.0
            return move, turn if i else turn * 0.0
    return move, turn
