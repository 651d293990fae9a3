"""Free flight: motion of bodies that are not fixed to another body, and the orbiter's own translation.

A free flyer either rotates at a constant rate about an axis that is fixed in the body, or it is *limit cycling*. In a
limit cycle, each of three angles is a triangle wave: the attitude control lets it drift from one side of a deadband to
the other and back.
Both motions are exact in time: except for rounding, the pose at a time does not depend on the lengths of the control
steps before that time. Not modelled: gravity gradient, orbital motion, and torque-free tumbling of bodies with three
different moments of inertia.
"""

from __future__ import annotations

from math import inf, sqrt
from typing import NamedTuple

import msgspec
import numpy as np

from aftdeck.arrays import Array
from aftdeck.elementary import sincos
from aftdeck.errors import InputError
from aftdeck.law import law
from aftdeck.tuples import Vec3

_SMALL = 1e-4
"""Angle below which the first terms of a series replace the sines [rad]; the result is then exact to rounding."""


class LimitCycle(msgspec.Struct, frozen=True):
    """Limit cycle of on-off thrusters that control each axis separately: roll, pitch and yaw about axes 1, 2 and 3."""

    deadband: Vec3
    """Greatest angle to either side [rad]; a free flyer has 1 deg (assumed)."""
    rate: Vec3
    """Rate of each angle [rad/s]; its sign gives the initial direction; a free flyer has 0.02 deg/s (assumed)."""
    start: Vec3
    """Angles at time 0 [rad], each within its deadband."""

    def packed(self) -> Array:
        """Return the limit cycle as an array (9,) for the law.

        Raises:
            InputError: a start angle is outside its deadband.
        """
        for axis, (band, start) in enumerate(zip(self.deadband, self.start, strict=True), 1):
            if not abs(start) <= band < inf:
                raise InputError(
                    f"limit cycle, axis {axis}: the start is {start:g} rad and the deadband {band:g} rad; the "
                    "start has to be within the deadband"
                )
        return np.array([*self.deadband, *self.rate, *self.start])


class _Wave(NamedTuple):
    """An angle [rad] and its rate of change [rad/s]."""

    angle: float
    slope: float


@law
def _wave(band: float, rate: float, start: float, time: float) -> _Wave:
    """Return a triangle wave between -band and band. At a turning point, `slope` is the value after the turn."""
    if band == 0.0 or rate == 0.0:
        return _Wave(start, 0.0)
    sense = 1.0 if rate > 0.0 else -1.0
    # Distance along the wave from one side of the band. The other side is at 2 * band, the first one again at 4 * band.
    path = (sense * start + band + abs(rate) * time) % (4.0 * band)
    if path < 2.0 * band:
        return _Wave(sense * (path - band), rate)
    return _Wave(sense * (3.0 * band - path), -rate)


@law
def limit_cycle(cycle: Array, reference: Array, time: float, pose: Array, motion: Array) -> None:
    """Compute the attitude and angular velocity of a limit-cycling body.

    The attitude is the reference attitude, rotated by yaw, then pitch, then roll (as ENDORI).

    Args:
        cycle: (9,) packed limit cycle.
        reference: (3, 3) attitude at which all three angles are zero; its columns are the body's axes.
        time: time since the cycle began [s].
        pose: (12,) position, then rotation row by row; only the rotation is written.
        motion: (6,) angular velocity in the body's axes [rad/s], then velocity; only the angular velocity is written.
    """
    roll = _wave(cycle[0], cycle[3], cycle[6], time)
    pitch = _wave(cycle[1], cycle[4], cycle[7], time)
    yaw = _wave(cycle[2], cycle[5], cycle[8], time)
    s1, c1 = sincos(roll.angle)
    s2, c2 = sincos(pitch.angle)
    s3, c3 = sincos(yaw.angle)
    for k in range(3):
        x, y, z = reference[k, 0], reference[k, 1], reference[k, 2]
        along, across = x * c3 + y * s3, y * c3 - x * s3
        ahead, down = along * c2 - z * s2, along * s2 + z * c2
        pose[3 + 3 * k] = ahead
        pose[4 + 3 * k] = across * c1 + down * s1
        pose[5 + 3 * k] = down * c1 - across * s1
    motion[0] = roll.slope - yaw.slope * s2
    motion[1] = pitch.slope * c1 + yaw.slope * c2 * s1
    motion[2] = yaw.slope * c2 * c1 - pitch.slope * s1


@law
def coast(pose: Array, motion: Array, dt: float) -> None:
    """Advance a pose by one step at constant velocity and constant body rates.

    Args:
        pose: (12,) position [m], then the rotation row by row; changed.
        motion: (6,) angular velocity in the body's axes [rad/s], then velocity in the pose's frame [m/s].
        dt: the step [s].
    """
    for k in range(3):
        pose[k] += motion[3 + k] * dt
    x, y, z = motion[0] * dt, motion[1] * dt, motion[2] * dt
    square = x * x + y * y + z * z
    angle = sqrt(square)
    if angle < _SMALL:
        a, b = 1.0 - square / 6.0, 0.5 - square / 24.0
    else:
        s, c = sincos(0.5 * angle)
        a, b = 2.0 * s * c / angle, 2.0 * s * s / square
    for k in range(3):  # each row r becomes r + a r×v + b (r×v)×v: the row times the exponential of the rotation v
        p, q, r = pose[3 + 3 * k], pose[4 + 3 * k], pose[5 + 3 * k]
        u, v, w = q * z - r * y, r * x - p * z, p * y - q * x
        pose[3 + 3 * k] = p + a * u + b * (v * z - w * y)
        pose[4 + 3 * k] = q + a * v + b * (w * x - u * z)
        pose[5 + 3 * k] = r + a * w + b * (u * y - v * x)
    _square_up(pose)


@law
def _square_up(pose: Array) -> None:
    """Remove rounding from a rotation: one Newton step towards the nearest orthonormal matrix, R (3 - RᵀR) / 2."""
    xx = pose[3] * pose[3] + pose[6] * pose[6] + pose[9] * pose[9]
    yy = pose[4] * pose[4] + pose[7] * pose[7] + pose[10] * pose[10]
    zz = pose[5] * pose[5] + pose[8] * pose[8] + pose[11] * pose[11]
    xy = pose[3] * pose[4] + pose[6] * pose[7] + pose[9] * pose[10]
    xz = pose[3] * pose[5] + pose[6] * pose[8] + pose[9] * pose[11]
    yz = pose[4] * pose[5] + pose[7] * pose[8] + pose[10] * pose[11]
    for k in range(3):
        p, q, r = pose[3 + 3 * k], pose[4 + 3 * k], pose[5 + 3 * k]
        pose[3 + 3 * k] = 0.5 * (p * (3.0 - xx) - q * xy - r * xz)
        pose[4 + 3 * k] = 0.5 * (q * (3.0 - yy) - p * xy - r * yz)
        pose[5 + 3 * k] = 0.5 * (r * (3.0 - zz) - p * xz - q * yz)


@law
def translate(position: Array, velocity: Array, command: Array, speed: float, reached_in: float, dt: float) -> None:
    """Translate the orbiter by one step.

    Along each axis the velocity changes at a constant acceleration until it equals the commanded velocity. It is then
    constant. Without a command the orbiter slows to rest at the same acceleration. The position is integrated exactly,
    even if the commanded velocity is reached within the step. Source: section VII.2 of the report; 0.2 ft/s, reached
    in 2 s (assumed).

    Args:
        position: (3,) displacement of the orbiter [m]; updated.
        velocity: (3,) velocity of the orbiter [m/s]; updated.
        command: (3,) direction of the command along each axis: -1, 0 or 1.
        speed: commanded speed along each axis [m/s].
        reached_in: time to reach the speed from rest [s].
        dt: the step [s].
    """
    for k in range(3):
        before, after = velocity[k], command[k] * speed
        change = after - before
        needed = abs(change) / speed * reached_in
        if needed > dt:
            after = before + (speed if change > 0.0 else -speed) * (dt / reached_in)
            needed = dt
        position[k] += 0.5 * (before + after) * needed + after * (dt - needed)
        velocity[k] = after
