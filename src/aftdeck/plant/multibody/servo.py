"""Servos, brakes, encoders and tachometers of the six joints.

A rate servo turns its joint with a torque in proportion to the difference between commanded and actual rate, up to its
torque limit. If a load exceeds this limit, the joint gives way. While a joint is not commanded, its servo returns it
slowly to the angle that it had when the command became zero. A brake holds its joint like a stiff spring and slips at
its holding torque.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arms.dynamics import Servo
from aftdeck.arrays import Array
from aftdeck.plant.multibody.view import View
from aftdeck.plant.state import Bodies

AT_LIMIT = 1.0 - 1e-9
"""Share of the greatest torque from which a motor or a brake counts as at its limit [1]."""


class Servos:
    """Servos and brakes of one model."""

    def __init__(self, view: View, joints: tuple[str, ...], servo: Servo) -> None:
        model = view.model
        self._view, self._servo = view, servo
        self._drives = np.array([model.actuator(f"servo.{name}").id for name in joints])
        self._brakes = np.array([model.actuator(f"brake.{name}").id for name in joints])
        self._stiffness = model.actuator_gainprm[self._brakes, 0].copy()
        self._off = {
            True: 1 << int(model.actuator_group[self._drives[0]]),  # with the brakes on, the servos are off
            False: 1 << int(model.actuator_group[self._brakes[0]]),
        }

    def command(self, bodies: Bodies, angles: Array, rates: Array, *, brakes: bool) -> None:
        """Set the controls of servos and brakes for one control period.

        Args:
            bodies: state of the bodies; the angles that servos and brakes hold are updated.
            angles: (6,) measured joint angles [rad].
            rates: (6,) commanded joint rates [rad/s].
            brakes: whether the brakes are on.
        """
        view, servo, holds = self._view, self._servo, bodies.holds
        still = (rates == 0.0) & (not brakes)
        holds[~still] = np.nan
        begins = still & np.isnan(holds)
        holds[begins] = angles[begins]
        back = np.clip(servo.hold_gain * (holds - angles), -servo.hold_rate, servo.hold_rate)
        view.data.ctrl[self._drives] = np.where(still, back, rates)
        view.model.opt.disableactuator = self._off[brakes]
        if not brakes:
            bodies.brakes[:] = np.nan
            return
        begins = np.isnan(bodies.brakes)
        bodies.brakes[begins] = view.data.qpos[view.motors[begins]]
        view.data.ctrl[self._brakes] = bodies.brakes

    def measure(self, bodies: Bodies, angles: Array, rates: Array) -> None:
        """Measure the joints, and let brakes slip that are at their holding torque.

        Args:
            bodies: state of the bodies; torques are written.
            angles: (6,) output: angles at the joints' outputs, in steps of the encoder [rad].
            rates: (6,) output: rates of the motors, in steps of the tachometer [rad/s].
        """
        view, servo, data = self._view, self._servo, self._view.data
        angles[:] = _stepped(view.angles, servo.encoder_step)
        turning = data.qvel[view.motor_rates]
        rates[:] = _stepped(turning, servo.tachometer_step)
        braked = not np.isnan(bodies.brakes[0])
        acting, most = (self._brakes, servo.holding_torque) if braked else (self._drives, servo.torque_limit)
        bodies.torques[:] = data.actuator_force[acting]
        at_limit = np.abs(bodies.torques) >= AT_LIMIT * most
        bodies.overdriven[:] = at_limit & (turning * bodies.torques < 0.0)
        if braked:
            motors, give = data.qpos[view.motors], most / self._stiffness
            bodies.brakes[:] = np.clip(bodies.brakes, motors - give, motors + give)


def _stepped(values: Array, step: Array) -> Array:
    """Return values in whole steps; a step of 0 is exact."""
    exact = step == 0.0
    size = np.where(exact, 1.0, step)
    return np.where(exact, values, np.round(values / size) * size)
