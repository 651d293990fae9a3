"""Clone the rule of `capture_by_rule.py` from 50 flights of Capture; write policy file and curve.

    pip install "aftdeck[gym]" torch matplotlib
    python examples/learn/clone_capture.py --out capture.npz --curve capture.svg

The sticks that are flown are those of the rule with noise; the recorded actions are those of the rule. The network
therefore also learns to correct deviations, which it will have.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from pathlib import Path

import gymnasium
import numpy as np
import torch
from capture_by_rule import action
from curve import draw
from exported import exported
from numpy.typing import NDArray

import aftdeck.gym  # noqa: F401  (registers the environments)
from aftdeck.gym.policy_file import save_policy

CAPTURE = "aftdeck/Capture-v0"
FLIGHTS, EPISODES = 50, 50
"""Recorded flights, and episodes for the evaluation."""
EVALUATED_FROM = 1_000_000
"""First seed of the evaluation; the recorded flights have the seeds from 0 on."""
NOISE = 0.3
"""Standard deviation of the noise on the sticks of the recorded flights."""
LEAST_STD = 1e-2
"""Least scale of an observation: some are almost constant in the recorded flights."""
PASSES, BATCH = 120, 256

Floats = NDArray[np.float32]


def flown(env: gymnasium.Env[Floats, Floats], seed: int, act: Callable[[Floats], Floats]) -> tuple[bool, float]:
    """Fly one episode; return whether it succeeds, and its duration [s]."""
    observation, _ = env.reset(seed=seed)
    steps, over = 0, False
    while not over:
        observation, _, terminated, truncated, info = env.step(act(observation))
        steps, over = steps + 1, terminated or truncated
    return bool(info["is_success"]), 0.1 * steps


def recorded(env: gymnasium.Env[Floats, Floats]) -> tuple[Floats, Floats, int]:
    """Fly with the rule; return all observations (n, 30), its actions (n, 8), and the number of successes."""
    random = np.random.Generator(np.random.PCG64(0))
    seen: list[Floats] = []
    acts: list[Floats] = []

    def act(observation: Floats) -> Floats:
        seen.append(observation)
        acts.append(action(observation))
        noisy = acts[-1].copy()
        noisy[:6] += NOISE * random.standard_normal(6).astype(np.float32)
        return np.clip(noisy, -1.0, 1.0)

    successes = sum(flown(env, seed, act)[0] for seed in range(FLIGHTS))
    return np.stack(seen), np.stack(acts), successes


def main() -> None:
    """Record, train, evaluate and write the files."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--out", type=Path, default=Path("capture.npz"), help="policy file to write")
    parser.add_argument("--curve", type=Path, help="SVG file to write")
    parser.add_argument("--threads", type=int, default=1, help="threads of torch")
    chosen = parser.parse_args()
    torch.manual_seed(0)
    torch.set_num_threads(chosen.threads)
    env, started = gymnasium.make(CAPTURE), time.perf_counter()
    observations, actions, successes = recorded(env)
    print(f"{time.perf_counter() - started:6.1f} s  {successes} of {FLIGHTS} flights succeed, {len(actions)} steps")
    mean, std = observations.mean(axis=0), np.maximum(observations.std(axis=0), LEAST_STD)
    inputs, wanted = torch.from_numpy((observations - mean) / std), torch.from_numpy(actions)
    network = torch.nn.Sequential(
        torch.nn.Linear(30, 128), torch.nn.ReLU(), torch.nn.Linear(128, 128), torch.nn.ReLU(), torch.nn.Linear(128, 8)
    )
    optimiser = torch.optim.Adam(network.parameters(), lr=1e-3)
    schedule = torch.optim.lr_scheduler.CosineAnnealingLR(optimiser, PASSES)
    points: list[tuple[float, float]] = []
    for number in range(1, PASSES + 1):
        total = 0.0
        for chunk in torch.randperm(len(inputs)).split(BATCH):
            loss = torch.nn.functional.mse_loss(network(inputs[chunk]), wanted[chunk])
            optimiser.zero_grad()
            loss.backward()  # type: ignore[no-untyped-call]
            optimiser.step()
            total += loss.item() * len(chunk)
        schedule.step()
        points.append((number, (total / len(inputs)) ** 0.5))
    print(f"{time.perf_counter() - started:6.1f} s  error of a control {points[-1][1]:.3f} (root mean square)")
    policy = exported(CAPTURE, network, "relu", mean, std)
    save_policy(policy, chosen.out)
    results = [flown(env, EVALUATED_FROM + k, policy.act) for k in range(EPISODES)]
    durations = [duration for success, duration in results if success]
    print(
        f"{time.perf_counter() - started:6.1f} s  {chosen.out}: {len(durations)} of {EPISODES} new episodes succeed, "
        f"{np.mean(durations):.1f} s on average"
    )
    if chosen.curve is not None:
        draw(chosen.curve, points, "passes over the 50 flights", "error of a control (RMS)")


if __name__ == "__main__":
    main()
