"""Reach: the compiled vector environment, its autoreset modes, and its equality with the single environment."""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.vector import AutoresetMode, SyncVectorEnv

import aftdeck.gym  # noqa: F401  (registers the environments)
from aftdeck.errors import InputError
from aftdeck.gym.reach.vector import ReachVectorEnv
from aftdeck.gym.terms import Floats32

MODES = list(AutoresetMode)


def single(steps: int) -> gymnasium.Env[Any, Any]:
    return gymnasium.make("aftdeck/Reach-v0", max_episode_steps=steps, disable_env_checker=True)


def towards(observations: Floats32) -> Floats32:
    """Return sticks in proportion to the remaining motion."""
    return np.clip(observations[:, :6] * np.array([2, 2, 2, 4, 4, 4], dtype=np.float32), -1.0, 1.0)


@pytest.mark.parametrize("steps", [60, 500])
def test_batch_of_one_equals_the_single_environment_bit_for_bit(steps: int) -> None:
    env, batch = single(steps), gymnasium.make_vec("aftdeck/Reach-v0", num_envs=1, max_episode_steps=steps)
    rng = np.random.default_rng(3)
    seen, rows = env.reset(seed=8)[0], batch.reset(seed=8)[0]
    ends = 0
    for _ in range(1500):
        assert (rows[0] == seen).all()
        sticks = towards(rows) if steps == 500 else rng.uniform(-1.0, 1.0, (1, 6)).astype(np.float32)
        seen, reward, terminated, truncated, info = env.step(sticks[0])
        rows, rewards, ends_1, ends_2, infos = batch.step(sticks)
        assert (reward, terminated, truncated) == (rewards[0], ends_1[0], ends_2[0])
        assert info["is_success"] == infos["is_success"][0]
        if terminated or truncated:
            ends += 1
            assert (rows[0] == seen).all()
            seen = env.reset()[0]
            rows, rewards, *_ = batch.step(sticks)
            assert rewards[0] == 0.0
    assert ends > 3


@pytest.mark.parametrize("mode", MODES)
def test_batch_equals_gymnasiums_vector_of_single_environments(mode: AutoresetMode) -> None:
    count, steps = 45, 40  # more than a block
    ours = gymnasium.make_vec("aftdeck/Reach-v0", num_envs=count, max_episode_steps=steps, autoreset_mode=mode)
    theirs = SyncVectorEnv([lambda: single(steps)] * count, autoreset_mode=mode)
    assert ours.metadata["autoreset_mode"] is mode
    assert ours.single_observation_space == theirs.single_observation_space
    assert ours.action_space == theirs.action_space
    rng = np.random.default_rng(1)
    compare(ours.reset(seed=5), theirs.reset(seed=5))
    over = np.zeros(count, dtype=np.bool_)
    for step in range(100):
        if step == 17:  # so that the environments end at different times
            mask = rng.random(count) < 0.5
            if mode is AutoresetMode.DISABLED:
                compare(ours.reset(options={"reset_mask": mask}), theirs.reset(options={"reset_mask": mask}))
        sticks = rng.uniform(-1.0, 1.0, (count, 6)).astype(np.float32)
        got, expected = ours.step(sticks), theirs.step(sticks)
        compare(got, expected)
        over = got[2] | got[3]
        if mode is AutoresetMode.DISABLED and over.any():
            compare(ours.reset(options={"reset_mask": over}), theirs.reset(options={"reset_mask": over}))
    ours.close()
    theirs.close()


def compare(got: Any, expected: Any) -> None:
    """Assert that two results have the same values: arrays, infos, or tuples of them."""
    if isinstance(expected, dict):
        assert got.keys() == expected.keys()
        for key, value in expected.items():
            compare(got[key], value)
    elif isinstance(expected, tuple):
        assert len(got) == len(expected)
        for one, other in zip(got, expected, strict=True):
            compare(one, other)
    elif isinstance(expected, np.ndarray) and expected.dtype == object:
        for one, other in zip(got, expected, strict=True):
            assert (one is None) == (other is None)
            if other is not None:
                compare(one, other)
    else:
        assert got.dtype == expected.dtype
        assert (got == expected).all()


def test_results_of_a_step_share_no_memory_with_later_ones() -> None:
    env = ReachVectorEnv(num_envs=3, max_episode_steps=2, autoreset_mode="SameStep")
    kept: list[Any] = [env.reset(seed=0)[0]]
    copies = [kept[0].copy()]
    for _ in range(5):
        observations, rewards, *_, infos = env.step(np.full((3, 6), 0.5, dtype=np.float32))
        kept += [observations, rewards, *(one for one in infos.get("final_obs", ()) if one is not None)]
        copies += [array.copy() for array in kept[len(copies) :]]
    assert all((array == copy).all() for array, copy in zip(kept, copies, strict=True))


def test_environment_of_a_batch_does_not_depend_on_the_others() -> None:
    many, few = ReachVectorEnv(num_envs=50), ReachVectorEnv(num_envs=3)
    sticks = np.random.default_rng(0).uniform(-1.0, 1.0, (50, 6)).astype(np.float32)
    assert (many.reset(seed=40)[0][7:10] == few.reset(seed=47)[0]).all()
    for _ in range(50):
        assert (many.step(sticks)[0][7:10] == few.step(sticks[7:10])[0]).all()


def test_ended_environment_has_to_be_reset_if_autoreset_is_disabled() -> None:
    env = ReachVectorEnv(num_envs=2, max_episode_steps=1, autoreset_mode=AutoresetMode.DISABLED)
    env.reset(seed=0)
    sticks = np.zeros((2, 6), dtype=np.float32)
    env.step(sticks)
    with pytest.raises(InputError, match=r"environments \[0, 1\] have ended; reset them first"):
        env.step(sticks)
    env.reset(options={"reset_mask": np.array([True, False])})
    with pytest.raises(InputError, match=r"environments \[1\] have ended"):
        env.step(sticks)


@pytest.mark.parametrize(
    ("keywords", "message"),
    [
        ({"num_envs": 0}, "num_envs: got 0, expected a whole number, 1 or more"),
        ({"autoreset_mode": "Later"}, "autoreset_mode: got 'Later', expected 'NextStep', 'SameStep', 'Disabled'"),
        ({"plant": "rigid"}, "plant: got 'rigid', expected 'kinematic' for the compiled batch"),
        ({"plant": "x"}, "plant: got 'x', expected 'kinematic', 'rigid', 'flexible'"),
    ],
)
def test_unknown_keyword_values_are_rejected(keywords: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message):
        ReachVectorEnv(**keywords)


@pytest.mark.parametrize(
    ("mask", "message"),
    [
        ([True, False], "expected a NumPy array of 2 bools"),
        (np.zeros(2, dtype=np.bool_), "expected at least one environment"),
        (np.ones(3, dtype=np.bool_), "expected a NumPy array of 2 bools"),
    ],
)
def test_unusable_masks_are_rejected(mask: object, message: str) -> None:
    env = ReachVectorEnv(num_envs=2)
    env.reset(seed=0)
    with pytest.raises(InputError, match=message):
        env.reset(options={"reset_mask": mask})


def test_stick_outside_its_travel_names_the_environment_and_moves_none() -> None:
    env, same = ReachVectorEnv(num_envs=4), ReachVectorEnv(num_envs=4)
    env.reset(seed=0), same.reset(seed=0)
    sticks = np.zeros((4, 6), dtype=np.float32)
    sticks[2, 4] = -1.01
    with pytest.raises(InputError, match=r"RHC pitch is -1\.01 in environment 2"):
        env.step(sticks)
    assert (env.step(0 * sticks)[0] == same.step(0 * sticks)[0]).all()


def test_random_policy_runs_for_many_steps_without_a_broken_episode() -> None:
    env = ReachVectorEnv(num_envs=400, max_episode_steps=100)
    observations, _ = env.reset(seed=0)
    rng, ends = np.random.default_rng(0), 0
    for _ in range(500):  # 200,000 steps
        sticks = rng.uniform(-1.0, 1.0, (400, 6)).astype(np.float32)
        observations, rewards, terminated, truncated, infos = env.step(sticks)
        assert env.observation_space.contains(observations)
        assert np.isfinite(rewards).all()
        assert (infos["is_success"] == terminated).all()
        ends += int((terminated | truncated).sum())
    assert ends >= 400 * 4  # an episode ends after 100 steps at the latest; the reset takes one step


def digest_of_some_steps() -> str:
    """Return a digest of the observations and rewards of a short run."""
    env, digest = ReachVectorEnv(num_envs=3, max_episode_steps=10), hashlib.sha256()
    digest.update(env.reset(seed=1)[0].tobytes())
    rng = np.random.default_rng(0)
    for _ in range(25):
        observations, rewards, *_ = env.step(rng.uniform(-1.0, 1.0, (3, 6)).astype(np.float32))
        digest.update(observations.tobytes() + rewards.tobytes())
    return digest.hexdigest()


def test_compiled_functions_as_plain_python_give_the_same_numbers_bit_for_bit() -> None:
    code = "from tests.gym.test_reach_vector import digest_of_some_steps as some; print(some())"
    plain = {**os.environ, "NUMBA_DISABLE_JIT": "1"}
    done = subprocess.run(
        [sys.executable, "-c", code], env=plain, capture_output=True, text=True, check=True, timeout=300
    )
    assert done.stdout.strip() == digest_of_some_steps()


def test_sticks_in_proportion_to_the_motion_left_reach_all_goals() -> None:
    env = ReachVectorEnv(num_envs=300, autoreset_mode="Disabled")
    observations, _ = env.reset(seed=7)
    reached, running = np.zeros(300, dtype=np.bool_), np.ones(300, dtype=np.bool_)
    while running.any():
        observations, _, terminated, truncated, _ = env.step(towards(observations))
        reached |= running & terminated
        running &= ~(terminated | truncated)
        if (ended := terminated | truncated).any():
            observations, _ = env.reset(options={"reset_mask": ended})
    assert reached.mean() > 0.99
