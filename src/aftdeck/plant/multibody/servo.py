"""Servos, brakes, encoders and tachometers of the joints.

A rate servo turns its joint with a torque in proportion to the difference between commanded and actual rate, up to its
torque limit. If a load exceeds this limit, the joint gives way. While a joint is not commanded, its servo returns it
slowly to the angle that it had when the command became zero. A brake holds its motor by friction, which is a stiff
spring until it slips at its holding torque.
"""

from __future__ import annotations

from math import ceil

import numpy as np

from aftdeck.arms.dynamics import Servo
from aftdeck.arrays import Array
from aftdeck.plant.multibody.build import BRAKE_DAMPING, BRAKE_STIFFNESS, BRAKES, SERVOS
from aftdeck.plant.multibody.joint_laws import SERVO, command_joints, deflect_brakes, measure_joints
from aftdeck.plant.multibody.view import View
from aftdeck.plant.state import Bodies, PlantState

CALM = 1.8
"""Change of a joint's rate in one step of MuJoCo with the greatest torque, as a multiple of the difference of rates at
which a servo reaches this torque [1]. MuJoCo integrates a torque at its limit explicitly; with 2 or more, it
would jump between both limits from step to step (derived)."""
FINE, FINEST = 2e-4, 8e-6
"""Greatest step of MuJoCo while a brake seizes, and while it slips [s].

When it seizes, its rotor vibrates at 60 to 150 Hz. The torque of a brake that slips falls within a millisecond when it
seizes, and the error of that moment is as long as a step (derived: torques within 5 % of a finer run).
"""
SEIZING, SLIPPING = 0.01, 0.3
"""Deflections of a brake in one step, as shares of that at which it slips, from which it counts as seizing and as
slipping [1] (assumed; the arm that swings on its brakes deflects them by less than a tenth of the first)."""


class Servos:
    """Servos and brakes of one model."""

    def __init__(self, view: View, joints: tuple[str, ...], servo: Servo, period: float, steps: int) -> None:
        """Set up the servos and brakes of a model.

        Args:
            view: the model.
            joints: names of the joints.
            servo: constants of the servos.
            period: control period [s].
            steps: usual number of MuJoCo's steps in a control period.
        """
        model = view.model
        drives = [model.actuator(f"servo.{name}").id for name in joints]
        brakes = [model.actuator(f"brake.{name}").id for name in joints]
        inputs, deflections = model.actuator_ctrladr[drives], model.actuator_actadr[brakes]
        self._view, self._option = view, model.opt
        self._period, self._braked = period, False
        self._places = np.array(
            [view.motors, view.motor_rates, inputs, drives, brakes, deflections]
        )  # rows as in `joint_laws`
        self._servo = np.array(
            [
                servo.hold_gain,
                servo.hold_rate,
                servo.encoder_step,
                servo.tachometer_step,
                servo.torque_limit,
                servo.holding_torque,
                servo.holding_torque / BRAKE_STIFFNESS,
            ]
        )
        self._gains, self._biases = model.actuator_gainprm, model.actuator_biasprm
        armature = model.dof_armature[view.motor_rates]
        calm = CALM * float((armature / -self._biases[self._places[SERVO], 2]).min())
        self._steps = tuple(max(steps, ceil(period / most - 1e-9)) for most in (period / steps, calm, FINE, FINEST))
        self._off = {True: 1 << SERVOS, False: 1 << BRAKES}  # with the brakes on, the servos are off
        self._option.disableactuator = self._off[False]
        self._ctrl, self._force, self._warm = view.data.ctrl, view.data.actuator_force, view.data.qacc_warmstart
        self._act, self._step = view.data.act, period / steps
        self._bounds = np.array([CALM, SEIZING, SLIPPING])

    def begin(self) -> None:
        """Deflect the brakes as the motors turn at the start of a run."""
        deflect_brakes(self._places, self._servo, self._view.qvel, self._step, self._act)

    def command(self, bodies: Bodies, angles: Array, rates: Array, *, brakes: bool, by_angle: bool) -> int:
        """Set the controls of servos and brakes for one control period; return the number of MuJoCo's steps in it.

        It is the usual number, or more if a torque would jump (`CALM`) or a brake seizes or slips (`FINE`, `FINEST`).

        Args:
            bodies: state of the bodies; the angles that the servos hold are updated.
            angles: (n,) measured joint angles [rad].
            rates: (n,) commanded joint rates [rad/s].
            brakes: whether the brakes are on.
            by_angle: whether servos also turn the joints to the angles to which the rates lead.
        """
        if brakes != self._braked:
            self._option.disableactuator, self._braked = self._off[brakes], brakes
        return self._steps[command_joints(
            rates, angles, brakes, by_angle, self._places, self._servo, self._gains, self._biases, self._step,
            self._bounds, self._view.qvel, self._warm, bodies.torques, bodies.holds, self._ctrl, self._act,
        )]  # fmt: skip

    def measure(self, state: PlantState, bodies: Bodies, rates: Array, *, brakes: bool, by_angle: bool) -> None:
        """Measure the joints, and count the commanded rates.

        Args:
            state: output: angles at the joints' outputs, in steps of the encoder, rates of the motors, in steps of the
                tachometer, and commanded angles.
            bodies: state of the bodies; torques and reference rates are written.
            rates: (n,) commanded joint rates [rad/s].
            brakes: whether the brakes are on.
            by_angle: whether servos also turn the joints to the angles to which the rates lead.
        """
        view = self._view
        measure_joints(
            brakes, by_angle, self._places, view.gearboxes, self._servo, self._gains, self._biases,
            self._option.timestep, BRAKE_DAMPING, view.qpos, view.qvel, self._act, self._ctrl, self._force,
            state.angles, state.rates, bodies.holds, bodies.torques, bodies.overdriven,
            rates, self._period, bodies.reference, state.commanded,
        )  # fmt: skip
