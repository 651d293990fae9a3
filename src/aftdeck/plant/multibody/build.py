"""Model of an arm in MuJoCo, with servos, brakes, a free or fixed orbiter, and a payload at the tip.

The world's axes are those of L at the start of the run. There is no gravity.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import mujoco
import numpy as np

from aftdeck.arms.load import ArmModel
from aftdeck.arms.masses import flexibility_needed, servo_needed
from aftdeck.bodies.mass_properties import MassProperties
from aftdeck.plant.multibody.chain import add_arm, set_mass
from aftdeck.plant.multibody.payloads import add_payloads

STEP = 0.002
"""Greatest duration of one step of MuJoCo [s].

In 10 s of brisk motion, the tip is then off by 0.7 mm. With 5 ms, the flexible model diverges.
"""
SERVOS, BRAKES, SLIDES, GEARBOXES = 1, 2, 3, 4
"""Groups of actuators; MuJoCo switches off whole groups."""
BRAKE_STIFFNESS, BRAKE_DAMPING = 1e8, 2e5
"""Stiffness [N m/rad] and damping [N m s/rad] of a brake that does not slip (assumed).

The stiffness is a hundred times that of the Shuttle's gearboxes, so that the arm's frequencies with the brakes on are
those of its own springs. With this damping, MuJoCo's steps of 2 ms are stable.
"""
_DISABLED = int(mujoco.mjtDisableBit.mjDSBL_AUTORESET | mujoco.mjtDisableBit.mjDSBL_ISLAND)
"""What MuJoCo does not do: reset a state that diverged, and look for groups of constraints that are independent of each
other. There are too few constraints to save the time of looking, 6 to 9 % of a step; the result is the same."""
_NO_INPUT = int(mujoco.mjtCtrlInput.mjINPUT_NONE)
_SLOW = 1e-3
"""Rate at which static friction becomes kinetic friction [rad/s]; without effect, because here both are equal."""


def arm_spec(
    model: ArmModel, *, flexible: bool, orbiter: MassProperties | None, payloads: Sequence[MassProperties] = ()
) -> Any:
    """Return MuJoCo's specification of an arm, and of the payloads at the worksite.

    Joints: ``motor.NAME`` and, if flexible, ``gearbox.NAME`` for each joint; those that switches drive have the
    switches' names, ``telescope`` and ``prong``. Actuators: ``servo.NAME``, ``brake.NAME``, ``friction.NAME`` of the
    gearboxes, ``drive.SWITCH``. Bodies: the arm's frames, ``payload`` at the tip, without mass, and ``orbiter`` with
    the joint ``orbiter`` if it is free. The site ``tip`` has the axes of frame 7. With and without a payload, MuJoCo's
    state has the same size.

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
    spec.option.disableflags |= _DISABLED
    spec.compiler.autolimits = False
    parent = spec.worldbody
    if orbiter is not None:
        parent = parent.add_body(name="orbiter")
        parent.add_freejoint(name="orbiter")
        set_mass(parent, orbiter)
    last = add_arm(parent, model, flexible=flexible)
    tip = model.linkage.tip
    last.add_site(name="tip", pos=tip)
    last.add_body(name="payload", pos=tip)
    add_payloads(spec, payloads, model.linkage.frames[-1], parent.name)
    _add_actuators(spec, model, flexible=flexible)
    return spec


def attach(spec: Any, payload: MassProperties) -> None:
    """Give the body at the tip a payload's mass properties, which are in frame 7, with the tip as origin."""
    set_mass(spec.body("payload"), payload)


def _add_actuators(spec: Any, model: ArmModel, *, flexible: bool) -> None:
    servo = servo_needed(model)
    springs = flexibility_needed(model) if flexible else None
    for i, name in enumerate(model.joints):
        _rate_servo(spec, f"servo.{name}", f"motor.{name}", servo.gain[i], servo.torque_limit[i], SERVOS)
        most = servo.holding_torque[i]
        _friction(spec, f"brake.{name}", f"motor.{name}", most, BRAKE_STIFFNESS, BRAKE_DAMPING, BRAKES)
        if springs is not None and springs.friction[i] > 0.0:
            most, stiffness = springs.friction[i], springs.gearboxes[i]
            _friction(
                spec, f"friction.{name}", f"gearbox.{name}", most, stiffness, springs.damping * stiffness, GEARBOXES
            )
    for joint in model.switched:
        if joint.drive is not None:
            _rate_servo(spec, f"drive.{joint.driver}", joint.driver, joint.drive.gain, joint.drive.force, SLIDES)


def _rate_servo(spec: Any, name: str, joint: str, gain: float, most: float, group: int) -> None:
    actuator = _actuator(spec, name, joint, most, group)
    actuator.gainprm[0] = gain
    actuator.biasprm[:3] = [0.0, 0.0, -gain]


def _friction(spec: Any, name: str, joint: str, most: float, stiffness: float, damping: float, group: int) -> None:
    """Add friction of a joint that holds like a spring and slips at the torque `most` [N m].

    It is the friction of Dahl, "Solid friction damping of mechanical vibrations", AIAA Journal 14 (1976): that of
    Canudas de Wit, Olsson, Astrom and Lischinsky, "A new model for control of systems with friction", IEEE Transactions
    on Automatic Control 40 (1995), with equal static and kinetic friction. MuJoCo has it as an actuator without input.
    """
    actuator = _actuator(spec, name, joint, most, group)
    actuator.set_to_dcmotor(
        motorconst=[0.0, 0.0], resistance=1.0, lugre=[stiffness, damping, most, most, _SLOW], ctrlspec=_NO_INPUT
    )


def _actuator(spec: Any, name: str, joint: str, most: float, group: int) -> Any:
    actuator = spec.add_actuator(name=name, target=joint, trntype=mujoco.mjtTrn.mjTRN_JOINT)
    actuator.gaintype, actuator.biastype = mujoco.mjtGain.mjGAIN_FIXED, mujoco.mjtBias.mjBIAS_AFFINE
    actuator.forcelimited, actuator.forcerange = True, [-most, most]
    actuator.group = group
    return actuator
