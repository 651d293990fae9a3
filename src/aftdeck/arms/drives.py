"""Tables of an arm file that only a plant with masses needs: servos, flexibility, links, drives of other parts.

All these tables are optional. `arms.load.ArmModel` has their values as arrays; `arms.links` uses the links.
"""

from __future__ import annotations

from typing import Annotated, TypeVar

from aftdeck.arms.constant import Constant, Part
from aftdeck.bounds import Bounds
from aftdeck.units import (
    Angle,
    AngularDamping,
    AngularRate,
    AngularStiffness,
    FlexuralRigidity,
    Force,
    Length,
    LinearDamping,
    Mass,
    MomentOfInertia,
    Time,
    Torque,
)

_T = TypeVar("_T")
ByJoint = tuple[_T, ...]
"""Values of the joints, from base to tip. `arms.dynamics` checks that there is one for each joint."""

GearRatio = Annotated[float, Bounds(1.0, 1e5, "the Shuttle's joints have ratios of 739 to 1842")]
"""Turns of the motor for one turn of the joint."""
RotorInertia = Annotated[MomentOfInertia, Bounds(1e-9, 10.0, "the rotor of a motor of 100 W has about 1e-4 kg m2")]
"""Moment of inertia of a motor's rotor about its axis."""
JointTorque = Annotated[Torque, Bounds(1e-6, 1e6, "the Shuttle's shoulder gives 1,000 N m, Canadarm2's about 3,000")]
"""Torque at a joint's output."""
Friction = Annotated[Torque, Bounds(0.0, 1e5, "a joint overcomes its own friction")]
"""Torque of Coulomb friction at a joint's output; 0 for none."""
ServoGain = Annotated[AngularDamping, Bounds(1e-6, 1e10, "the Shuttle's shoulder servo has about 1e6 N m s/rad")]
"""Torque of a rate servo for each rad/s of rate error."""
HoldGain = Annotated[
    float, Bounds(0.0, 100.0, "at 100 1/s a joint returns faster than the control period resolves", "1/s")
]
"""Rate that position hold commands for each radian of displacement; 0 to switch position hold off."""
HoldShare = Annotated[float, Bounds(0.0, 1.0, "position hold cannot exceed the rate limit")]
"""Greatest rate that position hold commands, as a share of the joint's servo maximum."""
AngleStep = Annotated[Angle, Bounds(0.0, 0.1, "an encoder with 6 bits has steps of 0.1 rad; 0 is exact")]
"""Step of an encoder; 0 if the measured angle is exact."""
RateStep = Annotated[AngularRate, Bounds(0.0, 0.1, "a joint's greatest rates are about 0.1 rad/s; 0 is exact")]
"""Step of a tachometer, as a rate of the joint; 0 if the measured rate is exact."""


class ServoFile(Part, frozen=True):
    """Servos and brakes of the joints. Torques, gains, rates and angles are those of the joint's output."""

    gear_ratio: Constant[ByJoint[GearRatio]]
    motor_inertia: Constant[ByJoint[RotorInertia]]
    """Moment of inertia of the motor's rotor; the joint has this value times the square of the gear ratio."""
    gain: Constant[ByJoint[ServoGain]]
    torque_limit: Constant[ByJoint[JointTorque]]
    """Greatest torque of the motor; a greater load drives the joint back."""
    friction: Constant[ByJoint[Friction]]
    holding_torque: Constant[ByJoint[JointTorque]]
    """Torque above which the brake slips; at least the torque limit."""
    hold_gain: Constant[ByJoint[HoldGain]]
    hold_share: Constant[ByJoint[HoldShare]]
    encoder_step: Constant[ByJoint[AngleStep]]
    tachometer_step: Constant[ByJoint[RateStep]]


GearboxStiffness = Annotated[
    AngularStiffness, Bounds(1.0, 1e10, "the Shuttle's gearboxes have about 1e6 N m/rad, a small arm's about 1e3")
]
BeamRigidity = Annotated[
    FlexuralRigidity, Bounds(1e-3, 1e12, "the Shuttle's booms have about 4e6 N m2, a steel rod of 1 cm 100")
]
"""Rigidity of a boom: EI for bending, GJ for torsion."""
DampingTime = Annotated[Time, Bounds(0.0, 1.0, "with 1 s, a mode of 0.3 Hz is damped critically")]
"""Damping of a spring divided by its stiffness."""


class FlexibilityFile(Part, frozen=True):
    """Springs of a flexible arm: gearboxes, booms, and the base between the vehicle and the first joint."""

    gearboxes: Constant[ByJoint[GearboxStiffness]]
    booms_bending: Constant[tuple[BeamRigidity, BeamRigidity]]
    """EI of upper and lower boom, equal in both planes."""
    booms_torsion: Constant[tuple[BeamRigidity, BeamRigidity]]
    """GJ of upper and lower boom."""
    base: Constant[tuple[GearboxStiffness, GearboxStiffness, GearboxStiffness]]
    """Stiffness of the base about x, y and z of L."""
    damping: Constant[DampingTime]
    friction: Constant[ByJoint[Friction]] | None = None
    """Friction in the gearboxes, which acts while their windup changes; without it, they have no friction."""


Radius = Annotated[Length, Bounds(0.0005, 10.0, "the Shuttle's booms have a radius of 0.19 m")]
LinkInertia = Annotated[MomentOfInertia, Bounds(1e-9, 1e7, "the Shuttle's booms have about 1000 kg m2")]
_Seven = tuple[_T, _T, _T, _T, _T, _T, _T]
"""Values of the links: foot, shoulder, both booms, the links behind wrist pitch and wrist yaw, end effector."""


class LinksFile(Part, frozen=True):
    """Moments of inertia and sizes of the links, for the family of the Shuttle's arm (`arms.links`).

    A link extends from its joint to the next one; the foot from the vehicle to the first joint.
    """

    inertia: Constant[_Seven[tuple[LinkInertia, LinkInertia, LinkInertia]]]
    """Moments of inertia about the joint at which a link begins: along the link, about the pitch axis, across both."""
    foot: Constant[Annotated[Length, Bounds(1e-3, 200.0, "the Shuttle's arm is 15 m long")]]
    """Length of the foot, which is below the first joint."""
    boom_radius: Constant[Radius]
    """Radius of the uniform cylinder that represents a boom."""
    wrist_yaw_to_roll: Constant[Annotated[Length, Bounds(1e-3, 200.0, "the Shuttle's arm is 15 m long")]]
    """Distance of the wrist roll joint from the wrist yaw joint; the end effector begins there."""
    centre: Constant[_Seven[Annotated[Length, Bounds(0.0, 200.0, "the Shuttle's booms are 7 m long")]]] | None = None
    """Distance of each link's centre of mass from its joint; without it, `arms.links` has the rule."""


DriveForce = Annotated[Force, Bounds(1e-3, 1e6, "a telescope that moves 7 t by 1 ft/s within 1 s needs 2,000 N")]
DriveGain = Annotated[LinearDamping, Bounds(1e-3, 1e9, "a telescope's servo has about 1e4 N s/m")]


class SlidesFile(Part, frozen=True):
    """Drives of telescope and prong, for the family of the concept arm of 1972."""

    telescope_mass: Constant[Annotated[Mass, Bounds(0.001, 1e5, "the concept arm has 408 kg")]]
    """Mass of the tube that carries the shoulder."""
    telescope_gain: Constant[DriveGain]
    telescope_force: Constant[DriveForce]
    prong_gain: Constant[DriveGain]
    prong_force: Constant[DriveForce]
