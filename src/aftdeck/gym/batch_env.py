"""Vector environment of Gymnasium over a batch: seeds, resets and autoreset modes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, cast

import numpy as np
from gymnasium import spaces
from gymnasium.utils.seeding import np_random
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from aftdeck.arrays import Array, Flags
from aftdeck.errors import InputError
from aftdeck.gym.actions import clipped
from aftdeck.gym.batch_step import DISABLED, NEXT_STEP, SAME_STEP, EnvBatch, NoStartError, Step
from aftdeck.gym.choices import PLANTS, no_options, one_of, rendered, whole
from aftdeck.gym.terms import Floats32
from aftdeck.units import short

_MODES = {
    AutoresetMode.NEXT_STEP: NEXT_STEP,
    AutoresetMode.SAME_STEP: SAME_STEP,
    AutoresetMode.DISABLED: DISABLED,
}
Space = spaces.Box[np.float32]


class BatchEnv(VectorEnv[Floats32, Floats32, Array]):
    """Many environments on the kinematic plant, which make their steps together.

    Environment i equals the single environment with the seed `seed + i`, bit for bit. All arrays that a call returns
    are new. ``infos["is_success"]`` tells in every step which environments completed their task in it.

    A class of environments calls `prepare` when it has its batch.
    """

    def choose(
        self,
        num_envs: object,
        autoreset_mode: AutoresetMode | str,
        plant: object,
        render_mode: str | None,
        clip_actions: bool,
    ) -> None:
        """Check and keep the arguments that all classes have.

        Raises:
            InputError: an argument is not allowed; the message states the allowed values.
        """
        self.render_mode, self._clips = rendered(render_mode, ["rgb_array"]), clip_actions
        if one_of("plant", plant, PLANTS) != "kinematic":
            raise InputError(
                f"plant: got {plant!r}, expected 'kinematic' for the compiled batch; with masses use "
                "make_vec(..., vectorization_mode='async') or 'sync'"
            )
        self.num_envs = whole("num_envs", num_envs, 1)
        self.autoreset_mode = _mode(autoreset_mode)
        self.metadata = {**type(self).metadata, "autoreset_mode": self.autoreset_mode}
        self._mode = _MODES[self.autoreset_mode]

    def prepare(self, batch: EnvBatch, observations: Space, actions: Space) -> None:
        """Keep the batch, and the spaces of one environment."""
        self._batch = batch
        self.single_observation_space, self.single_action_space = observations, actions
        self.observation_space = batch_space(observations, self.num_envs)
        self.action_space = batch_space(actions, self.num_envs)
        self._begun = False
        self._ended: Flags = np.zeros(self.num_envs, dtype=np.bool_)

    def reset(
        self, *, seed: int | Sequence[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Floats32, dict[str, Any]]:
        """Begin an episode in every environment, or in those of ``options["reset_mask"]``.

        Args:
            seed: seed of the first environment; the others have the next seeds. Or one for each environment, as in the
                single environment: with a seed, it begins the episodes of this seed; with None, its next episode.
            options: ``reset_mask``: (num_envs,) bool, the environments that begin an episode.

        Returns:
            Observations (num_envs, m) of all environments, and infos.

        Raises:
            InputError: an argument is not allowed.
            NoStartError: an episode cannot begin; then reset all environments.
        """
        no_options(options, ("reset_mask",))
        chosen = self._mask((options or {}).get("reset_mask"))
        self._batch.seed([key if mask else None for key, mask in zip(self._keys(seed), chosen.tolist(), strict=True)])
        self._begun = False  # if there is no start, all have to be reset
        observations = self._batch.begin(chosen)
        self._begun = True
        self._ended[chosen] = False
        return observations, {"is_success": np.zeros(self.num_envs, dtype=np.bool_), "_is_success": chosen.copy()}

    def step(self, actions: Floats32) -> tuple[Floats32, Array, Flags, Flags, dict[str, Any]]:  # type: ignore[override]
        """Make one step of every environment.

        Args:
            actions: (num_envs, controls) sticks and switches in [-1, 1].

        Returns:
            Observations (num_envs, m), rewards (num_envs,), terminations, truncations, infos.

        Raises:
            InputError: the environments have not been reset, a control is outside [-1, 1], or with DISABLED an episode
                has ended. No environment has then moved.
            NoStartError: an episode cannot begin; then reset all environments.
        """
        if not self._begun:
            raise InputError("step: got a call before the first reset, expected reset() first")
        if self._mode == DISABLED and self._ended.any():
            ended = short(np.flatnonzero(self._ended).tolist())
            raise InputError(
                f"step: the episodes of environments {ended} have ended; reset them first, with "
                "options={'reset_mask': mask}"
            )
        try:
            done = self._batch.step(clipped(actions) if self._clips else actions, self._mode)
        except NoStartError:
            self._begun = False
            raise
        everywhere = np.ones(self.num_envs, dtype=np.bool_)
        infos: dict[str, Any] = {"is_success": done.reached, "_is_success": everywhere}
        if done.ended:
            over = done.terminated | done.truncated
            if self._mode == SAME_STEP:
                self._add_final(infos, done, over)
            elif self._mode == DISABLED:
                self._ended = over
        return done.observations, done.rewards, done.terminated, done.truncated, infos

    def _add_final(self, infos: dict[str, Any], done: Step, over: Flags) -> None:
        """Add the last observations and infos of episodes that have ended; the other infos belong to the next ones."""
        final = np.full(self.num_envs, None, dtype=object)
        for i in np.flatnonzero(over):
            final[i] = done.final[i].copy()
        infos["final_obs"], infos["_final_obs"] = final, over
        infos["final_info"] = {"is_success": done.reached & over, "_is_success": over.copy()}
        infos["_final_info"] = over.copy()
        infos["is_success"] = done.reached & ~over

    def _keys(self, seed: int | Sequence[int | None] | None) -> list[int | None]:
        """Return the key of each environment's random numbers; None for those that keep theirs."""
        if seed is None and self._begun:
            return [None] * self.num_envs
        if seed is None or isinstance(seed, int):
            super().reset(seed=seed)
            first = self.np_random_seed if seed is None else seed
            assert first is not None, "Gymnasium draws a seed if there is none"
            return [first + i for i in range(self.num_envs)]
        if not isinstance(cast("object", seed), Sequence):
            raise InputError(f"seed: got {short(seed)}, expected a whole number or one for each environment")
        if len(seed) != self.num_envs:
            raise InputError(f"seed: got {len(seed)} seeds, expected one for each of {self.num_envs} environments")
        given = [None if key is None else whole(f"seed of environment {i}", key, 0) for i, key in enumerate(seed)]
        if self._begun:
            return list(given)
        return [np_random()[1] if key is None else key for key in given]

    def _mask(self, mask: object) -> Flags:
        """Return the environments that begin an episode; all if there is no mask."""
        if mask is None:
            return np.ones(self.num_envs, dtype=np.bool_)
        if not (isinstance(mask, np.ndarray) and mask.dtype == np.bool_ and mask.shape == (self.num_envs,)):
            raise InputError(f"reset_mask: got {short(mask)}, expected a NumPy array of {self.num_envs} bools")
        if not mask.any():
            raise InputError("reset_mask: got no True, expected at least one environment to reset")
        if not self._begun and not mask.all():
            raise InputError("reset_mask: got a part of the environments before the first reset of all")
        return mask.copy()  # one that can be written, for which the laws are compiled


def _mode(given: AutoresetMode | str) -> AutoresetMode:
    """Return the autoreset mode of a name such as ``NextStep``, or the mode itself."""
    if isinstance(given, AutoresetMode):
        return given
    return AutoresetMode(one_of("autoreset_mode", given, [mode.value for mode in AutoresetMode]))
