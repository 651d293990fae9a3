"""Numbers of a frame: one compiled call converts values of the state's arrays to the frame's tuples.

Compiled code makes tuples of floats several times faster than Python makes them from arrays.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import rows, vec3
from aftdeck.kinematics.observe import CARRIED, observe_link, observe_payload
from aftdeck.law import law
from aftdeck.steering.layout import (
    BEFORE,
    CAUSE,
    DEMAND,
    DRIVE,
    DT,
    LIMITING_JOINT,
    MOST_UP,
    MOTION_ACTIVE,
    POR_CAUSE,
    RATES,
    RATIO,
    REMAINING,
    SPEED,
    STICKS,
    TURN,
    TURN_REMAINING,
    TWIST,
)
from aftdeck.tuples import Rows, Six, Vec3

ROUNDING = 1e-9
"""Share of a joint acceleration limit by which rounding may exceed the limit [1]."""

Observed = tuple[Vec3, Rows, Six, Rows]
"""Position, rotation (rows) and twist of the tip; LNKAGE's T_B5."""
Steered = tuple[Six, Six, tuple[float, float], Vec3, Vec3]
"""Commanded twist, demanded twist, limits of the point of resolution, THC deflection, RHC deflection."""
Scalars = tuple[float, float, float, float, float]
"""DRIVE, RATIO, remaining time, remaining time of the rotation, and `MOTION_ACTIVE` (1 during an automatic motion)."""
Acted = tuple[int, int, int, int]
"""Limits that acted: `CAUSE`, `POR_CAUSE`, `LIMITING_JOINT`, and a bit for each joint that `beyond` returns."""
Moving = tuple[Vec3, Rows, Vec3]
"""Position, rotation (rows) and velocity of a body."""

Carried = tuple[tuple[Vec3, Rows], Vec3, Vec3]
"""Pose of a payload; position and velocity of the point of resolution."""


@law
def six(values: Array, at: int) -> Six:
    """Return six values of an array, from index `at` on."""
    return values[at], values[at + 1], values[at + 2], values[at + 3], values[at + 4], values[at + 5]


@law
def wrist_pitch(arm: Array, angles: Array, mount: Array) -> Rows:
    """Return LNKAGE's T_B5. `kinematics.observe.observe_link` describes the arguments."""
    axes = np.empty((3, 3))
    observe_link(arm, angles, mount, axes)
    return (
        (axes[0, 0], axes[0, 1], axes[0, 2]),
        (axes[1, 0], axes[1, 1], axes[1, 2]),
        (axes[2, 0], axes[2, 1], axes[2, 2]),
    )


@law
def beyond(joints: int, rules: Array, steering: Array, report: Array) -> int:
    """Return a bit for each joint whose commanded rate changed by more than its acceleration limit, whatever the cause.

    In the modes that have these limits, a stop, a singularity, a rate limit or a line may require more. The joints of
    the other modes may stop at once. `frame_numbers` describes the arguments.
    """
    found, period = 0, rules[DT] * (1.0 + ROUNDING)
    for joint in range(joints):
        if abs(steering[RATES + joint] - report[BEFORE + joint]) > rules[MOST_UP + joint] * period:
            found |= 1 << joint
    return found


@law
def frame_numbers(
    arm: Array,
    mount: Array,
    angles: Array,
    seen: Array,
    rules: Array,
    command: Array,
    steering: Array,
    report: Array,
) -> tuple[Observed, Steered, Scalars, Acted]:
    """Return the numbers of a frame, but for those whose number depends on the arm: of joints and singularities.

    Args:
        arm: packed links.
        mount: (3, 3) rotation from L to the orbiter's body axes.
        angles: (n,) measured joint angles [rad].
        seen: (18 + s,) values computed by `kinematics.observe.observe`.
        rules: rules in force. `steering.layout` defines this array and the next three.
        command: input of the steering laws.
        steering: state of the steering.
        report: output of the steering laws.
    """
    return (
        (vec3(seen, 0), rows(seen, 3), six(seen, 12), wrist_pitch(arm, angles, mount)),
        (
            six(steering, TWIST),
            six(report, DEMAND),
            (rules[SPEED], rules[TURN]),
            vec3(command, STICKS + 3),
            vec3(command, STICKS),
        ),
        (command[DRIVE], report[RATIO], report[REMAINING], report[TURN_REMAINING], command[MOTION_ACTIVE]),
        (
            int(report[CAUSE]),
            int(report[POR_CAUSE]),
            int(report[LIMITING_JOINT]),
            beyond(len(angles), rules, steering, report),
        ),
    )


@law
def carried_numbers(seen: Array, payload: Array) -> Carried:
    """Return the numbers of a payload in the grasp. `kinematics.observe.observe_payload` describes the arguments."""
    carried = np.empty(CARRIED)
    observe_payload(seen, payload, carried)
    return (vec3(carried, 0), rows(carried, 3)), vec3(carried, 12), vec3(carried, 15)


@law
def moving(frames: Array, before: Array, row: int, period: float) -> Moving:
    """Return the pose and the velocity of one body.

    Args:
        frames: (F, 12) poses of all frames.
        before: (F, 12) poses of all frames one control period earlier.
        row: row of the body's frame.
        period: control period [s].
    """
    now, then = frames[row], before[row]
    velocity = (now[0] - then[0]) / period, (now[1] - then[1]) / period, (now[2] - then[2]) / period
    return vec3(now, 0), rows(now, 3), velocity
