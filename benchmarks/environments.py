"""Benchmark of the learning environments: an environment step, beside Gymnasium's own vector environment of CartPole.

A step includes the check of the actions, observation, reward, end of episodes, reset, and new arrays for the results.
"""

from __future__ import annotations

import time
from typing import Any, NamedTuple

import gymnasium
import numpy as np

import aftdeck.gym  # noqa: F401  (registers the environments)
from benchmarks.measure import Figure, against

COUNT = 1024
"""Number of environments in a batch."""
SHARE = 2.2
"""Promised time of an environment step of Reach, as a share of that of CartPole."""
ACTIONS = 16
"""Number of different random actions of a batch, used in turn."""


class Size(NamedTuple):
    """Steps in a round, and number of rounds; the shortest round counts."""

    steps: int
    rounds: int


FULL, TINY = Size(50, 60), Size(2, 2)


def reach(size: Size) -> list[Figure]:
    """Measure the time of an environment step of Reach, compiled, and of CartPole by NumPy, both on one core."""
    rng = np.random.default_rng(0)
    ours = gymnasium.make_vec("aftdeck/Reach-v0", num_envs=COUNT)
    sticks = [rng.uniform(-1.0, 1.0, (COUNT, 6)).astype(np.float32) for _ in range(ACTIONS)]
    peer = gymnasium.make_vec("CartPole-v1", num_envs=COUNT, vectorization_mode="vector_entry_point")
    pushes = [rng.integers(0, 2, COUNT) for _ in range(ACTIONS)]
    alone = gymnasium.make("aftdeck/Reach-v0").unwrapped
    alone.reset(seed=0)
    each = _seconds(alone, [actions[0] for actions in sticks], size)
    peer_ns, ours_ns = (1e9 / COUNT * _seconds(env, actions, size) for env, actions in ((peer, pushes), (ours, sticks)))
    cart_pole = Figure("CartPole by NumPy, the same", peer_ns, "ns", None, _note(peer_ns))
    return [
        against(cart_pole, SHARE, "Reach, an environment step", ours_ns, "ns", _note(ours_ns)),
        cart_pole,
        Figure("Reach, single environment", each * 1e6, "us", None, f"{1e-3 / each:.0f} thousand steps/s"),
    ]


def _note(nanoseconds: float) -> str:
    return f"{1e3 / nanoseconds:.1f} million environment steps/s on one core, {COUNT} environments"


def _seconds(env: Any, actions: list[Any], size: Size) -> float:
    """Return the shortest time of a step [s], each a mean of a round of steps."""
    env.reset(seed=0)
    times: list[float] = []
    for _ in range(size.rounds):
        begin = time.perf_counter()
        for k in range(size.steps):
            env.step(actions[k % ACTIONS])
        times.append((time.perf_counter() - begin) / size.steps)
    return min(times)
