"""Model of an arm in MuJoCo, with servos, brakes, a free or fixed orbiter, and a payload at the tip.

The world's axes are those of L at the start of the run. There is no gravity.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import mujoco
import numpy as np

from aftdeck.arms.load import ArmModel
from aftdeck.arms.masses import servo_needed
from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import MassProperties
from aftdeck.plant.multibody.chain import add_arm, set_mass
from aftdeck.plant.multibody.payloads import add_payloads

STEP = 0.002
"""Greatest duration of one step of MuJoCo [s].

In 10 s of brisk motion, the tip is then off by 0.7 mm. With 5 ms, the flexible model diverges.
"""
SERVOS, BRAKES, SLIDES = 1, 2, 3
"""Groups of actuators; MuJoCo switches off whole groups."""
BRAKE_STIFFNESS, BRAKE_DAMPING = 1e6, 2e5
"""Stiffness [N m/rad] and damping [N m s/rad] of a brake that holds: 0.09 deg at the holding torque of the
Shuttle's shoulder, 1573 N m (assumed)."""


def arm_spec(
    model: ArmModel, *, flexible: bool, orbiter: MassProperties | None, payloads: Sequence[MassProperties] = ()
) -> Any:
    """Return MuJoCo's specification of an arm, and of the payloads at the worksite.

    Joints: ``motor.NAME`` and, if flexible, ``gearbox.NAME`` for each joint; ``telescope`` and ``prong`` if the arm has
    them. Actuators: ``servo.NAME``, ``brake.NAME``, ``drive.telescope``, ``drive.prong``. Bodies: the arm's frames,
    ``payload`` at the tip, without mass, and ``orbiter`` with the joint ``orbiter`` if it is free. The site ``tip`` has
    the axes of frame 7. With and without a payload, MuJoCo's state has the same size.

    Args:
        model: the arm.
        flexible: whether gearboxes, booms and base bend.
        orbiter: the orbiter that carries the arm and reacts to its motion, in L; None if the arm's base is fixed.
        payloads: mass properties of the worksite's payloads, each in its own frame (`multibody.payloads`).

    Raises:
        ArmError: the arm's file lacks a table that this model needs.
    """
    spec = mujoco.MjSpec()
    spec.option.gravity = np.zeros(3)
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.option.timestep = STEP
    spec.option.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_AUTORESET)
    spec.compiler.autolimits = False
    parent = spec.worldbody
    if orbiter is not None:
        parent = parent.add_body(name="orbiter")
        parent.add_freejoint(name="orbiter")
        set_mass(parent, orbiter)
    last = add_arm(parent, model, flexible=flexible)
    tip = [float(model.links[4]), 0.0, 0.0]
    last.add_site(name="tip", pos=tip)
    last.add_body(name="payload", pos=tip)
    add_payloads(spec, payloads, model.linkage.frames[-1], parent.name)
    _add_actuators(spec, model)
    return spec


def attach(spec: Any, payload: MassProperties) -> None:
    """Give the body at the tip a payload's mass properties, which are in frame 7, with the tip as origin."""
    set_mass(spec.body("payload"), payload)


def _add_actuators(spec: Any, model: ArmModel) -> None:
    servo, slides = servo_needed(model), model.slides
    for i, name in enumerate(model.joints):
        _rate_servo(spec, f"servo.{name}", f"motor.{name}", servo.gain[i], servo.torque_limit[i], SERVOS)
        brake = _actuator(spec, f"brake.{name}", f"motor.{name}", servo.holding_torque[i], BRAKES)
        brake.gainprm[0] = BRAKE_STIFFNESS
        brake.biasprm[:3] = [0.0, -BRAKE_STIFFNESS, -BRAKE_DAMPING]
    if slides is not None:
        _rate_servo(spec, "drive.telescope", "telescope", slides.telescope_gain, slides.telescope_force, SLIDES)
        _rate_servo(spec, "drive.prong", "prong", slides.prong_gain, slides.prong_force, SLIDES)


def _rate_servo(spec: Any, name: str, joint: str, gain: float, most: float, group: int) -> None:
    actuator = _actuator(spec, name, joint, most, group)
    actuator.gainprm[0] = gain
    actuator.biasprm[:3] = [0.0, 0.0, -gain]


def _actuator(spec: Any, name: str, joint: str, most: float, group: int) -> Any:
    actuator = spec.add_actuator(name=name, target=joint, trntype=mujoco.mjtTrn.mjTRN_JOINT)
    actuator.gaintype, actuator.biastype = mujoco.mjtGain.mjGAIN_FIXED, mujoco.mjtBias.mjBIAS_AFFINE
    actuator.forcelimited, actuator.forcerange = True, [-most, most]
    actuator.group = group
    return actuator


def in_tip_frame(mass: float, centre: Array, rotation: Array, inertia: Array) -> MassProperties:
    """Return a payload's mass properties in frame 7, from its centre in frame 7 and its inertia in payload axes."""
    return MassProperties(mass, centre, rotation @ inertia @ rotation.T)
