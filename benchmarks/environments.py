"""Benchmark of the learning environments: an environment step, beside Gymnasium's own vector environment of CartPole.

A step includes the check of the actions, observation, reward, end of episodes, reset, and new arrays for the results.
"""

from __future__ import annotations

import time
from typing import Any

import gymnasium
import numpy as np

import aftdeck.gym  # noqa: F401  (registers the environments)
from benchmarks.measure import Figure

COUNT = 1024
"""Number of environments in a batch."""
PROMISED = 5e6
"""Promised number of environment steps per second on one core."""
STEPS, ROUNDS = 50, 60
"""Steps in a round, and number of rounds; the shortest round counts."""
ACTIONS = 16
"""Number of different random actions of a batch, used in turn."""


def reach() -> list[Figure]:
    """Measure the time of an environment step of Reach, compiled, and of CartPole by NumPy, both on one core."""
    rng = np.random.default_rng(0)
    ours = gymnasium.make_vec("aftdeck/Reach-v0", num_envs=COUNT)
    sticks = [rng.uniform(-1.0, 1.0, (COUNT, 6)).astype(np.float32) for _ in range(ACTIONS)]
    peer = gymnasium.make_vec("CartPole-v1", num_envs=COUNT, vectorization_mode="vector_entry_point")
    pushes = [rng.integers(0, 2, COUNT) for _ in range(ACTIONS)]
    alone = gymnasium.make("aftdeck/Reach-v0").unwrapped
    alone.reset(seed=0)
    each = _seconds(alone, [actions[0] for actions in sticks])
    return [
        _figure("Reach, an environment step", _seconds(ours, sticks) / COUNT, 1e9 / PROMISED),
        _figure("CartPole by NumPy, the same", _seconds(peer, pushes) / COUNT, None),
        Figure("Reach, single environment", each * 1e6, "us", None, f"{1e-3 / each:.0f} thousand steps/s"),
    ]


def _figure(name: str, each: float, target: float | None) -> Figure:
    note = f"{1e-6 / each:.1f} million environment steps/s on one core, {COUNT} environments"
    return Figure(name, each * 1e9, "ns", target, note)


def _seconds(env: Any, actions: list[Any]) -> float:
    """Return the shortest time of a step [s], each a mean of a round of steps."""
    env.reset(seed=0)
    times: list[float] = []
    for _ in range(ROUNDS):
        begin = time.perf_counter()
        for k in range(STEPS):
            env.step(actions[k % ACTIONS])
        times.append((time.perf_counter() - begin) / STEPS)
    return min(times)
