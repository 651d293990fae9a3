"""Compiled observation of Reach: remaining motion, and normalised numbers. `layout.py` describes the arrays."""

from __future__ import annotations

import math

from aftdeck.arrays import Array
from aftdeck.gym.reach.layout import GOAL, MIDDLE, OBSERVATIONS, OBSERVED, REACHED, REWARD, SCALE
from aftdeck.gym.reach.stick_blocks import JOINT_ANGLES, JOINT_RATES
from aftdeck.gym.terms import Floats32
from aftdeck.kinematics.jacobian import erates, jacobi, of_six
from aftdeck.kinematics.linkage import Floats, Sines, axes, place
from aftdeck.law import law
from aftdeck.steering.blocks import LANES, put_six, remaining_distance, remaining_rotation, sines_in, six
from aftdeck.steering.layout import MOUNT
from aftdeck.tuples import Six, Vec3

_LEAST_COSINE = 1e-6
"""Least cosine of half the remaining angle by which a rotation is divided; it differs from the angle's cosine only
within 0.0002 deg of 180 deg."""


@law
def _to_orbiter(c: Floats, x: float, y: float, z: float) -> Vec3:
    """Convert a vector from L to the orbiter's axes: the axes of the sticks in ORB UNL."""
    return (
        c[MOUNT] * x + c[MOUNT + 3] * y + c[MOUNT + 6] * z,
        c[MOUNT + 1] * x + c[MOUNT + 4] * y + c[MOUNT + 7] * z,
        c[MOUNT + 2] * x + c[MOUNT + 5] * y + c[MOUNT + 8] * z,
    )


@law
def observe(c: Floats, block: Array, work: Array) -> None:
    """Write the remaining motion of every environment into `work`, and its size into REWARD and REACHED."""
    for i in range(LANES):
        work[REWARD * LANES + i], work[REACHED * LANES + i] = observe_lane(c, block, work, i)


@law
def observe_lane(c: Floats, block: Array, work: Array, i: int) -> tuple[float, float]:
    """Write the remaining motion, in the orbiter's axes, into `work`; return its distance [m] and rotation [1].

    The rotation is the unit axis times 2 sin(angle / 2). It follows from the trace 1 + 2 cos(angle) of the rotation
    matrix, and from the axis times sin(angle), which `remaining_rotation` returns.
    """
    a: Sines = sines_in(work, i)
    goal = six(block, GOAL, i) + six(block, GOAL + 6, i)
    x, y, z = remaining_distance(place(c, a), goal)
    t = axes(c, a)
    rx, ry, rz = remaining_rotation(t, goal)
    trace = (
        (t[0] * goal[3] + t[1] * goal[4] + t[2] * goal[5])
        + (t[3] * goal[6] + t[4] * goal[7] + t[5] * goal[8])
        + (t[6] * goal[9] + t[7] * goal[10] + t[8] * goal[11])
    )
    half_cosine = max(0.5 * math.sqrt(max(1.0 + trace, 0.0)), _LEAST_COSINE)
    per = 1.0 / half_cosine
    ox, oy, oz = _to_orbiter(c, x, y, z)
    px, py, pz = _to_orbiter(c, per * rx, per * ry, per * rz)
    put_six(work, OBSERVED, i, (px, py, pz, ox, oy, oz))
    return math.sqrt(x * x + y * y + z * z), math.sqrt(max(3.0 - trace, 0.0))


@law
def normalise(c: Floats, task: Floats, block: Array, work: Array) -> None:
    """Normalise the observations of every environment."""
    for i in range(LANES):
        normalise_lane(c, task, block, work, i)


@law
def normalise_lane(c: Floats, task: Floats, block: Array, work: Array, i: int) -> None:
    """Normalise the observation of environment i; the remaining motion is in `work` already."""
    px, py, pz, ox, oy, oz = six(work, OBSERVED, i)
    a = sines_in(work, i)
    r1, r2, r3, r4, r5, r6 = six(block, JOINT_RATES, i)
    twist = erates(a, jacobi(c, a), of_six(r1, r2, r3, r4, r5, r6))
    ax, ay, az = _to_orbiter(c, twist.wx, twist.wy, twist.wz)
    bx, by, bz = _to_orbiter(c, twist.vx, twist.vy, twist.vz)
    _put_normalised(task, work, 0, i, (ox, oy, oz, px, py, pz))
    _put_normalised(task, work, 6, i, (bx, by, bz, ax, ay, az))
    _put_normalised(task, work, 12, i, six(block, JOINT_ANGLES, i))
    _put_normalised(task, work, 18, i, six(block, JOINT_RATES, i))


@law
def _put_normalised(task: Floats, work: Array, k: int, i: int, values: Six) -> None:
    """Write six observations, from number k on."""
    put_six(
        work,
        OBSERVED + k,
        i,
        (
            (values[0] - task[MIDDLE + k]) * task[SCALE + k],
            (values[1] - task[MIDDLE + k + 1]) * task[SCALE + k + 1],
            (values[2] - task[MIDDLE + k + 2]) * task[SCALE + k + 2],
            (values[3] - task[MIDDLE + k + 3]) * task[SCALE + k + 3],
            (values[4] - task[MIDDLE + k + 4]) * task[SCALE + k + 4],
            (values[5] - task[MIDDLE + k + 5]) * task[SCALE + k + 5],
        ),
    )


@law
def put_observation(work: Array, i: int, observations: Floats32, row: int) -> None:
    """Copy the observation of environment i of a block into a row of `observations`."""
    for k in range(OBSERVATIONS):
        observations[row, k] = work[(OBSERVED + k) * LANES + i]
