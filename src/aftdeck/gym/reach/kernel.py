"""Compiled functions of Reach, which serve the single environment and the batch: one step, and the begin of episodes.

The single environment is a batch of one. `layout.py` describes the arrays.
"""

from __future__ import annotations

from aftdeck.arrays import Array, Flags
from aftdeck.gym.batch_step import NEXT_STEP, SAME_STEP
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
    MOST_STEPS,
    NEAR,
    NEAR_CHORD,
    OUT_OF_TIME,
    PER_CHORD,
    PER_METRE,
    PER_STEP,
    REACHED,
    REJECTED,
    REWARD,
    START_LOW,
    START_SPAN,
    STEPS,
    SUCCESS,
)
from aftdeck.gym.reach.observe import normalise, normalise_lane, observe, observe_lane, put_observation
from aftdeck.gym.reach.stick_blocks import (
    DEFLECTIONS,
    JOINT_ANGLES,
    JOINT_RATES,
    TIP_TWIST,
    sines_at_angles,
    steer_by_sticks,
)
from aftdeck.gym.terms import Floats32
from aftdeck.kinematics.linkage import Floats, sines, tip
from aftdeck.law import law
from aftdeck.steering.blocks import LANES, put_six
from aftdeck.tuples import Six

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
        observe(c, block, work)
        _score(c, task, block, work)
        normalise(c, task, block, work)
        for i in range(lanes):
            row = first + i
            again = autoreset == NEXT_STEP and block[ENDED * LANES + i] != 0.0
            rewards[row] = 0.0 if again else work[REWARD * LANES + i]
            terminated[row] = not again and work[REACHED * LANES + i] != 0.0
            truncated[row] = not again and work[OUT_OF_TIME * LANES + i] != 0.0
            reached[row] = terminated[row]
            if terminated[row] or truncated[row]:
                ended += 1
                block[ENDED * LANES + i] = 1.0
                if autoreset == SAME_STEP:
                    put_observation(work, i, final, row)
                    again = True
            if again:
                begin_episode(c, task, block, work, i)
            put_observation(work, i, observations, row)
    return ended


@law
def begin_all(c: Floats, task: Floats, blocks: Array, chosen: Flags, observations: Floats32, work: Array) -> None:
    """Begin an episode in the chosen environments (n,), and observe all of them: observations (n, OBSERVATIONS)."""
    for b in range(blocks.shape[0]):
        block, first = blocks[b], b * LANES
        lanes = min(LANES, chosen.shape[0] - first)
        sines_at_angles(c, block, work, 0.0)
        observe(c, block, work)
        normalise(c, task, block, work)
        for i in range(LANES):
            if i >= lanes or chosen[first + i]:
                begin_episode(c, task, block, work, i)
        for i in range(lanes):
            put_observation(work, i, observations, first + i)


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
        distance, chord = observe_lane(c, block, work, i)
        block[DISTANCE * LANES + i], block[CHORD * LANES + i] = distance, chord
        if distance >= task[APART]:
            break
    normalise_lane(c, task, block, work, i)


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
