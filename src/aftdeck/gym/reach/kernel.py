"""Compiled functions of Reach, which serve the single environment and the batch: one step, and the begin of episodes.

The single environment is a batch of one. `layout.py` describes the arrays.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from aftdeck.arrays import Array
from aftdeck.gym.philox import philox, uniform
from aftdeck.gym.reach.layout import (
    APART,
    CHORD,
    DISTANCE,
    ENDED,
    EPISODE,
    GOAL,
    GOAL_LOW,
    GOAL_SPAN,
    KEY_HIGH,
    KEY_LOW,
    MIDDLE,
    MOST_STEPS,
    NEAR,
    NEAR_CHORD,
    NEXT_STEP,
    OBSERVATIONS,
    OBSERVED,
    OUT_OF_TIME,
    PER_CHORD,
    PER_METRE,
    PER_STEP,
    REACHED,
    REJECTED,
    REWARD,
    SAME_STEP,
    SCALE,
    START_LOW,
    START_SPAN,
    STEPS,
    SUCCESS,
)
from aftdeck.kinematics.jacobian import Rates, erates, jacobi
from aftdeck.kinematics.linkage import Floats, Sines, axes, place, sines, tip
from aftdeck.law import law
from aftdeck.steering.blocks import LANES, put_six, remaining_distance, remaining_rotation, sines_in, six
from aftdeck.steering.layout import MOUNT
from aftdeck.steering.stick_blocks import (
    DEFLECTIONS,
    JOINT_ANGLES,
    JOINT_RATES,
    TIP_TWIST,
    sines_at_angles,
    steer_by_sticks,
)
from aftdeck.tuples import Six, Vec3

Floats32 = NDArray[np.float32]
Flags = NDArray[np.bool_]

_LEAST_COSINE = 1e-6
"""Least cosine of half the remaining angle by which a rotation is divided; it differs from the angle's cosine only
within 0.0002 deg of 180 deg."""
_TRIES = 16
"""Greatest number of random goals that are drawn until one is far enough from the start."""


@law
def step_all(
    c: Floats,
    task: Floats,
    rules: Array,
    blocks: Array,
    actions: Floats32,
    autoreset: int,
    observations: Floats32,
    final: Floats32,
    rewards: Array,
    terminated: Flags,
    truncated: Flags,
    reached: Flags,
    work: Array,
    scratch: Array,
) -> int:
    """Make one step of all environments.

    Args:
        c: constants of the steering, as in `steer_by_sticks`.
        task: (TASK,) constants of the task, as a tuple.
        rules: rules of the steering, as in `steer_by_sticks`.
        blocks: (blocks, ROWS * LANES) the environments; updated in place.
        actions: (n, 6) sticks in [-1, 1]: translation, then rotation, along and about the orbiter's axes.
        autoreset: NEXT_STEP, SAME_STEP or DISABLED.
        observations: (n, OBSERVATIONS) output.
        final: (n, OBSERVATIONS) output of SAME_STEP: the last observation of each episode that has ended.
        rewards: (n,) output.
        terminated: (n,) output: the goal is reached.
        truncated: (n,) output: the episode has reached its greatest number of steps.
        reached: (n,) output: whether the goal was reached in this step.
        work: (WORK * LANES,) overwritten.
        scratch: (STATE,) overwritten.

    Returns:
        Number of episodes that ended, or REJECTED if a stick is outside [-1, 1] or not a number.
    """
    if not _within_travel(actions):
        return REJECTED
    ended = 0
    for b in range(blocks.shape[0]):
        block, first = blocks[b], b * LANES
        lanes = min(LANES, actions.shape[0] - first)
        for i in range(lanes):
            for k in range(3):
                block[(DEFLECTIONS + k) * LANES + i] = actions[first + i, 3 + k]
                block[(DEFLECTIONS + 3 + k) * LANES + i] = actions[first + i, k]
        steer_by_sticks(c, rules, block, work, scratch)
        sines_at_angles(c, block, work, 0.0)
        _observe(c, block, work)
        _score(c, task, block, work)
        _normalise(c, task, block, work)
        for i in range(lanes):
            row = first + i
            if autoreset == NEXT_STEP and block[ENDED * LANES + i] != 0.0:
                begin_episode(c, task, block, work, i)
                rewards[row], terminated[row], truncated[row] = 0.0, False, False
            else:
                rewards[row] = work[REWARD * LANES + i]
                terminated[row] = work[REACHED * LANES + i] != 0.0
                truncated[row] = work[OUT_OF_TIME * LANES + i] != 0.0
            reached[row] = terminated[row]
            if terminated[row] or truncated[row]:
                ended += 1
                block[ENDED * LANES + i] = 1.0
                if autoreset == SAME_STEP:
                    _put_observation(work, i, final, row)
                    begin_episode(c, task, block, work, i)
            _put_observation(work, i, observations, row)
    return ended


@law
def begin_all(c: Floats, task: Floats, blocks: Array, chosen: Flags, observations: Floats32, work: Array) -> None:
    """Begin an episode in the chosen environments (n,), and observe all of them: observations (n, OBSERVATIONS)."""
    for b in range(blocks.shape[0]):
        block, first = blocks[b], b * LANES
        lanes = min(LANES, chosen.shape[0] - first)
        sines_at_angles(c, block, work, 0.0)
        _observe(c, block, work)
        _normalise(c, task, block, work)
        for i in range(LANES):
            if i >= lanes or chosen[first + i]:
                begin_episode(c, task, block, work, i)
        for i in range(lanes):
            _put_observation(work, i, observations, first + i)


@law
def begin_episode(c: Floats, task: Floats, block: Array, work: Array, i: int) -> None:
    """Begin the next episode of environment i of a block: random start, at rest, and random goal; observe it."""
    low, high = int(block[KEY_LOW * LANES + i]), int(block[KEY_HIGH * LANES + i])
    episode = int(block[EPISODE * LANES + i])
    block[EPISODE * LANES + i] = episode + 1.0
    block[STEPS * LANES + i] = block[ENDED * LANES + i] = 0.0
    put_six(block, JOINT_RATES, i, (0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    put_six(block, TIP_TWIST, i, (0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    a1, a2, a3, a4 = philox(0, episode, 0, 0, low, high)
    b1, b2, _, _ = philox(1, episode, 0, 0, low, high)
    q = _angles(task, START_LOW, START_SPAN, a1, a2, a3, a4, b1, b2)
    put_six(block, JOINT_ANGLES, i, q)
    here = sines(c, q[0], q[1], q[2], q[3], q[4], q[5])
    put_six(work, 0, i, (here.s1, here.s2, here.s23, here.sw, here.s5, here.s6))
    put_six(work, 6, i, (here.c1, here.c2, here.c23, here.cw, here.c5, here.c6))
    for attempt in range(1, _TRIES + 1):
        a1, a2, a3, a4 = philox(2 * attempt, episode, 0, 0, low, high)
        b1, b2, _, _ = philox(2 * attempt + 1, episode, 0, 0, low, high)
        g = _angles(task, GOAL_LOW, GOAL_SPAN, a1, a2, a3, a4, b1, b2)
        t = tip(c, sines(c, g[0], g[1], g[2], g[3], g[4], g[5]))
        put_six(block, GOAL, i, (t.x, t.y, t.z, t.r11, t.r12, t.r13))
        put_six(block, GOAL + 6, i, (t.r21, t.r22, t.r23, t.r31, t.r32, t.r33))
        distance, chord = _observe_lane(c, block, work, i)
        block[DISTANCE * LANES + i], block[CHORD * LANES + i] = distance, chord
        if distance >= task[APART]:
            break
    _normalise_lane(c, task, block, work, i)


@law
def _angles(task: Floats, low: int, span: int, w1: int, w2: int, w3: int, w4: int, w5: int, w6: int) -> Six:
    """Return random joint angles [rad], each uniform in its range, from six random words."""
    return (
        task[low] + task[span] * uniform(w1),
        task[low + 1] + task[span + 1] * uniform(w2),
        task[low + 2] + task[span + 2] * uniform(w3),
        task[low + 3] + task[span + 3] * uniform(w4),
        task[low + 4] + task[span + 4] * uniform(w5),
        task[low + 5] + task[span + 5] * uniform(w6),
    )


@law
def _within_travel(actions: Floats32) -> bool:
    """Return whether all sticks are in [-1, 1]; a number that is not finite is not."""
    outside = 0
    for i in range(actions.shape[0]):
        for k in range(6):
            outside += 0 if abs(actions[i, k]) <= 1.0 else 1
    return outside == 0


@law
def _to_orbiter(c: Floats, x: float, y: float, z: float) -> Vec3:
    """Convert a vector from L to the orbiter's axes: the axes of the sticks in ORB UNL."""
    return (
        c[MOUNT] * x + c[MOUNT + 3] * y + c[MOUNT + 6] * z,
        c[MOUNT + 1] * x + c[MOUNT + 4] * y + c[MOUNT + 7] * z,
        c[MOUNT + 2] * x + c[MOUNT + 5] * y + c[MOUNT + 8] * z,
    )


@law
def _observe(c: Floats, block: Array, work: Array) -> None:
    """Write the motion that is left of every environment into `work`, and its size into REWARD and REACHED."""
    for i in range(LANES):
        work[REWARD * LANES + i], work[REACHED * LANES + i] = _observe_lane(c, block, work, i)


@law
def _observe_lane(c: Floats, block: Array, work: Array, i: int) -> tuple[float, float]:
    """Write the motion that is left, in the orbiter's axes, into `work`; return its distance [m] and rotation [1].

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
def _score(c: Floats, task: Floats, block: Array, work: Array) -> None:
    """Compute the reward of a step, and whether the goal is reached or the time is up."""
    for i in range(LANES):
        distance, chord = work[REWARD * LANES + i], work[REACHED * LANES + i]
        steps = block[STEPS * LANES + i] + 1.0
        success = 1.0 if distance <= task[NEAR] and chord <= task[NEAR_CHORD] else 0.0
        work[REWARD * LANES + i] = (
            task[PER_METRE] * (block[DISTANCE * LANES + i] - distance)
            + task[PER_CHORD] * (block[CHORD * LANES + i] - chord)
            + (task[SUCCESS] * success - task[PER_STEP])
        )
        work[REACHED * LANES + i] = success
        work[OUT_OF_TIME * LANES + i] = 1.0 if steps >= task[MOST_STEPS] else 0.0
        block[DISTANCE * LANES + i], block[CHORD * LANES + i], block[STEPS * LANES + i] = distance, chord, steps


@law
def _normalise(c: Floats, task: Floats, block: Array, work: Array) -> None:
    """Normalise the observations of every environment."""
    for i in range(LANES):
        _normalise_lane(c, task, block, work, i)


@law
def _normalise_lane(c: Floats, task: Floats, block: Array, work: Array, i: int) -> None:
    """Normalise the observation of environment i; the motion that is left is in `work` already."""
    px, py, pz, ox, oy, oz = six(work, OBSERVED, i)
    a = sines_in(work, i)
    r1, r2, r3, r4, r5, r6 = six(block, JOINT_RATES, i)
    twist = erates(a, jacobi(c, a), Rates(r1, r2, r3, r4, r5, r6))
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
def _put_observation(work: Array, i: int, observations: Floats32, row: int) -> None:
    """Copy the observation of environment i of a block into a row of `observations`."""
    for k in range(OBSERVATIONS):
        observations[row, k] = work[(OBSERVED + k) * LANES + i]
