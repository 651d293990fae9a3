"""Free flight: what floats without anything that holds it, and the orbiter's own translation.

A free flyer either turns at a constant rate about an axis of its own, or is *limit cycling*: its attitude control lets
each axis drift from one side of a deadband to the other and back, a triangle wave. Both are exact in time: the same
instant is the same pose, whatever the steps on the way, but for rounding. Not modelled: gravity gradient, orbital
motion, torque-free tumbling of bodies with three unlike moments of inertia.
"""

from __future__ import annotations

from math import inf, sqrt
from typing import NamedTuple

import msgspec
import numpy as np

from aftdeck.arrays import Array
from aftdeck.errors import InputError
from aftdeck.law import law, sincos

Vec3 = tuple[float, float, float]

_SMALL = 1e-4
"""Turns below it [rad] take the first terms of their sines' series, right to rounding."""


class LimitCycle(msgspec.Struct, frozen=True):
    """Attitude control by thrusters that are only on or off, axis by axis; roll, pitch and yaw about 1, 2 and 3."""

    deadband: Vec3
    """How far each angle goes to either side [rad]; a free flyer has 1 deg (assumed)."""
    rate: Vec3
    """How fast each angle changes [rad/s]; its sign is the way it sets out; 0.02 deg/s (assumed)."""
    start: Vec3
    """Each angle at time 0 [rad], within its deadband."""

    def packed(self) -> Array:
        """(9,) as the law takes it.

        Raises:
            InputError: a start outside its deadband.
        """
        for axis, (band, start) in enumerate(zip(self.deadband, self.start, strict=True), 1):
            if not abs(start) <= band < inf:
                raise InputError(
                    f"limit cycle, axis {axis}: it starts at {start:g} rad, its deadband is {band:g} rad; the start "
                    "has to lie within it"
                )
        return np.array([*self.deadband, *self.rate, *self.start])


class _Wave(NamedTuple):
    """An angle [rad] and how fast it changes [rad/s]."""

    angle: float
    slope: float


@law
def _wave(band: float, rate: float, start: float, time: float) -> _Wave:
    """A triangle wave between -band and band. Where it turns back its slope is that to come."""
    if band == 0.0 or rate == 0.0:
        return _Wave(start, 0.0)
    sense = 1.0 if rate > 0.0 else -1.0
    # How far along the wave, from the side that it leaves, across and back again.
    gone = (sense * start + band + abs(rate) * time) % (4.0 * band)
    if gone < 2.0 * band:
        return _Wave(sense * (gone - band), rate)
    return _Wave(sense * (3.0 * band - gone), -rate)


@law
def limit_cycle(cycle: Array, reference: Array, time: float, pose: Array, motion: Array) -> None:
    """The attitude of a limit-cycling body at a time since its cycle began.

    It is turned from the reference by yaw, then pitch, then roll (as ENDORI).

    Args:
        cycle: (9,) packed.
        reference: (3, 3) attitude about which it cycles, its axes as columns.
        time: [s].
        pose: (12,) position and rotation row by row; the rotation is written.
        motion: (6,) angular velocity in the body's axes [rad/s], which is written, and velocity.
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
    """Move a pose on by a step at constant velocity and constant body rates.

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
    for k in range(3):  # each row r becomes r + a r×v + b (r×v)×v: the rotation's rows times exp of the turn v
        p, q, r = pose[3 + 3 * k], pose[4 + 3 * k], pose[5 + 3 * k]
        u, v, w = q * z - r * y, r * x - p * z, p * y - q * x
        pose[3 + 3 * k] = p + a * u + b * (v * z - w * y)
        pose[4 + 3 * k] = q + a * v + b * (w * x - u * z)
        pose[5 + 3 * k] = r + a * w + b * (u * y - v * x)
    _square_up(pose)


@law
def _square_up(pose: Array) -> None:
    """Take rounding out of a rotation: one step of Newton's towards the nearest orthonormal one, R (3 - RᵀR) / 2."""
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
    """Translate the orbiter for a step: axis by axis to the commanded speed at a constant acceleration, then on.

    The position is integrated exactly, also where the speed is reached within the step. Without a command it comes to
    rest as it set out. Section VII.2 of the report; 0.2 ft/s reached in 2 s (assumed).

    Args:
        position: (3,) how far it has gone [m]; changed.
        velocity: (3,) [m/s]; changed.
        command: (3,) -1, 0 or 1 for each axis.
        speed: greatest, of each axis [m/s].
        reached_in: the time in which it is reached from rest [s].
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
