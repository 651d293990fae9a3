"""Batch of Capture, Extract or Dock: many simulations that make their control periods in one compiled call."""

from __future__ import annotations

import numpy as np
from gymnasium.utils.seeding import np_random

from aftdeck.arrays import Array, Flags
from aftdeck.gym.actions import outside, shaped
from aftdeck.gym.aligned import AlignedFloats
from aftdeck.gym.batch_step import DISABLED, NEXT_STEP, SAME_STEP, Step
from aftdeck.gym.mission.actions import inputs_of
from aftdeck.gym.mission.definition import EFFECTOR, SWITCHED
from aftdeck.gym.mission.observe import observe_all
from aftdeck.gym.mission.score import CONTACT, SCORED, may_hold, reward, score_all
from aftdeck.gym.mission.task import MissionTask
from aftdeck.gym.terms import Floats32
from aftdeck.simulation.batch import Batch
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.parts.shown import COARSE, SWITCH, shown_of
from aftdeck.simulation.run import Simulation
from aftdeck.steering.rules import SETTINGS
from aftdeck.task.reached import Since

_COARSE, _VERNIER = 0, 1
"""Indices in `SETTINGS`."""
_RATE, _EFFECTOR = 6, 7
"""Indices of the switches in an action."""


class MissionBatch:
    """Environments of one scenario on the kinematic plant (`batch_step.EnvBatch`).

    Each has a generator of random numbers, which its key seeds.

    Args:
        task: the step that they fly.
        count: number of environments.
        most_steps: number of steps after which an episode is truncated.
    """

    def __init__(self, task: MissionTask, count: int, most_steps: int) -> None:
        self._task, self._count, self._most = task, count, most_steps
        self._batch = Batch(task.simulation(), count)
        self._randoms = [np.random.default_rng()] * count
        self._sinces: list[Since | None] = [None] * count
        size = task.observer.space.shape
        self._arrays = AlignedFloats(count, *size)
        self._seen = np.zeros((count, *size), np.float32)
        self._shown = np.zeros((count, len(shown_of(*self._batch.simulations[0].parts))))
        self._scored, self._before = np.zeros((count, SCORED)), np.zeros((count, SCORED))
        self._may = np.zeros(count, np.bool_)
        self._ended = np.zeros(count, np.bool_)
        self._steps, self._wanted = np.zeros(count, np.int64), np.zeros(count, np.int64)

    def simulation(self, i: int) -> Simulation:
        """Return the simulation of an environment, as it is now."""
        self._batch.catch_up(i)
        return self._batch.simulations[i]

    def seed(self, keys: list[int | None]) -> None:
        """Give each environment a new generator with its key; None changes nothing."""
        for i, key in enumerate(keys):
            if key is not None:
                self._randoms[i] = np_random(key)[0]

    def begin(self, chosen: Flags) -> Floats32:
        """Begin an episode in the chosen environments (n,); return all observations (n, m)."""
        for i in np.flatnonzero(chosen).tolist():
            self._begin(i)
        return self._new(self._seen)

    def step(self, actions: object, autoreset: int) -> Step:
        """Make one step of all environments; arguments and errors as for `EnvBatch.step`."""
        controls = self._task.mission.controls
        given = shaped(actions, controls, self._count)
        if (error := outside(given, controls)) is not None:
            raise error
        skipped = self._ended.copy() if autoreset == NEXT_STEP else np.zeros(self._count, np.bool_)
        self._move(given, skipped)
        self._before[:] = self._scored
        task, batch, observed = self._task, self._batch, ~skipped
        rewards, done = np.zeros(self._count), np.zeros(self._count, np.bool_)
        observe_all(
            batch.constants, batch.rows, self._shown, task.observer.aim, task.observer.arrays, observed, self._seen,
            self._scored,
        )  # fmt: skip
        score_all(task.limits, self._before, self._scored, observed, rewards, done)
        done &= self._may
        for i in np.flatnonzero(done).tolist():
            since = self._sinces[i]
            assert since is not None, "an episode is under way"
            done[i] = task.is_complete(self.simulation(i), since, self._scored[i])
            rewards[i] = reward(self._before[i], self._scored[i], float(done[i]))
        self._steps += observed
        return self._end(done, skipped, rewards, autoreset)

    def _end(self, done: Flags, skipped: Flags, rewards: Array, autoreset: int) -> Step:
        """Return the result of a step, and begin the episodes that begin now."""
        terminated = done.copy()
        if self._task.mission.contact_ends:
            terminated |= (self._scored[:, CONTACT] != 0.0) & ~skipped
        truncated = (self._steps >= self._most) & ~skipped
        self._ended = terminated | truncated
        final = self._new(self._seen) if autoreset == SAME_STEP else np.zeros((0, self._seen.shape[1]), np.float32)
        if autoreset != DISABLED:
            for i in np.flatnonzero(skipped if autoreset == NEXT_STEP else self._ended).tolist():
                self._begin(i)
        ended = int(np.count_nonzero(terminated | truncated))
        return Step(self._new(self._seen), rewards, terminated, truncated, done, final, ended)

    def _move(self, actions: Floats32, skipped: Flags) -> None:
        """Make the control periods of a step, and find out what panels and berths then show."""
        rates, before = actions[:, _RATE], self._wanted
        self._wanted = np.where(rates > SWITCHED, _COARSE, np.where(rates < -SWITCHED, _VERNIER, before))
        self._wanted[skipped] = before[skipped]
        mission, sticks = self._task.mission, actions[:, [3, 4, 5, 0, 1, 2]].astype(np.float64)
        switches = np.zeros(self._count)
        if EFFECTOR in mission.controls:
            switches = 1.0 * (actions[:, _EFFECTOR] > SWITCHED) - 1.0 * (actions[:, _EFFECTOR] < -SWITCHED)

        def inputs(i: int) -> Inputs:
            return inputs_of(mission, actions[i].tolist(), SETTINGS[before[i]])

        changed = self._batch.hold(sticks, self._wanted, switches, self._task.repeats, skipped, inputs)
        for i in changed:
            self._look(i)
        self._shown[:, COARSE], self._shown[:, SWITCH] = 1.0 - 2.0 * self._batch.rates, self._batch.switches

    def _look(self, i: int) -> None:
        """Read what the panel and the berths of an environment show."""
        flight, state = self._batch.simulations[i].parts
        self._shown[i], self._may[i] = shown_of(flight, state), may_hold(self._task.step.done, state.worksite)

    def _begin(self, i: int) -> None:
        """Begin an episode of one environment."""
        sim = self._batch.simulations[i]
        _, self._sinces[i], self._seen[i], self._scored[i] = self._task.begin(sim, self._randoms[i])
        self._batch.place(i)
        self._look(i)
        self._steps[i], self._wanted[i], self._ended[i] = 0, _COARSE, False

    def _new(self, seen: Floats32) -> Floats32:
        """Return a new array with these observations."""
        new = self._arrays.new()
        new[:] = seen
        return new
