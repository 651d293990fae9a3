"""Benchmark of Capture, Extract and Dock, beside environments of arms in other libraries.

The peers are measured in an environment of their own, which `uv` makes: their packages are no part of Aftdeck's, and
Gymnasium's own arms need a package for windows.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import time
from pathlib import Path
from typing import NamedTuple

import gymnasium
import msgspec

import aftdeck.gym  # noqa: F401  (registers the environments)
from benchmarks import peer_environments
from benchmarks.measure import Figure, absent
from benchmarks.peer_environments import Peer, seconds_a_step

PACKAGES = {"gymnasium": "gymnasium[mujoco]==1.4.0", "brax": "brax==0.14.2"}
"""Packages of the peers, by the argument of `peer_environments`."""
LONGEST_S = 600.0
"""Longest time in which the peers' packages are installed, compiled and measured [s]."""
NAMES = ("Capture", "Extract", "Dock")


class Size(NamedTuple):
    """Steps in a round, rounds (the shortest counts), environments of a batch, and whether the peers are measured."""

    steps: int
    rounds: int
    batch: int
    peers: bool


FULL, TINY = Size(400, 12, 64, True), Size(5, 2, 3, False)


def missions(size: Size) -> list[Figure]:
    """Measure an environment step with random sticks, episodes included, and steps of arms in other libraries."""
    found = []
    for name in NAMES:
        env = gymnasium.make(f"aftdeck/{name}-v0")
        env.action_space.seed(0)
        seconds = seconds_a_step(env, size.steps, size.rounds)
        found.append(Figure(f"{name}, an environment step", 1e6 * seconds, "us", None, _note(seconds)))
        seconds = _seconds_in_a_batch(name, size)
        note = f"{1.0 / seconds:,.0f} steps/s on one core: {size.batch} environments, the same, episodes included"
        found.append(Figure(f"{name} in a batch, an environment step", 1e6 * seconds, "us", None, note))
    return found + [figure for argument in PACKAGES for figure in _peers(argument, size)]


def _note(seconds: float) -> str:
    return f"{1.0 / seconds:,.0f} steps/s on one core: five control periods, observation, reward"


def _seconds_in_a_batch(name: str, size: Size) -> float:
    """Return the shortest time of a step of one of the environments in a batch, with random sticks [s]."""
    batch = gymnasium.make_vec(f"aftdeck/{name}-v0", num_envs=size.batch)
    batch.action_space.seed(0)
    batch.reset(seed=0)
    rounds = []
    for _ in range(size.rounds):
        actions = [batch.action_space.sample() for _ in range(size.steps // 8 + 1)]
        before = time.perf_counter()
        for action in actions:
            batch.step(action)
        rounds.append((time.perf_counter() - before) / (len(actions) * size.batch))
    return min(rounds)


def _peers(argument: str, size: Size) -> list[Figure]:
    """Return the figures of a library's environments."""
    name, package = f"arms of {argument}", PACKAGES[argument]
    uv = shutil.which("uv", path=str(Path(sys.executable).parent)) or shutil.which("uv")
    if not size.peers or uv is None:
        return [absent(name, "us", f"a full run needs uv, which installs {package}")]
    script = [peer_environments.__file__, argument, str(size.steps), str(size.rounds)]
    command = [uv, "run", "--quiet", "--isolated", "--no-project", "--with", package, "python", *script]
    try:
        done = subprocess.run(command, capture_output=True, timeout=LONGEST_S, check=True)
    except (subprocess.SubprocessError, OSError) as error:
        return [absent(name, "us", f"{package}: {type(error).__name__}")]
    *_, last = done.stdout.splitlines()  # the libraries print lines before it
    peers = msgspec.json.decode(last, type=list[Peer])
    return [Figure(peer.name, 1e6 * peer.seconds, "us", None, peer.note) for peer in peers]
