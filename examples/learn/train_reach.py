"""Train a policy of Reach with PPO until it succeeds in 95 % of the episodes; write policy file and curve.

pip install "aftdeck[gym]" torch stable-baselines3 matplotlib
python examples/learn/train_reach.py --out reach.npz --curve reach.svg
"""

from __future__ import annotations

import argparse
import time
from pathlib import Path

import gymnasium
import numpy as np
import torch
from batch_for_sb3 import BatchForSb3
from curve import draw
from exported import exported
from numpy.typing import NDArray
from stable_baselines3 import PPO

import aftdeck.gym  # noqa: F401  (registers the environments)
from aftdeck.gym.policy import Policy
from aftdeck.gym.policy_file import save_policy
from aftdeck.gym.reach.definition import ID as REACH

ENVIRONMENTS, STEPS = 256, 64
"""Environments of the batch, and steps of each between two updates of the policy."""
UPDATES = 5
"""Updates between two evaluations."""
NEAR = 0.2
"""Scale of the distance and of the rotation to go. The environment scales them for the whole workspace; near the
goal, its numbers are small for a fresh network."""
REWARD_SCALE = 0.2
"""Factor of the rewards, so that the value of a state is about 1."""
EVALUATED_FROM = 1_000_000
"""First seed of the episodes for evaluation; training has other seeds."""
WANTED = 0.95


def success_rate(policy: Policy, episodes: int, seed: int) -> tuple[float, float]:
    """Return the share of episodes that succeed, and the mean duration of these [s]."""
    reach = gymnasium.make_vec(REACH, num_envs=episodes, autoreset_mode="SameStep")
    observations, _ = reach.reset(seed=seed)
    over, succeeded, steps = (np.zeros(episodes, dtype) for dtype in (bool, bool, int))
    while not over.all():
        observations, _, terminated, truncated, _ = reach.step(policy.act(observations))
        steps += ~over
        succeeded |= terminated & ~over
        over |= terminated | truncated
    return float(succeeded.mean()), 0.08 * float(steps[succeeded].mean()) if succeeded.any() else 0.0


def environments(seed: int, std: NDArray[np.float32]) -> BatchForSb3:
    """Return the environments, whose first one has this seed; `std` (24,) divides the observations."""
    batch = gymnasium.make_vec(REACH, num_envs=ENVIRONMENTS, autoreset_mode="SameStep")
    return BatchForSb3(batch, seed, std, REWARD_SCALE)


def main() -> None:
    """Train, evaluate and write the files."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=Path("reach.npz"), help="policy file to write")
    parser.add_argument("--curve", type=Path, help="SVG file to write")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--threads", type=int, default=1, help="threads of torch")
    parser.add_argument("--most-steps", type=int, default=10_000_000, help="steps after which the training gives up")
    chosen = parser.parse_args()
    torch.set_num_threads(chosen.threads)
    mean, std = np.zeros(24, dtype=np.float32), np.ones(24, dtype=np.float32)
    std[:6] = NEAR
    started = time.perf_counter()
    reach = environments(chosen.seed, std)
    reach.reset()
    reach.step(np.zeros((ENVIRONMENTS, 6), dtype=np.float32))
    print(f"{time.perf_counter() - started:6.1f} s  the environment is compiled")
    model = PPO(
        "MlpPolicy",
        environments(chosen.seed, std),
        n_steps=STEPS,
        batch_size=2048,
        n_epochs=5,
        learning_rate=1e-3,
        gamma=0.99,
        policy_kwargs={"net_arch": [64, 64], "activation_fn": torch.nn.ReLU, "log_std_init": -0.5},
        seed=chosen.seed,
        device="cpu",
    )
    points: list[tuple[float, float]] = []
    while not points or points[-1][1] < WANTED:
        if model.num_timesteps >= chosen.most_steps:
            raise SystemExit(f"no success in {WANTED:.0%} of the episodes after {model.num_timesteps} steps")
        model.learn(UPDATES * STEPS * ENVIRONMENTS, reset_num_timesteps=False)
        modules = [*model.policy.mlp_extractor.policy_net, model.policy.action_net]
        policy = exported(REACH, modules, "relu", mean, std)
        rate, duration = success_rate(policy, 200, EVALUATED_FROM)
        points.append((model.num_timesteps / 1e6, rate))
        print(
            f"{time.perf_counter() - started:6.1f} s  {points[-1][0]:.2f} M steps  {rate:4.0%}  {duration:.1f} s",
            flush=True,
        )
    save_policy(policy, chosen.out)
    rate, duration = success_rate(policy, 2000, 2 * EVALUATED_FROM)
    print(f"{chosen.out}: {rate:.1%} of 2,000 new episodes, {duration:.1f} s on average")
    if chosen.curve is not None:
        draw(chosen.curve, points, "steps of all environments [million]", "successful episodes", WANTED)


if __name__ == "__main__":
    main()
