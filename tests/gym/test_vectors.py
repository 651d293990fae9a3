"""Vector environments of all tasks: Gymnasium's autoreset modes, seeds by row, clipped actions, shared arrays."""

from __future__ import annotations

from importlib.util import find_spec
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.vector import AutoresetMode

import aftdeck.gym  # noqa: F401  (registers the environments)
from aftdeck.errors import InputError
from aftdeck.gym.reach.vector import ReachVectorEnv
from aftdeck.gym.terms import Floats32

MISSIONS = ("Capture", "Extract", "Dock")
ALL = ("Reach", *MISSIONS)
STEPS = 2
"""Length of an episode."""


def single(name: str, **keywords: Any) -> gymnasium.Env[Any, Any]:
    return gymnasium.make(f"aftdeck/{name}-v0", disable_env_checker=True, **keywords)


def sync(
    name: str, mode: AutoresetMode | str, count: int = 2, **keywords: Any
) -> gymnasium.vector.VectorEnv[Any, Any, Any]:
    return gymnasium.make_vec(
        f"aftdeck/{name}-v0",
        num_envs=count,
        vectorization_mode="sync",
        vector_kwargs={"autoreset_mode": mode},
        **keywords,
    )


def episodes(name: str, seed: int, action: Floats32) -> tuple[list[Floats32], Floats32]:
    """Return the observations of an episode of `STEPS` steps, and the first one of the next episode."""
    env = single(name)
    seen = [env.reset(seed=seed)[0], *(env.step(action)[0] for _ in range(STEPS))]
    return seen, env.reset()[0]


@pytest.mark.parametrize("mode", AutoresetMode)
@pytest.mark.parametrize("name", MISSIONS)
def test_episode_that_ends_is_reset_in_each_mode(name: str, mode: AutoresetMode) -> None:
    env = sync(name, mode, max_episode_steps=STEPS)
    action = np.full(env.single_action_space.shape or (), 0.2, dtype=np.float32)
    expected = [episodes(name, seed, action) for seed in (3, 4)]
    ends, nexts = np.array([seen[-1] for seen, _ in expected]), np.array([first for _, first in expected])
    actions = np.tile(action, (2, 1))
    env.reset(seed=3)
    env.step(actions)
    observations, _, terminated, truncated, infos = env.step(actions)
    assert not terminated.any() and truncated.all()
    match mode:
        case AutoresetMode.NEXT_STEP:
            assert np.array_equal(observations, ends)
            observations, rewards, _, truncated, _ = env.step(actions)
            assert rewards.tolist() == [0.0, 0.0] and not truncated.any()
        case AutoresetMode.SAME_STEP:
            assert np.array_equal(np.stack(list(infos["final_obs"])), ends)
            assert infos["final_info"]["is_success"].tolist() == [False, False]
        case AutoresetMode.DISABLED:
            assert np.array_equal(observations, ends)
            observations, _ = env.reset(options={"reset_mask": truncated})
    assert np.array_equal(observations, nexts)


def test_autoreset_mode_may_be_a_name() -> None:
    assert sync("Dock", "SameStep").metadata["autoreset_mode"] is AutoresetMode.SAME_STEP


@pytest.mark.parametrize("name", ALL)
def test_row_with_a_seed_equals_the_single_environment_with_this_seed(name: str) -> None:
    seeds = [7, 3, 7, None, 2**40 + 1]
    env: Any = gymnasium.make_vec(f"aftdeck/{name}-v0", num_envs=len(seeds))
    observations, _ = env.reset(seed=seeds)
    actions = np.random.default_rng(0).uniform(-1.0, 1.0, env.action_space.shape or ()).astype(np.float32)
    after, rewards, *_ = env.step(actions)
    for row, seed in enumerate(seeds):
        if seed is not None:
            one = single(name)
            assert np.array_equal(one.reset(seed=seed)[0], observations[row])
            seen, reward, *_ = one.step(actions[row])
            assert np.array_equal(seen, after[row]) and reward == rewards[row]


def test_row_without_a_seed_is_random_at_first_and_then_goes_on_with_its_episodes() -> None:
    one, other = ReachVectorEnv(num_envs=2), ReachVectorEnv(num_envs=2)
    first, second = one.reset(seed=[5, None])[0], other.reset(seed=[5, None])[0]
    assert np.array_equal(first[0], second[0])
    assert not np.array_equal(first[1], second[1])
    same = single("Reach")
    same.reset(seed=5)
    assert np.array_equal(one.reset(seed=[None, 8])[0][0], same.reset()[0])


@pytest.mark.parametrize(
    ("seeds", "message"),
    [
        ([1], "seed: got 1 seeds, expected one for each of 2 environments"),
        ([1, -1], "seed of environment 1: got -1, expected a whole number, 0 or more"),
        ([1.5, 2], "seed of environment 0: got 1.5, expected a whole number"),
    ],
)
def test_unusable_seeds_are_rejected(seeds: Any, message: str) -> None:
    with pytest.raises(InputError, match=message):
        ReachVectorEnv(num_envs=2).reset(seed=seeds)


@pytest.mark.parametrize(("name", "plant"), [*((name, "kinematic") for name in ALL), ("Reach", "rigid")])
def test_clipped_action_equals_one_at_the_end_of_its_travel(name: str, plant: str) -> None:
    clips, exact = single(name, plant=plant, clip_actions=True), single(name, plant=plant)
    clips.reset(seed=1), exact.reset(seed=1)
    action = np.linspace(-1.5, 2.5, (exact.action_space.shape or (0,))[0], dtype=np.float32)
    given = action.copy()
    seen, reward, *_ = clips.step(action)
    expected, rewarded, *_ = exact.step(np.clip(action, -1.0, 1.0))
    assert np.array_equal(seen, expected) and reward == rewarded
    assert np.array_equal(action, given)
    for wrong in (np.nan, np.inf, -np.inf):
        action[1] = wrong
        with pytest.raises(InputError, match=rf"THC Y is {wrong:g}, expected a number in \[-1, 1\]$"):
            clips.step(action)
    with pytest.raises(InputError, match=r"THC X is -1\.5, expected .*; with clip_actions=True"):
        exact.step(given)


def test_batch_clips_actions() -> None:
    clips, exact = ReachVectorEnv(num_envs=9, clip_actions=True), ReachVectorEnv(num_envs=9)
    clips.reset(seed=1), exact.reset(seed=1)
    actions = np.random.default_rng(0).uniform(-3.0, 3.0, (9, 6)).astype(np.float32)
    assert np.array_equal(clips.step(actions)[0], exact.step(np.clip(actions, -1.0, 1.0))[0])
    actions[4, 2] = np.inf
    with pytest.raises(InputError, match="THC Z is inf in environment 4"):
        clips.step(actions)


def results(name: str, count: int) -> list[np.ndarray[Any, Any]]:
    """Return the arrays that an environment, or a batch, returns in a reset and two steps."""
    env: Any = gymnasium.make_vec(f"aftdeck/{name}-v0", num_envs=count) if count else single(name)
    found = [env.reset(seed=0)[0]]
    action = np.zeros(env.action_space.shape, dtype=np.float32)
    for _ in range(2):
        observations, rewards, terminated, truncated, infos = env.step(action)
        found += [observations] + ([rewards, terminated, truncated, infos["is_success"]] if count else [])
    return found


@pytest.mark.parametrize("count", [0, 2])
@pytest.mark.parametrize("name", ALL)
def test_arrays_can_be_taken_without_a_copy_and_are_new(name: str, count: int) -> None:
    found = results(name, count)
    for array in found:
        assert array.flags.c_contiguous and array.flags.writeable
        taken = np.from_dlpack(array)
        assert np.shares_memory(taken, array)
        before = [other.copy() for other in found if other is not array]
        taken[...] = 1
        assert array.all()
        assert all(np.array_equal(a, b) for a, b in zip(before, (o for o in found if o is not array), strict=True))
    assert {array.dtype for array in found} <= {np.dtype(kind) for kind in (np.float32, np.float64, np.bool_)}
    if name == "Reach" or not count:  # observations of Gymnasium's own batches are NumPy's
        assert all(array.ctypes.data % 64 == 0 for array in found if array.dtype == np.float32)
    if find_spec("torch") is not None:
        torch: Any = __import__("torch")
        assert all(torch.from_numpy(array).data_ptr() == array.ctypes.data for array in found)


def test_action_that_cannot_be_written_runs_the_laws_that_are_there() -> None:
    """NumPy sees an array of JAX as one that cannot be written; a law for such arrays would have to be compiled."""
    from aftdeck.gym.reach import kernel  # noqa: PLC0415  (its laws are counted)

    env = ReachVectorEnv(num_envs=2, autoreset_mode="Disabled")
    env.reset(seed=0)
    actions, mask = np.zeros((2, 6), dtype=np.float32), np.array([True, False])
    env.step(actions)
    env.reset(options={"reset_mask": mask})
    laws: Any = (kernel.step_all, kernel.begin_all)
    compiled = [len(law.signatures) for law in laws]
    actions.flags.writeable = mask.flags.writeable = False
    env.step(actions)
    env.reset(options={"reset_mask": mask})
    assert [len(law.signatures) for law in laws] == compiled
