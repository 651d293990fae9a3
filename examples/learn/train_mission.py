"""Train a policy of Capture, Extract or Dock with PPO; write policy file and curve.

    pip install "aftdeck[gym]" torch stable-baselines3 matplotlib
    python examples/learn/train_mission.py Dock --out dock.npz --curve dock.svg

The reward is that of the environment, and every episode starts as in the environment: there is no curriculum.
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
from aftdeck.gym.mission.definition import PERIOD
from aftdeck.gym.policy import Policy
from aftdeck.gym.policy_file import save_policy

ENVIRONMENTS, STEPS = 16, 128
"""Environments that make their steps together, and steps of each between two updates of the policy."""
UPDATES = 5
"""Updates between two points of the curve."""
LAST = 100
"""Episodes of a point: the last ones that were flown for training. Those that were not flown yet count as failed."""
NEAR = 0.1
"""Scale of the distance and of the rotation to go. The environment observes metres and radians; an episode ends within
centimetres and a few degrees, which are small numbers for a fresh network."""
EVALUATED_FROM = 1_000_000
"""First seed of the episodes for evaluation; training has other seeds."""
WANTED = 0.95
"""Share of successful episodes at which a line in the curve is drawn."""

Floats = NDArray[np.float32]


def scale(size: int) -> Floats:
    """Return what divides an observation of this size."""
    divisor = np.ones(size, np.float32)
    divisor[:6] = NEAR
    return divisor


def environments(name: str, plant: str, seed: int) -> BatchForSb3:
    """Return environments with scaled observations; the first one has this seed. Without masses, they are a batch."""
    if plant == "kinematic":
        batch = gymnasium.make_vec(name, num_envs=ENVIRONMENTS, autoreset_mode="SameStep")
    else:
        each = {"vectorization_mode": "sync", "vector_kwargs": {"autoreset_mode": "SameStep"}, "plant": plant}
        batch = gymnasium.make_vec(name, num_envs=ENVIRONMENTS, **each)
    (size,) = batch.single_observation_space.shape
    return BatchForSb3(batch, seed, scale(size))


def success_rate(env: gymnasium.Env[Floats, Floats], policy: Policy, episodes: int, seed: int) -> tuple[float, float]:
    """Return the share of episodes that succeed, and the mean duration of these [s]."""
    durations = []
    for episode in range(seed, seed + episodes):
        observation, info = env.reset(seed=episode)
        steps, over = 0, False
        while not over:
            observation, _, terminated, truncated, info = env.step(policy.act(observation))
            steps, over = steps + 1, terminated or truncated
        if info["is_success"]:
            durations.append(PERIOD * steps)
    return len(durations) / episodes, float(np.mean(durations)) if durations else 0.0


def main() -> None:
    """Train, evaluate and write the files."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("task", choices=("Capture", "Extract", "Dock"))
    parser.add_argument("--plant", choices=("kinematic", "rigid", "flexible"), default="kinematic")
    parser.add_argument("--out", type=Path, default=Path("policy.npz"), help="policy file to write")
    parser.add_argument("--curve", type=Path, help="SVG file to write")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--steps", type=int, default=200_000, help="steps of all environments")
    chosen = parser.parse_args()
    torch.set_num_threads(1)
    name, keywords = f"aftdeck/{chosen.task}-v0", {"plant": chosen.plant}
    started = time.perf_counter()
    env = gymnasium.make(name, **keywords)
    env.reset(seed=0)
    env.step(np.zeros_like(env.action_space.sample()))
    print(f"{time.perf_counter() - started:6.1f} s  the environment is compiled")
    model = PPO(
        "MlpPolicy",
        environments(name, chosen.plant, chosen.seed),
        n_steps=STEPS,
        batch_size=512,
        n_epochs=5,
        learning_rate=1e-3,
        gamma=0.99,
        policy_kwargs={"net_arch": [64, 64], "activation_fn": torch.nn.ReLU, "log_std_init": -1.0},
        seed=chosen.seed,
        stats_window_size=LAST,
        device="cpu",
    )
    size = model.observation_space.shape[0]
    points: list[tuple[float, float]] = []
    while model.num_timesteps < chosen.steps:
        model.learn(UPDATES * STEPS * ENVIRONMENTS, reset_num_timesteps=False)
        points.append((model.num_timesteps / 1000, sum(model.ep_success_buffer) / LAST))
        print(
            f"{time.perf_counter() - started:6.1f} s  {points[-1][0]:.0f} thousand steps  {points[-1][1]:4.0%}",
            flush=True,
        )
    modules = [*model.policy.mlp_extractor.policy_net, model.policy.action_net]
    policy = exported(name, modules, "relu", np.zeros(size, np.float32), scale(size))
    save_policy(policy, chosen.out)
    rate, duration = success_rate(env, policy, 1000, EVALUATED_FROM)
    print(f"{chosen.out}: {rate:.1%} of 1,000 new episodes, {duration:.1f} s on average")
    if chosen.curve is not None:
        draw(chosen.curve, points, "steps of all environments [thousand]", "successful episodes", WANTED)


if __name__ == "__main__":
    main()
