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


@law
def command_servos(
    rates: Array, angles: Array, braked: bool, gain: Array, most: Array, holds: Array, drives: Indices, ctrl: Array
) -> None:
    """Command the servos: the given rate, or position hold while a joint is not commanded.

    Args:
        rates: (6,) commanded joint rates [rad/s].
        angles: (6,) measured joint angles [rad].
        braked: whether the brakes are on; then no servo holds its joint.
        gain: (6,) rate of position hold for each radian [1/s].
        most: (6,) greatest rate of position hold [rad/s].
        holds: (6,) held angles [rad], `NONE` for no hold; updated.
        drives: (6,) places of the servos in MuJoCo's controls.
        ctrl: MuJoCo's controls; written.
    """
    for i in range(6):
        if braked or rates[i] != 0.0:
            holds[i] = NONE
            ctrl[drives[i]] = rates[i]
        else:
            if holds[i] != holds[i]:
                holds[i] = angles[i]
            back = gain[i] * (holds[i] - angles[i])
            ctrl[drives[i]] = min(max(back, -most[i]), most[i])


@law
def command_brakes(braked: bool, motors: Indices, qpos: Array, held: Array, brakes: Indices, ctrl: Array) -> None:
    """Command the brakes: each holds the angle that its motor had when the brakes were set.

    Args:
        braked: whether the brakes are on.
        motors: (6,) places of the motors in MuJoCo's positions.
        qpos: MuJoCo's positions.
        held: (6,) held angles of the motors [rad], `NONE` while the brakes are off; updated.
        brakes: (6,) places of the brakes in MuJoCo's controls.
        ctrl: MuJoCo's controls; written.
    """
    for i in range(6):
        if not braked:
            held[i] = NONE
        elif held[i] != held[i]:
            held[i] = qpos[motors[i]]
        ctrl[brakes[i]] = held[i] if braked else 0.0


@law
def measure_joints(
    motors: Indices,
    motor_rates: Indices,
    qpos: Array,
    qvel: Array,
    gearboxes: Indices,
    encoder: Array,
    tachometer: Array,
    angles: Array,
    rates: Array,
) -> None:
    """Measure angles at the joints' outputs and rates of the motors, each in steps; a step of 0 is exact.

    Args:
        motors: (6,) places of the motors in MuJoCo's positions.
        motor_rates: (6,) places of the motors in MuJoCo's velocities.
        qpos: MuJoCo's positions.
        qvel: MuJoCo's velocities.
        gearboxes: (6,) places of the gearboxes' windup; (0,) if the model is rigid.
        encoder: (6,) steps of the angles [rad].
        tachometer: (6,) steps of the rates [rad/s].
        angles: (6,) output [rad].
        rates: (6,) output [rad/s].
    """
    for i in range(6):
        angle, rate = qpos[motors[i]], qvel[motor_rates[i]]
        if gearboxes.shape[0] > 0:
            angle += qpos[gearboxes[i]]
        angles[i] = angle if encoder[i] == 0.0 else nearest(angle / encoder[i]) * encoder[i]
        rates[i] = rate if tachometer[i] == 0.0 else nearest(rate / tachometer[i]) * tachometer[i]


@law
def measure_torques(
    acting: Indices,
    force: Array,
    most: Array,
    motors: Indices,
    motor_rates: Indices,
    qpos: Array,
    qvel: Array,
    stiffness: float,
    held: Array,
    torques: Array,
    overdriven: Mask,
) -> None:
    """Measure the torques of servos or brakes, and let brakes slip that are at their holding torque.

    Args:
        acting: (6,) places of the acting servos or brakes in MuJoCo's actuators.
        force: MuJoCo's forces of the actuators [N m].
        most: (6,) greatest torques [N m].
        motors: (6,) places of the motors in MuJoCo's positions.
        motor_rates: (6,) places of the motors in MuJoCo's velocities.
        qpos: MuJoCo's positions.
        qvel: MuJoCo's velocities.
        stiffness: stiffness of a brake [N m/rad].
        held: (6,) angles that the brakes hold [rad]; updated. `NONE` while the brakes are off.
        torques: (6,) output [N m].
        overdriven: (6,) output: 1 for a joint that turns against its motor or brake at its greatest torque.
    """
    for i in range(6):
        torque, angle = force[acting[i]], qpos[motors[i]]
        torques[i] = torque
        overdriven[i] = abs(torque) >= AT_LIMIT * most[i] and qvel[motor_rates[i]] * torque < 0.0
        if held[i] == held[i]:
            give = most[i] / stiffness
            held[i] = min(max(held[i], angle - give), angle + give)


@law
def poses_in_base(base: Array, bodies: Indices, xpos: Array, xmat: Array, rows: Array) -> None:
    """Write the poses of bodies in L.

    Args:
        base: (12,) pose of L in the world.
        bodies: (n,) numbers of the bodies.
        xpos: (b, 3) MuJoCo's positions of all bodies in the world [m].
        xmat: (b, 9) MuJoCo's rotations of all bodies, row by row.
        rows: (n, 12) output.
    """
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
