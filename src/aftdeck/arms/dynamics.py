"""Values that a plant with masses uses besides the masses: servos and springs of an arm, as arrays."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arms.by_joint import misfits
from aftdeck.arms.drives import ServoFile
from aftdeck.arms.geometry import frozen
from aftdeck.arms.joints import Turn
from aftdeck.arms.limits import JointRates
from aftdeck.arms.link_file import RodLink
from aftdeck.arms.model import ArmFile
from aftdeck.arrays import Array
from aftdeck.files import Problem


class Servo(NamedTuple):
    """Servos and brakes of the joints, at the joints' outputs. Arrays are read-only, (n,).

    Attributes:
        armature: inertia of the motor's rotor as the joint feels it, J N^2 [kg m2].
        gain: torque for each rad/s of rate error [N m s/rad].
        torque_limit: greatest torque of the motor [N m].
        friction: torque of Coulomb friction [N m].
        holding_torque: torque above which the brake slips [N m].
        hold_gain: rate that position hold commands for each radian of displacement [1/s].
        hold_rate: greatest rate that position hold commands [rad/s].
        encoder_step: step of the measured angle [rad]; 0 if it is exact.
        tachometer_step: step of the measured rate [rad/s]; 0 if it is exact.
    """

    armature: Array
    gain: Array
    torque_limit: Array
    friction: Array
    holding_torque: Array
    hold_gain: Array
    hold_rate: Array
    encoder_step: Array
    tachometer_step: Array


class Flexibility(NamedTuple):
    """Springs of an arm. Arrays are read-only.

    Attributes:
        gearboxes: (n,) stiffness of the gearboxes [N m/rad].
        bending: (b,) EI of the booms, from base to tip [N m2].
        torsion: (b,) GJ of the booms [N m2].
        base: (3,) stiffness of the base about x, y and z of L [N m/rad].
        friction: (n,) torque of friction in the gearboxes while their windup changes [N m]; 0 for none.
        damping: damping of each spring divided by its stiffness [s].
    """

    gearboxes: Array
    bending: Array
    torsion: Array
    base: Array
    friction: Array
    damping: float


def servo_of(file: ArmFile, rates: JointRates) -> Servo | None:
    """Return the servos of a file's arm; None if the file has no table `servo`."""
    s = file.servo
    if s is None:
        return None
    return Servo(
        frozen([j * n * n for j, n in zip(s.motor_inertia.value, s.gear_ratio.value, strict=True)]),
        frozen(s.gain.value),
        frozen(s.torque_limit.value),
        frozen(s.friction.value),
        frozen(s.holding_torque.value),
        frozen(s.hold_gain.value),
        frozen(frozen(s.hold_share.value) * rates.servo),
        frozen(s.encoder_step.value),
        frozen(s.tachometer_step.value),
    )


def flexibility_of(file: ArmFile) -> Flexibility | None:
    """Return the springs of a file's arm; None if the file has no table `flexibility`."""
    f, booms = file.flexibility, booms_of(file)
    if f is None:
        return None
    return Flexibility(
        frozen(f.gearboxes.value),
        frozen([boom.bending for _, boom in booms]),
        frozen([boom.torsion for _, boom in booms]),
        frozen(f.base.value),
        frozen(np.zeros(len(file.joints)) if f.friction is None else f.friction.value),
        float(f.damping.value),
    )


def booms_of(file: ArmFile) -> list[tuple[int, RodLink]]:
    """Return the links that bend on a flexible arm, each with the number of its joint in the file."""
    links = [(i, joint.link) for i, joint in enumerate(file.joint) if isinstance(joint, Turn)]
    return [(i, link) for i, link in links if isinstance(link, RodLink) and link.radius is not None]


def drive_problems(file: ArmFile) -> list[Problem]:
    """Return a problem for each list without one value for each joint; else, for each brake weaker than its motor."""
    found = [
        Problem((table, name, "value", *where), why)
        for table, names in (("servo", ServoFile.__struct_fields__), ("flexibility", ("gearboxes", "friction")))
        for name in names
        if (constant := getattr(getattr(file, table, None), name, None))
        for where, why in misfits(file.joints, file.slides, constant.value)
    ]
    if file.flexibility is not None:
        found += [
            Problem(("joint", i, "link"), f"{boom.part}: a boom of a flexible arm needs `{name}`")
            for i, boom in booms_of(file)
            for name in ("bending", "torsion")
            if getattr(boom, name) is None
        ]
    return found or ([] if file.servo is None else _brake_problems(file.joints, file.servo))


def _brake_problems(joints: tuple[str, ...], servo: ServoFile) -> list[Problem]:
    return [
        Problem(
            ("servo", "holding_torque", "value", i),
            f"{joint}: the brake has to hold at least what the motor gives, {motor:g} N*m or N; got {brake:g}",
        )
        for i, (joint, motor, brake) in enumerate(
            zip(joints, servo.torque_limit.value, servo.holding_torque.value, strict=True)
        )
        if brake < motor
    ]
