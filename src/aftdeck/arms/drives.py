"""Tables of an arm file that only a plant with masses needs: servos and springs of the joints.

Both tables are optional. `arms.load.ArmModel` has their values as arrays.
"""

from __future__ import annotations

from typing import Annotated, TypeVar

from aftdeck.arms.constant import Constant, Part
from aftdeck.bounds import Bounds
from aftdeck.units import (
    AngularStiffness,
    Coordinate,
    CoordinateRate,
    JointDamping,
    JointEffort,
    JointStiffness,
    MomentOfInertia,
    Time,
)

_T = TypeVar("_T")
ByJoint = tuple[_T, ...]
"""Values of the joints that steering drives, from base to tip; `arms.dynamics` checks their number and units."""

GearRatio = Annotated[float, Bounds(1.0, 1e5, "the Shuttle's joints have ratios of 739 to 1842")]
"""Turns of the motor for one turn of the joint."""
RotorInertia = Annotated[MomentOfInertia, Bounds(1e-9, 10.0, "the rotor of a motor of 100 W has about 1e-4 kg m2")]
"""Moment of inertia of a motor's rotor about its axis."""
JointTorque = Annotated[
    JointEffort, Bounds(1e-6, 1e6, "the Shuttle's shoulder gives 1,000 N m, Canadarm2's about 3,000")
]
"""Torque at a joint's output."""
Friction = Annotated[JointEffort, Bounds(0.0, 1e5, "a joint overcomes its own friction")]
"""Torque of Coulomb friction at a joint's output; 0 for none."""
ServoGain = Annotated[JointDamping, Bounds(1e-6, 1e10, "the Shuttle's shoulder servo has about 1e6 N m s/rad")]
"""Torque of a rate servo for each rad/s of rate error."""
HoldGain = Annotated[
    float, Bounds(0.0, 100.0, "at 100 1/s a joint returns faster than the control period resolves", "1/s")
]
"""Rate that position hold commands for each radian of displacement; 0 to switch position hold off."""
HoldShare = Annotated[float, Bounds(0.0, 1.0, "position hold cannot exceed the rate limit")]
"""Greatest rate that position hold commands, as a share of the joint's servo maximum."""
AngleStep = Annotated[Coordinate, Bounds(0.0, 0.1, "an encoder with 6 bits has steps of 0.1 rad; 0 is exact")]
"""Step of an encoder; 0 if the measured angle is exact."""
RateStep = Annotated[CoordinateRate, Bounds(0.0, 0.1, "a joint's greatest rates are about 0.1 rad/s; 0 is exact")]
"""Step of a tachometer, as a rate of the joint; 0 if the measured rate is exact."""


class ServoFile(Part, frozen=True):
    """Servos and brakes of the joints. Torques, gains, rates and angles are those of the joint's output.

    A joint that slides has forces, and lengths in place of angles; its gear ratio is in rad/m.
    """

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


_STIFF = Bounds(1.0, 1e10, "the Shuttle's gearboxes have about 1e6 N m/rad, a small arm's about 1e3")
GearboxStiffness = Annotated[JointStiffness, _STIFF]
BaseStiffness = Annotated[AngularStiffness, _STIFF]
DampingTime = Annotated[Time, Bounds(0.0, 1.0, "with 1 s, a mode of 0.3 Hz is damped critically")]
"""Damping of a spring divided by its stiffness."""


class FlexibilityFile(Part, frozen=True):
    """Springs of a flexible arm besides its booms: gearboxes, and the base between the vehicle and the first joint."""

    gearboxes: Constant[ByJoint[GearboxStiffness]]
    base: Constant[tuple[BaseStiffness, BaseStiffness, BaseStiffness]]
    """Stiffness of the base about x, y and z of L."""
    damping: Constant[DampingTime]
    friction: Constant[ByJoint[Friction]] | None = None
    """Friction in the gearboxes, which acts while their windup changes; without it, they have no friction."""
