"""``python peer_environments.py LIBRARY STEPS ROUNDS``: time steps of other libraries' arms, and print them as JSON.

The program runs in an environment that has the library (`benchmarks/missions.py`), without Aftdeck. A step includes the
reward, the end of episodes and the reset, with random actions.
"""

from __future__ import annotations

import json
import os
import sys
import time
from importlib import import_module
from typing import Any, NamedTuple

BATCH = 256
"""Number of Brax's environments in a batch."""
GYMNASIUM = (
    ("Pusher-v5", "seven joints push a puck"),
    ("Reacher-v5", "two joints, a target"),
)
"""Arms of Gymnasium, and what they do."""


class Peer(NamedTuple):
    """Time of a step of one environment [s], with a note on what was measured."""

    name: str
    seconds: float
    note: str


def seconds_a_step(env: Any, steps: int, rounds: int) -> float:
    """Return the shortest mean time of a step [s]; an episode that ends is followed by the next."""
    env.reset(seed=0)
    actions, times = [env.action_space.sample() for _ in range(steps)], []
    for _ in range(rounds):
        begin = time.perf_counter()
        for action in actions:
            _, _, terminated, truncated, _ = env.step(action)
            if terminated or truncated:
                env.reset()
        times.append((time.perf_counter() - begin) / steps)
    return min(times)


def of_gymnasium(steps: int, rounds: int) -> list[Peer]:
    """Time arms of Gymnasium, which MuJoCo simulates: one at a time, on one core."""
    import gymnasium  # noqa: PLC0415  (a peer: only its own environment has all that it needs)

    found = []
    for name, task in GYMNASIUM:
        env = gymnasium.make(name)
        env.action_space.seed(0)
        inner: Any = env.unwrapped
        seconds = seconds_a_step(env, steps, rounds)
        note = f"{1.0 / seconds:,.0f} steps/s on one core: {task}; {inner.frame_skip} steps of MuJoCo of "
        found.append(Peer(f"Gymnasium's {name}, a step", seconds, f"{note}{1e3 * inner.model.opt.timestep:g} ms"))
    return found


def of_brax(steps: int, rounds: int) -> list[Peer]:
    """Time the pusher of Brax: a batch, on all cores."""
    os.environ["JAX_PLATFORMS"] = "cpu"
    jax: Any = import_module("jax")
    envs: Any = import_module("brax.envs")
    env = envs.training.wrap(envs.get_environment("pusher", backend="generalized"), episode_length=100)
    state = jax.jit(env.reset)(jax.random.split(jax.random.PRNGKey(0), BATCH))
    step, actions = jax.jit(env.step), jax.random.uniform(jax.random.PRNGKey(1), (16, BATCH, env.action_size)) * 2 - 1
    state = jax.block_until_ready(step(state, actions[0]))
    times = []
    for _ in range(rounds):
        begin, count = time.perf_counter(), max(1, steps // 20)
        for k in range(count):
            state = step(state, actions[k % len(actions)])
        jax.block_until_ready(state)
        times.append((time.perf_counter() - begin) / count / BATCH)
    seconds = min(times)
    note = (
        f"{1.0 / seconds:,.0f} steps/s on {os.cpu_count()} cores: the same arm, backend `generalized`, {BATCH} at once"
    )
    return [Peer("Brax's pusher, a step", seconds, note)]


if __name__ == "__main__":
    library, *counts = sys.argv[1:]
    print(json.dumps({"gymnasium": of_gymnasium, "brax": of_brax}[library](*map(int, counts))))
