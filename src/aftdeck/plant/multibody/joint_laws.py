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
"""Angle of a joint that no servo holds."""
AT_LIMIT = 1.0 - 1e-9
"""Share of the greatest torque from which a motor or a brake counts as at its limit [1]."""


MOTOR, RATE, INPUT, SERVO, BRAKE, DEFLECTION = range(6)
"""Rows of the joints' places: motor in MuJoCo's positions, its rate in the velocities, input of its servo in the
controls, servo and brake in the actuators, and deflection of the brake in the activations."""
HOLD_GAIN, HOLD_RATE, ENCODER, TACHOMETER, TORQUE, HOLDING, GIVE = range(7)
"""Rows of the joints' constants: `Servo.hold_gain`, `hold_rate`, `encoder_step`, `tachometer_step`, `torque_limit`,
`holding_torque`, and the deflection at which a brake slips."""


@law
def deflect_brakes(places: Indices, servo: Array, qvel: Array, step: float, act: Array) -> None:
    """Deflect the brakes as the motors do in the given time, so that brakes slip at once if they are set in motion.

    Args:
        places: (6, n) places of the joints in MuJoCo's arrays.
        servo: (7, n) constants of the joints.
        qvel: MuJoCo's velocities.
        step: time of the deflection [s].
        act: MuJoCo's activations; the brakes' deflections [rad] are written.
    """
    for i in range(places.shape[1]):
        turned, most = qvel[places[RATE, i]] * step, servo[GIVE, i]
        act[places[DEFLECTION, i]] = min(max(turned, -most), most)


@law
def _wanted(i: int, places: Indices, gains: Array, biases: Array, ctrl: Array, rate: float) -> float:
    """Return the torque of a servo without its limit [N m].

    Args:
        i: number of the joint.
        places: (6, n) places of the joints in MuJoCo's arrays.
        gains: (a, 10) MuJoCo's gains of all actuators.
        biases: (a, 10) MuJoCo's biases of all actuators; the third column is by rate.
        ctrl: MuJoCo's controls.
        rate: rate of the motor [rad/s].
    """
    actuator = places[SERVO, i]
    torque: float = gains[actuator, 0] * ctrl[places[INPUT, i]] + biases[actuator, 2] * rate
    return torque


@law
def _jumps(
    places: Indices,
    servo: Array,
    gains: Array,
    biases: Array,
    step: float,
    least: float,
    qvel: Array,
    acceleration: Array,
    ctrl: Array,
    torques: Array,
) -> bool:
    """Return whether the torque of a motor would jump between its limits in the coming control period.

    This can be so if the torque has just reached its limit, and it is so if the last step changed the rate by too much.
    A joint whose limited torque balances a load changes its rate by less.

    Args:
        places: (6, n) places of the joints in MuJoCo's arrays.
        servo: (7, n) constants of the joints.
        gains: as in `_wanted`; biases and ctrl likewise.
        biases: (a, 10).
        step: duration of MuJoCo's steps [s].
        least: change of the torque without its limit in a step, from which the limited torque jumps, as a multiple of
            the limit [1].
        qvel: MuJoCo's velocities.
        acceleration: MuJoCo's accelerations in its last step.
        ctrl: MuJoCo's controls.
        torques: (n,) torques at the end of the last control period [N m].
    """
    for i in range(places.shape[1]):
        rate, most = places[RATE, i], servo[TORQUE, i]
        wanted = _wanted(i, places, gains, biases, ctrl, qvel[rate])
        if abs(wanted) < most:
            continue
        stays = wanted * torques[i] >= AT_LIMIT * most * abs(wanted)
        if not stays or abs(biases[places[SERVO, i], 2] * acceleration[rate]) * step >= least * most:
            return True
    return False


@law
def _deflected(places: Indices, servo: Array, step: float, qvel: Array) -> float:
    """Return the greatest deflection of a brake in one step, as a share of that at which it slips [1].

    Args:
        places: (6, n) places of the joints in MuJoCo's arrays.
        servo: (7, n) constants of the joints.
        step: duration of MuJoCo's steps [s].
        qvel: MuJoCo's velocities.
    """
    greatest = 0.0
    for i in range(places.shape[1]):
        greatest = max(greatest, abs(qvel[places[RATE, i]]) * step / servo[GIVE, i])
    return greatest


USUAL, JUMPS, SEIZES, SLIPS = range(4)
"""What decides how fine MuJoCo's steps have to be: nothing; a servo's torque that would jump from limit to limit; a
brake that seizes, with vibrations of its rotor; a brake that slips."""


@law
def command_joints(
    rates: Array,
    angles: Array,
    braked: bool,
    by_angle: bool,
    places: Indices,
    servo: Array,
    gains: Array,
    biases: Array,
    step: float,
    bounds: Array,
    qvel: Array,
    acceleration: Array,
    torques: Array,
    holds: Array,
    ctrl: Array,
    act: Array,
) -> int:
    """Command servos and brakes; return what decides how fine the steps of the coming control period have to be.

    A servo turns its joint at the given rate, or holds its position while the joint is not commanded. With `by_angle`,
    it turns the joint at the given rate and towards the angle to which the rates lead.

    Args:
        rates: (n,) commanded joint rates [rad/s].
        angles: (n,) measured joint angles [rad].
        braked: whether the brakes are on; then no servo holds its joint.
        by_angle: whether servos also turn the joints to the angles to which the rates lead.
        places: (6, n) places of the joints in MuJoCo's arrays.
        servo: (7, n) constants of the joints.
        gains: (a, 10) MuJoCo's gains of all actuators.
        biases: (a, 10) MuJoCo's biases of all actuators; the third column is by rate.
        step: usual duration of MuJoCo's steps [s].
        bounds: (3,) bounds for `_jumps`, and of a brake's deflection in one step, as a share of that at which it slips:
            from the first it seizes, from the second it slips [1].
        qvel: MuJoCo's velocities.
        acceleration: MuJoCo's accelerations in its last step.
        torques: (n,) torques at the end of the last control period [N m].
        holds: (n,) angles to which the servos turn the joints [rad], `NONE` for none; updated.
        ctrl: MuJoCo's controls; written.
        act: MuJoCo's activations; the brakes' deflections [rad] are written while the brakes are off.

    Returns:
        `USUAL`, `JUMPS`, `SEIZES` or `SLIPS`.
    """
    for i in range(places.shape[1]):
        if braked or (rates[i] != 0.0 and not by_angle):
            holds[i] = NONE
            ctrl[places[INPUT, i]] = rates[i]
        else:
            if holds[i] != holds[i]:
                holds[i] = angles[i]
            back, most = servo[HOLD_GAIN, i] * (holds[i] - angles[i]), servo[HOLD_RATE, i]
            ctrl[places[INPUT, i]] = rates[i] + min(max(back, -most), most)
    if braked:
        share = _deflected(places, servo, step, qvel)
        return SLIPS if share > bounds[2] else SEIZES if share > bounds[1] else USUAL
    deflect_brakes(places, servo, qvel, step, act)
    jumps = _jumps(places, servo, gains, biases, step, bounds[0], qvel, acceleration, ctrl, torques)
    return JUMPS if jumps else USUAL


@law
def measure_joints(
    braked: bool,
    by_angle: bool,
    places: Indices,
    gearboxes: Indices,
    servo: Array,
    gains: Array,
    biases: Array,
    step: float,
    brake_damping: float,
    qpos: Array,
    qvel: Array,
    act: Array,
    ctrl: Array,
    force: Array,
    angles: Array,
    rates: Array,
    holds: Array,
    torques: Array,
    overdriven: Mask,
    given: Array,
    period: float,
    reference: Array,
    commanded: Array,
) -> None:
    """Measure angles at the joints' outputs, rates of the motors, and torques of the acting servos or brakes.

    Angles and rates are measured in steps; a step of 0 is exact. Also count the commanded rates.

    The torques are those that acted in the last step of MuJoCo. Its integrator takes the rate from the end of the step,
    unless the torque is at its limit; MuJoCo's own forces take it from the beginning.

    Args:
        braked: whether the brakes are on.
        by_angle: whether servos also turn the joints to the angles to which the rates lead.
        places: (6, n) places of the joints in MuJoCo's arrays.
        gearboxes: (n,) places of the gearboxes' windup; (0,) if the model is rigid.
        servo: (7, n) constants of the joints.
        gains: as in `_wanted`; biases and ctrl likewise.
        biases: (a, 10).
        step: duration of MuJoCo's last step [s].
        brake_damping: damping of a brake that does not slip [N m s/rad].
        qpos: MuJoCo's positions.
        qvel: MuJoCo's velocities.
        act: MuJoCo's activations.
        ctrl: MuJoCo's controls.
        force: MuJoCo's forces of the actuators [N m].
        angles: (n,) output [rad].
        rates: (n,) output [rad/s].
        holds: (n,) angles to which the servos turn the joints [rad]; updated. With `by_angle`, they move at the
            commanded rates, but no farther ahead of a joint than where its greatest rate of return begins.
        torques: (n,) output [N m].
        overdriven: (n,) output: 1 for a joint that turns against its motor or brake at its greatest torque.
        given: (n,) commanded joint rates [rad/s].
        period: control period [s].
        reference: (n,) output: rates from which the steering's acceleration limits count [rad/s].
        commanded: (n,) angles that the joints would have without stops [rad]; updated.
    """
    acting, greatest = (BRAKE, HOLDING) if braked else (SERVO, TORQUE)
    for i in range(places.shape[1]):
        motor, rate = qpos[places[MOTOR, i]], qvel[places[RATE, i]]
        angle = motor + qpos[gearboxes[i]] if gearboxes.shape[0] > 0 else motor
        encoder, tachometer = servo[ENCODER, i], servo[TACHOMETER, i]
        angles[i] = angle if encoder == 0.0 else nearest(angle / encoder) * encoder
        rates[i] = rate if tachometer == 0.0 else nearest(rate / tachometer) * tachometer
        most = servo[greatest, i]
        torque = force[places[acting, i]]
        if abs(torque) < AT_LIMIT * most:
            if braked:
                begin = act[places[DEFLECTION, i]] - step * rate
                torque = -most / servo[GIVE, i] * begin - brake_damping * rate
            else:
                torque = _wanted(i, places, gains, biases, ctrl, rate)
            torque = min(max(torque, -most), most)
        torques[i] = torque
        overdriven[i] = abs(torque) >= AT_LIMIT * most and rate * torque < 0.0
        reference[i] = given[i]
        commanded[i] += given[i] * period
        if by_angle and given[i] != 0.0 and not braked:
            ahead, most = holds[i] + given[i] * period - angles[i], servo[HOLD_RATE, i]
            if servo[HOLD_GAIN, i] * abs(ahead) > most:
                ahead = math.copysign(most / servo[HOLD_GAIN, i], ahead)
            holds[i] = angles[i] + ahead


@law
def poses_in_base(orbiter: int, bodies: Indices, xpos: Array, xmat: Array, base: Array, rows: Array) -> None:
    """Write the pose of L in the world, and the poses of bodies in L.

    Args:
        orbiter: number of the body whose frame is L; -1 if L does not move, and `base` keeps its pose.
        bodies: (f,) numbers of the bodies.
        xpos: (b, 3) MuJoCo's positions of all bodies in the world [m].
        xmat: (b, 9) MuJoCo's rotations of all bodies, row by row.
        base: (12,) pose of L in the world; updated.
        rows: (f, 12) output.
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
        frames: (f,) numbers of the bodies of the arm's frames.
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
