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
from aftdeck.plant.multibody.build import BRAKE_STIFFNESS, BRAKES, SERVOS
from aftdeck.plant.multibody.joint_laws import command_joints, measure_joints
from aftdeck.plant.multibody.view import View
from aftdeck.plant.state import Bodies, PlantState


class Servos:
    """Servos and brakes of one model."""

    def __init__(self, view: View, joints: tuple[str, ...], servo: Servo, period: float) -> None:
        """Set up the servos and brakes of a model.

        Args:
            view: the model.
            joints: names of the joints.
            servo: constants of the servos.
            period: control period [s].
        """
        model = view.model
        drives = [model.actuator(f"servo.{name}").id for name in joints]
        brakes = [model.actuator(f"brake.{name}").id for name in joints]
        self._view, self._option = view, model.opt
        self._period, self._braked = period, False
        self._places = np.array([view.motors, view.motor_rates, drives, brakes])  # rows as in `joint_laws`
        self._servo = np.array(
            [
                servo.hold_gain,
                servo.hold_rate,
                servo.encoder_step,
                servo.tachometer_step,
                servo.torque_limit,
                servo.holding_torque,
            ]
        )
        self._off = {True: 1 << SERVOS, False: 1 << BRAKES}  # with the brakes on, the servos are off
        self._option.disableactuator = self._off[False]
        self._force, self._ctrl = view.data.actuator_force, view.data.ctrl

    def command(self, bodies: Bodies, angles: Array, rates: Array, *, brakes: bool) -> None:
        """Set the controls of servos and brakes for one control period.

        Args:
            bodies: state of the bodies; the angles that servos and brakes hold are updated.
            angles: (6,) measured joint angles [rad].
            rates: (6,) commanded joint rates [rad/s].
            brakes: whether the brakes are on.
        """
        command_joints(
            rates, angles, brakes, self._places, self._servo, self._view.qpos, bodies.holds, bodies.brakes, self._ctrl
        )
        if brakes != self._braked:
            self._option.disableactuator, self._braked = self._off[brakes], brakes

    def measure(self, state: PlantState, bodies: Bodies, rates: Array, *, brakes: bool) -> None:
        """Measure the joints, let brakes slip that are at their holding torque, and count the commanded rates.

        Args:
            state: output: angles at the joints' outputs, in steps of the encoder, rates of the motors, in steps of the
                tachometer, and commanded angles.
            bodies: state of the bodies; torques and reference rates are written.
            rates: (6,) commanded joint rates [rad/s].
            brakes: whether the brakes are on.
        """
        view = self._view
        measure_joints(
            brakes, self._places, view.gearboxes, self._servo, BRAKE_STIFFNESS, view.qpos, view.qvel, self._force,
            state.angles, state.rates, bodies.brakes, bodies.torques, bodies.overdriven,
            rates, self._period, bodies.reference, state.commanded,
        )  # fmt: skip
