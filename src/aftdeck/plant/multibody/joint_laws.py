"""Laws between steering and MuJoCo's arrays: commands of servos and brakes, measurements, and poses in L."""

from __future__ import annotations

import math

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.pose import POSE, relative
from aftdeck.elementary import nearest
from aftdeck.kinematics.bending import measure_bend
from aftdeck.law import law

NONE = math.nan
"""Angle of a joint that no servo or brake holds."""
AT_LIMIT = 1.0 - 1e-9
"""Share of the greatest torque from which a motor or a brake counts as at its limit [1]."""


MOTOR, RATE, SERVO, BRAKE = range(4)
"""Rows of the joints' places: motor in MuJoCo's positions, its rate in the velocities, servo and brake in the controls.

A motor's servo and brake have the same places in MuJoCo's actuators as in the controls.
"""
HOLD_GAIN, HOLD_RATE, ENCODER, TACHOMETER, TORQUE, HOLDING = range(6)
"""Rows of the joints' constants: `Servo.hold_gain`, `hold_rate`, `encoder_step`, `tachometer_step`, `torque_limit` and
`holding_torque`."""


@law
def command_joints(
    rates: Array,
    angles: Array,
    braked: bool,
    places: Indices,
    servo: Array,
    qpos: Array,
    holds: Array,
    held: Array,
    ctrl: Array,
) -> None:
    """Command servos and brakes.

    A servo turns its joint at the given rate, or holds its position while the joint is not commanded. A brake holds the
    angle that its motor had when the brakes were set.

    Args:
        rates: (6,) commanded joint rates [rad/s].
        angles: (6,) measured joint angles [rad].
        braked: whether the brakes are on; then no servo holds its joint.
        places: (4, 6) places of the joints in MuJoCo's arrays.
        servo: (6, 6) constants of the joints.
        qpos: MuJoCo's positions.
        holds: (6,) angles that the servos hold [rad], `NONE` for no hold; updated.
        held: (6,) angles of the motors that the brakes hold [rad], `NONE` while the brakes are off; updated.
        ctrl: MuJoCo's controls; written.
    """
    for i in range(6):
        if braked or rates[i] != 0.0:
            holds[i] = NONE
            ctrl[places[SERVO, i]] = rates[i]
        else:
            if holds[i] != holds[i]:
                holds[i] = angles[i]
            back, most = servo[HOLD_GAIN, i] * (holds[i] - angles[i]), servo[HOLD_RATE, i]
            ctrl[places[SERVO, i]] = min(max(back, -most), most)
        if not braked:
            held[i] = NONE
        elif held[i] != held[i]:
            held[i] = qpos[places[MOTOR, i]]
        ctrl[places[BRAKE, i]] = held[i] if braked else 0.0


@law
def measure_joints(
    braked: bool,
    places: Indices,
    gearboxes: Indices,
    servo: Array,
    stiffness: float,
    qpos: Array,
    qvel: Array,
    force: Array,
    angles: Array,
    rates: Array,
    held: Array,
    torques: Array,
    overdriven: Mask,
    given: Array,
    period: float,
    reference: Array,
    commanded: Array,
) -> None:
    """Measure angles at the joints' outputs, rates of the motors, and torques of the acting servos or brakes.

    Angles and rates are measured in steps; a step of 0 is exact. Brakes slip that are at their holding torque. Also
    count the commanded rates.

    Args:
        braked: whether the brakes are on.
        places: (4, 6) places of the joints in MuJoCo's arrays.
        gearboxes: (6,) places of the gearboxes' windup; (0,) if the model is rigid.
        servo: (6, 6) constants of the joints.
        stiffness: stiffness of a brake [N m/rad].
        qpos: MuJoCo's positions.
        qvel: MuJoCo's velocities.
        force: MuJoCo's forces of the actuators [N m].
        angles: (6,) output [rad].
        rates: (6,) output [rad/s].
        held: (6,) angles that the brakes hold [rad]; updated. `NONE` while the brakes are off.
        torques: (6,) output [N m].
        overdriven: (6,) output: 1 for a joint that turns against its motor or brake at its greatest torque.
        given: (6,) commanded joint rates [rad/s].
        period: control period [s].
        reference: (6,) output: rates from which the steering's acceleration limits count [rad/s].
        commanded: (6,) angles that the joints would have without stops [rad]; updated.
    """
    acting, greatest = (BRAKE, HOLDING) if braked else (SERVO, TORQUE)
    for i in range(6):
        motor, rate = qpos[places[MOTOR, i]], qvel[places[RATE, i]]
        angle = motor + qpos[gearboxes[i]] if gearboxes.shape[0] > 0 else motor
        encoder, tachometer = servo[ENCODER, i], servo[TACHOMETER, i]
        angles[i] = angle if encoder == 0.0 else nearest(angle / encoder) * encoder
        rates[i] = rate if tachometer == 0.0 else nearest(rate / tachometer) * tachometer
        torque, most = force[places[acting, i]], servo[greatest, i]
        torques[i] = torque
        overdriven[i] = abs(torque) >= AT_LIMIT * most and rate * torque < 0.0
        if held[i] == held[i]:
            give = most / stiffness
            held[i] = min(max(held[i], motor - give), motor + give)
        reference[i] = given[i]
        commanded[i] += given[i] * period


@law
def poses_in_base(orbiter: int, bodies: Indices, xpos: Array, xmat: Array, base: Array, rows: Array) -> None:
    """Write the pose of L in the world, and the poses of bodies in L.

    Args:
        orbiter: number of the body whose frame is L; -1 if L does not move, and `base` keeps its pose.
        bodies: (n,) numbers of the bodies.
        xpos: (b, 3) MuJoCo's positions of all bodies in the world [m].
        xmat: (b, 9) MuJoCo's rotations of all bodies, row by row.
        base: (12,) pose of L in the world; updated.
        rows: (n, 12) output.
    """
    if orbiter >= 0:
        base[:3], base[3:] = xpos[orbiter], xmat[orbiter]
    pose = np.empty(POSE)
    for n in range(bodies.shape[0]):
        pose[:3], pose[3:] = xpos[bodies[n]], xmat[bodies[n]]
        relative(base, pose, rows[n])


@law
def bends_of(
    frames: Indices,
    carriers: Indices,
    beyond: Indices,
    xpos: Array,
    xmat: Array,
    own: Array,
    ends: Array,
    bends: Array,
) -> None:
    """Write the bends of the arm's parts from MuJoCo's present poses.

    Args:
        frames: (n,) numbers of the bodies of the arm's frames.
        carriers: (b,) index in `frames` of the frame that carries each part.
        beyond: (b,) number of the body that is fixed to each part's end.
        xpos: (b, 3) MuJoCo's positions of all bodies in the world [m].
        xmat: (b, 9) MuJoCo's rotations of all bodies, row by row.
        own: (b, 3) place of each part's end in the body that is fixed to it [m].
        ends: (b, 3) place of each straight part's end in the frame that carries it [m].
        bends: (b, 6) output.
    """
    carrier, end = np.empty(POSE), np.empty(POSE)
    for n in range(carriers.shape[0]):
        body = frames[carriers[n]]
        carrier[:3], carrier[3:] = xpos[body], xmat[body]
        end[:3], end[3:] = xpos[beyond[n]], xmat[beyond[n]]
        measure_bend(carrier, end, own[n], ends[n], bends[n])
