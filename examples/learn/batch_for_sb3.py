"""Adapter: a batch of environments as a vector environment of Stable-Baselines3."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from gymnasium.vector import VectorEnv
from numpy.typing import NDArray
from stable_baselines3.common.vec_env import VecEnv

Floats = NDArray[np.float32]


class BatchForSb3(VecEnv):
    """Environments of Gymnasium's vector environment, which resets each in the step that ends its episode.

    Args:
        batch: the vector environment, with the autoreset mode ``SameStep``.
        seed: seed of the first environment; the others have the next seeds.
        std: (m,) divides the observations.
        reward_scale: factor of all rewards.
    """

    def __init__(
        self, batch: VectorEnv[Floats, Floats, Any], seed: int, std: Floats, reward_scale: float = 1.0
    ) -> None:
        self._batch = batch
        self._first_seed: int | None = seed
        self._std, self._reward_scale = std, reward_scale
        self._actions = np.zeros((0, 0), dtype=np.float32)
        super().__init__(batch.num_envs, batch.single_observation_space, batch.single_action_space)

    def reset(self) -> Floats:
        """Begin an episode in all environments; return the observations (count, m)."""
        observations, _ = self._batch.reset(seed=self._first_seed)
        self._first_seed = None
        return observations / self._std

    def step_async(self, actions: Floats) -> None:
        """Store the actions (count, controls) for `step_wait`."""
        self._actions = actions

    def step_wait(self) -> tuple[Floats, Floats, NDArray[np.bool_], list[dict[str, Any]]]:
        """Make one step; return observations, rewards, ended episodes, and for each of these how it ended."""
        observations, rewards, terminated, truncated, infos = self._batch.step(self._actions)
        ended = terminated | truncated
        each: list[dict[str, Any]] = [{} for _ in range(self.num_envs)]
        for i in np.flatnonzero(ended):
            each[i] = {
                "terminal_observation": infos["final_obs"][i] / self._std,
                "TimeLimit.truncated": not terminated[i],
                "is_success": bool(infos["final_info"]["is_success"][i]),
            }
        return observations / self._std, (self._reward_scale * rewards).astype(np.float32), ended, each

    def close(self) -> None:
        """Do nothing: the batch holds no resources."""

    def get_attr(self, attr_name: str, indices: Any = None) -> list[Any]:
        """Return an attribute once for each environment; the environments share all attributes."""
        return [getattr(self._batch, attr_name, None)] * len(list(self._get_indices(indices)))

    def set_attr(self, attr_name: str, value: Any, indices: Any = None) -> None:
        """Raise an error: single environments of the batch have no attributes of their own."""
        raise NotImplementedError(f"a single environment of the batch has no attribute {attr_name!r}")

    def env_method(self, method_name: str, *args: Any, indices: Any = None, **kwargs: Any) -> list[Any]:
        """Raise an error: single environments of the batch have no methods."""
        raise NotImplementedError(f"a single environment of the batch has no method {method_name!r}")

    def env_is_wrapped(self, wrapper_class: Any, indices: Any = None) -> Sequence[bool]:
        """Return False for each environment."""
        return [False] * len(list(self._get_indices(indices)))
