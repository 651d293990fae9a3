"""Jets of the orbiter: they hold its attitude within a deadband, and translate it.

Each axis has a jet in either direction, which is on or off, and on for a least time. The jets of an axis act on its
angle and rate alone (a phase plane): they fire when the angle leaves its deadband without returning, or when the rate
leaves its own, until the axis returns at a fraction of the rate's deadband.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.law import law
from aftdeck.plant.state import Bodies

RETURNS = 0.3
"""Rate at which an axis returns when its jet stops, as a share of the rate's deadband [1] (assumed)."""


class Thrusters(NamedTuple):
    """Constants of the orbiter's jets.

    Attributes:
        axes: (3, 3) forward, starboard and down in L, as columns.
        torque: (3,) torque about these axes [N m]; zeros if nothing holds the attitude.
        least_pulse: least time for which a jet is on [s].
        angle: deadband of the angles [rad].
        rate: deadband of the rates [rad/s].
        force: force along each axis [N]; 0 if the orbiter cannot translate.
    """

    axes: Array
    torque: Array
    least_pulse: float
    angle: float
    rate: float
    force: float


class Jets:
    """Jets of the orbiter in one model and its workspace."""

    def __init__(self, model: Any, data: Any, thrusters: Thrusters) -> None:
        self._thrusters = thrusters
        body, at = int(model.body("orbiter").id), int(model.joint("orbiter").dofadr[0])
        self._centre, self._mass = model.body_ipos[body].copy(), float(model.body_mass[body])
        self._velocity, self._wrench = data.qvel[at : at + 6], data.xfrc_applied[body]

    def fire(self, base: Array, bodies: Bodies, command: Array, period: float) -> None:
        """Set the force and torque of the jets for one control period.

        Args:
            base: (12,) pose of L in the world.
            bodies: state of the bodies; `pulses` and `fired` are updated.
            command: (3,) commanded velocity in space, along forward, starboard and down [m/s]; NaN for an axis that the
                operator does not command.
            period: control period [s].
        """
        t = self._thrusters
        fire_jets(
            base, self._velocity, self._centre, self._mass, command, t.axes, t.torque,
            t.least_pulse, t.angle, t.rate, t.force, period, bodies.pulses, bodies.fired, self._wrench,
        )  # fmt: skip

    def write(self, base: Array, bodies: Bodies) -> None:
        """Write the velocity of the orbiter's centre of mass in space, in L's axes."""
        velocity_of(base, self._velocity, self._centre, bodies.orbiter_velocity)


@law
def velocity_of(base: Array, qvel: Array, centre: Array, velocity: Array) -> None:
    """Write the velocity of a body's centre, in the body's axes.

    Args:
        base: (12,) pose of the body in the world.
        qvel: (6,) velocity of the body's origin in the world [m/s], and angular velocity in the body's axes [rad/s].
        centre: (3,) the centre in the body's axes [m].
        velocity: (3,) output [m/s].
    """
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        velocity[i] = qvel[3 + j] * centre[k] - qvel[3 + k] * centre[j]
        for n in range(3):
            velocity[i] += base[3 + 3 * n + i] * qvel[n]


@law
def fire_jets(
    base: Array,
    qvel: Array,
    centre: Array,
    mass: float,
    command: Array,
    axes: Array,
    torque: Array,
    least: float,
    angle: float,
    rate: float,
    force: float,
    period: float,
    pulses: Array,
    fired: Array,
    wrench: Array,
) -> None:
    """Decide which jets are on, and write their force and torque.

    Args:
        base: (12,) pose of L in the world.
        qvel: (6,) velocity of L's origin in the world [m/s], and angular velocity in L's axes [rad/s].
        centre: (3,) the orbiter's centre of mass in L [m].
        mass: the orbiter's mass [kg].
        command: (3,) commanded velocity along each axis [m/s]; NaN for none.
        axes: (3, 3) as `Thrusters.axes`; torque, least, angle, rate and force likewise.
        torque: (3,) [N m].
        least: [s].
        angle: [rad].
        rate: [rad/s].
        force: [N].
        period: control period [s].
        pulses: (6,) time left of the pulses, with their signs [s]; updated.
        fired: (6,) time for which the jets have fired [s]; updated.
        wrench: (6,) output: force and torque in the world's axes [N, N m].
    """
    velocity = np.empty(3)
    velocity_of(base, qvel, centre, velocity)
    wrench[:] = 0.0
    for axis in range(3):
        away, turn, speed = 0.0, 0.0, 0.0
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            # the axis of a small rotation is half of the antisymmetric part of its matrix
            away += axes[i, axis] * 0.5 * (base[3 + 3 * k + j] - base[3 + 3 * j + k])
            turn += axes[i, axis] * qvel[3 + i]
            speed += axes[i, axis] * velocity[i]
        about = _switch(away, turn, angle, rate, pulses[axis]) if torque[axis] > 0.0 else 0.0
        missing = command[axis] - speed
        step = force / mass * least
        along = 0.0
        if command[axis] == command[axis] and force > 0.0:
            along = 1.0 if missing > 0.5 * step else -1.0 if missing < -0.5 * step else 0.0
        about = _pulse(about, axis, least, period, pulses, fired)
        along = _pulse(along, 3 + axis, least, period, pulses, fired)
        for i in range(3):
            for n in range(3):  # from L's axes to those of the world
                wrench[n] += base[3 + 3 * n + i] * axes[i, axis] * along * force
                wrench[3 + n] += base[3 + 3 * n + i] * axes[i, axis] * about * torque[axis]


@law
def _switch(away: float, turn: float, angle: float, rate: float, pulse: float) -> float:
    """Return the sign of the torque that an axis needs; 0 for none.

    Args:
        away: angle of the axis [rad].
        turn: its rate [rad/s].
        angle: deadband of the angle [rad].
        rate: deadband of the rate [rad/s].
        pulse: time left of the axis's pulse, with its sign [s]; 0 if no jet is on.
    """
    back = RETURNS * rate
    if turn > rate or (away > angle and turn > -back):
        return -1.0
    if turn < -rate or (away < -angle and turn < back):
        return 1.0
    return 0.0


@law
def _pulse(wanted: float, jet: int, least: float, period: float, pulses: Array, fired: Array) -> float:
    """Return the sign with which a jet acts in this control period; a pulse that has begun lasts its least time."""
    left = pulses[jet]
    if left == 0.0 and wanted != 0.0:
        left = wanted * least
    sign = 1.0 if left > 0.0 else -1.0 if left < 0.0 else wanted
    rest = max(abs(left) - period, 0.0)
    pulses[jet] = sign * rest if rest > 0.5 * period else 0.0
    fired[jet] += abs(sign) * period
    return sign
