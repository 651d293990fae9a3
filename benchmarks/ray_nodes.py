"""Ray cluster of several nodes on this machine: what a cluster of several machines has, without the network."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path

from aftdeck.study.ray_access import MODE, token_at_hand
from aftdeck.study.ray_connection import NEW_CLUSTER

START_S = 120.0
"""Longest time until all nodes have joined the cluster [s]."""
END_S = 30.0
"""Longest time until a node has ended its processes [s]."""


@contextmanager
def nodes(
    count: int, port: int, folder: Path, client_port: int | None = None, variables: Mapping[str, str] | None = None
) -> Iterator[str]:
    """Start a cluster of nodes with one core each, and end it.

    Args:
        count: number of nodes; the first one is the head.
        port: port of the head.
        folder: folder for the logs and sockets of Ray; its path must be short, because it becomes part of a socket's.
        client_port: port for ``ray://`` addresses; None: none is served.
        variables: variables of the nodes; without RAY_AUTH_MODE in them, the cluster asks for a token if one is at hand.

    Yields:
        The address of the cluster, for ``--ray``.

    Raises:
        TimeoutError: the nodes have not joined in time.
    """
    address = f"127.0.0.1:{port}"
    own = NEW_CLUSTER | dict(variables or {})
    if not {MODE} & {*own, *os.environ} and token_at_hand():
        own[MODE] = "token"  # `ray start --head` does so itself, the other nodes do not
    head = ["--head", f"--port={port}", f"--temp-dir={folder}", "--include-dashboard=false"]
    if client_port is not None:
        head.append(f"--ray-client-server-port={client_port}")
    started = [_start(own, *head)]
    try:
        _wait(address, own, 1, started)
        for number in range(1, count):
            started.append(_start(own, f"--address={address}"))
            _wait(address, own, number + 1, started)
        yield address
    finally:
        for node in reversed(started):  # a node that gets this signal ends its processes
            node.terminate()
        for node in started:
            _end(node)


def _start(own: Mapping[str, str], *options: str) -> subprocess.Popen[bytes]:
    command = [sys.executable, "-m", "ray.scripts.scripts", "start", *options]
    fixed = ["--node-ip-address=127.0.0.1", "--num-cpus=1", "--disable-usage-stats", "--block"]
    return subprocess.Popen(
        [*command, *fixed], env=os.environ | own, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )


def _end(node: subprocess.Popen[bytes]) -> None:
    """Wait until a node has ended; kill it if it does not."""
    try:
        node.wait(END_S)
    except subprocess.TimeoutExpired:
        node.kill()
        node.wait()


def _wait(address: str, own: Mapping[str, str], count: int, started: list[subprocess.Popen[bytes]]) -> None:
    """Wait until a number of nodes has joined."""
    ask = f"import ray; ray.init(address={address!r}, log_to_driver=False); print('nodes', len(ray.nodes()))"
    end, said = time.monotonic() + START_S, ""
    while time.monotonic() < end:
        if any(node.poll() is not None for node in started):
            raise TimeoutError(f"a node of the cluster at {address} has ended")
        with suppress(subprocess.TimeoutExpired):
            asked = [sys.executable, "-c", ask]
            said = subprocess.run(
                asked, env=os.environ | own, capture_output=True, text=True, check=False, timeout=START_S
            ).stdout
        if f"nodes {count}" in said:
            return
        time.sleep(1.0)
    raise TimeoutError(f"the cluster at {address} has not {count} nodes after {START_S:g} s: {said}")
