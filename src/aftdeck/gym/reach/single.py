"""Single Reach environment: a batch of one on the kinematic plant, or a simulation on a plant with masses."""

from __future__ import annotations

from typing import Any, Protocol

import gymnasium
import numpy as np

from aftdeck.errors import InputError
from aftdeck.gym.choices import PLANTS, no_options, no_rendering, one_of
from aftdeck.gym.reach import definition
from aftdeck.gym.reach.batch import ReachBatch
from aftdeck.gym.reach.layout import DISABLED
from aftdeck.gym.reach.simulated import SimulatedReach
from aftdeck.gym.terms import Floats32, action_space, observation_space
from aftdeck.scenario.schema import Plant


class Reach(Protocol):
    """One environment, on any plant."""

    def begin(self, key: int | None) -> Floats32:
        """Begin an episode and return the observation (24,); a key begins with episode 0, None with the next one."""

    def step(self, action: object) -> tuple[Floats32, float, bool]:
        """Make one step with the sticks (6,); return the observation, the reward, and whether the goal is reached."""


def row(observations: Floats32) -> Floats32:
    """Return the observation of the only environment of a batch."""
    return observations.reshape(-1)


class KinematicReach:
    """The compiled batch with one environment."""

    def __init__(self) -> None:
        self._batch, self._all = ReachBatch(1), np.ones(1, dtype=np.bool_)

    def begin(self, key: int | None) -> Floats32:
        """As in `Reach`."""
        self._batch.seed([key])
        return row(self._batch.begin(self._all))

    def step(self, action: object) -> tuple[Floats32, float, bool]:
        """As in `Reach`."""
        done = self._batch.step(action, DISABLED)
        return row(done.observations), float(done.rewards[0]), bool(done.terminated[0])


class ReachEnv(gymnasium.Env[Floats32, Floats32]):
    """Move the tip of the Shuttle's arm to a random pose with the hand controllers, in the mode ORB UNL.

    Args:
        plant: ``kinematic``, ``rigid`` or ``flexible``.
        render_mode: only None.

    Raises:
        InputError: an argument is not allowed; the message states the allowed values.
    """

    metadata = {"render_modes": []}  # noqa: RUF012  (Gymnasium declares it as a variable of the instance)

    def __init__(self, plant: Plant = "kinematic", render_mode: str | None = None) -> None:
        no_rendering(render_mode)
        self.observation_space = observation_space(definition.OBSERVATIONS)
        self.action_space = action_space(definition.CONTROLS)
        chosen = one_of("plant", plant, PLANTS)
        self._reach: Reach = KinematicReach() if chosen == "kinematic" else SimulatedReach(chosen)
        self._begun = False

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Floats32, dict[str, Any]]:
        """Begin an episode; with a seed, begin the episodes of this seed again. `options` has no keys."""
        super().reset(seed=seed)
        no_options(options)
        key = self.np_random_seed if seed is not None or not self._begun else None
        self._begun = True
        return self._reach.begin(key), {"is_success": False}

    def step(self, action: Floats32) -> tuple[Floats32, float, bool, bool, dict[str, Any]]:
        """Make one step with the sticks (6,), each in [-1, 1].

        Raises:
            InputError: the action has another shape, or a stick is outside [-1, 1]; nothing has changed.
        """
        if not self._begun:
            raise InputError("step: got a call before the first reset, expected reset() first")
        observation, reward, reached = self._reach.step(action)
        return observation, reward, reached, False, {"is_success": reached}
