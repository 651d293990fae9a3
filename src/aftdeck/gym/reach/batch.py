"""Batch of Reach environments: packed constants, state, and calls of the compiled functions."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Flags
from aftdeck.compiled_first import compiled_first
from aftdeck.frames import Pose
from aftdeck.gym.actions import outside, shaped
from aftdeck.gym.aligned import AlignedFloats
from aftdeck.gym.batch_step import NEXT_STEP, SAME_STEP, UNLIMITED, Step
from aftdeck.gym.philox import MASK
from aftdeck.gym.reach import definition as task
from aftdeck.gym.reach import kernel
from aftdeck.gym.reach.layout import (
    APART,
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
    OBSERVATIONS,
    PER_CHORD,
    PER_METRE,
    PER_STEP,
    REJECTED,
    ROWS,
    SCALE,
    START_LOW,
    START_SPAN,
    SUCCESS,
    TASK,
    WORK,
)
from aftdeck.gym.reach.stick_blocks import JOINT_ANGLES
from aftdeck.gym.terms import Floats32
from aftdeck.kinematics.arm import Arm, load_arm
from aftdeck.steering.blocks import LANES
from aftdeck.steering.layout import SPEED, STATE, TURN
from aftdeck.steering.rules import rules_of

FILES = 120
"""Number of files with the machine code of a batch, roughly."""


class ReachBatch:
    """State of `count` environments on the kinematic plant."""

    def __init__(self, count: int, most_steps: int = UNLIMITED) -> None:
        compiled_first(_call_laws, package="aftdeck.gym", files=FILES)
        arm = load_arm("srms")
        rules = rules_of(arm.model, arm.model.por_limits(0.0), task.PERIOD)["ORB UNL", "coarse", 4]
        hard = arm.limits.hard
        self._count = count
        self._rules = rules
        self._steering = tuple([*rules.tolist(), *hard[:, 0].tolist(), *hard[:, 1].tolist()])
        self._task = tuple(_constants(arm, rules, most_steps).tolist())
        self._blocks = np.zeros((-(-count // LANES), ROWS * LANES))
        self._work, self._scratch = np.zeros(WORK * LANES), np.zeros(STATE)
        self._fields = self._blocks.reshape(-1, ROWS, LANES)
        self._arrays = AlignedFloats(count, OBSERVATIONS)
        self._no_final = np.zeros((0, OBSERVATIONS), dtype=np.float32)

    def seed(self, keys: list[int | None]) -> None:
        """Give each environment its key (64 bits are used), and begin with its episode 0; None changes nothing."""
        for n, key in enumerate(keys):
            if key is not None:
                block, lane = divmod(n, LANES)
                self._fields[block, [KEY_LOW, KEY_HIGH, EPISODE], lane] = key & MASK, key >> 32 & MASK, 0.0

    def begin(self, chosen: Flags) -> Floats32:
        """Begin the next episode in the chosen environments (n,); return all observations (n, OBSERVATIONS)."""
        observations = self._arrays.new()
        kernel.begin_all(self._steering, self._task, self._blocks, chosen, observations, self._work)
        return observations

    def step(self, actions: object, autoreset: int) -> Step:
        """Make one step of all environments.

        Args:
            actions: (n, 6) sticks in [-1, 1]: translation, then rotation.
            autoreset: NEXT_STEP, SAME_STEP or DISABLED.

        Raises:
            InputError: the actions have another shape, or a stick is outside [-1, 1]; nothing has changed.
        """
        n = self._count
        sticks = shaped(actions, task.CONTROLS, n)
        observations = self._arrays.new()
        final = np.empty_like(observations) if autoreset == SAME_STEP else self._no_final
        rewards = np.empty(n)
        terminated, truncated, reached = np.empty(n, np.bool_), np.empty(n, np.bool_), np.empty(n, np.bool_)
        ended = kernel.step_all(
            self._steering, self._task, self._rules, self._blocks, sticks, autoreset, observations, final, rewards,
            terminated, truncated, reached, self._work, self._scratch,
        )  # fmt: skip
        if ended == REJECTED:
            error = outside(sticks, task.CONTROLS)
            assert error is not None, "the compiled function rejects only actions outside their travel"
            raise error
        return Step(observations, rewards, terminated, truncated, reached, final, ended)

    def angles(self) -> Array:
        """Return the joint angles (n, 6) [rad]."""
        rows = self._fields[:, JOINT_ANGLES : JOINT_ANGLES + 6].swapaxes(1, 2)
        return rows.reshape(-1, 6)[: self._count].copy()

    def goals(self) -> list[Pose]:
        """Return the pose in L that each tip has to reach."""
        rows = self._fields[:, GOAL : GOAL + 12].swapaxes(1, 2).reshape(-1, 12)[: self._count]
        return [Pose(row[:3].copy(), row[3:].reshape(3, 3).copy()) for row in rows]


def _call_laws() -> None:
    """Call every law of a batch."""
    batch = ReachBatch(1)
    batch.seed([0])
    batch.begin(np.ones(1, np.bool_))
    batch.step(np.zeros((1, 6)), NEXT_STEP)


def _constants(arm: Arm, rules: Array, most_steps: int) -> Array:
    """Return the constants of the task (TASK,), as `layout.py` orders them."""
    values = np.zeros(TASK)
    for low, span, half in ((START_LOW, START_SPAN, task.START_HALF), (GOAL_LOW, GOAL_SPAN, task.GOAL_HALF)):
        values[low : low + 6] = np.radians(np.subtract(task.HOME, half))
        values[span : span + 6] = np.radians(np.multiply(2.0, half))
    values[APART], values[NEAR], values[NEAR_CHORD] = task.APART, task.NEAR, task.chord(task.NEAR_ANGLE)
    values[PER_METRE], values[PER_CHORD] = task.DISTANCE.weight, task.ROTATION.weight
    values[PER_STEP], values[SUCCESS] = -task.TIME.weight * task.PERIOD, task.SUCCESS.weight
    values[MOST_STEPS] = most_steps
    middle, one = task.scales(float(rules[SPEED]), float(rules[TURN]), arm.limits.soft, arm.rates.servo)
    values[MIDDLE : MIDDLE + OBSERVATIONS], values[SCALE : SCALE + OBSERVATIONS] = middle, 1.0 / one
    return values
