"""Ray cluster of several nodes on this machine: what a cluster of several machines has, without the network."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path

from aftdeck.study.ray_access import MODE, token_at_hand
from aftdeck.study.ray_connection import NEW_CLUSTER

START_S = 120.0
"""Longest time until all nodes have joined the cluster [s]."""
END_S = 60.0
"""Longest time until a node has ended its processes [s]."""
POLL_S = 0.2
JOINED = "Ray runtime started"
"""Text that `ray start` prints once its node has joined the cluster."""


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
        variables: variables of the nodes; without RAY_AUTH_MODE, the cluster asks for a token if one is at hand.

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
    with ExitStack() as started:
        for number in range(count):
            options = head if number == 0 else [f"--address={address}"]
            started.enter_context(node(options, os.environ | own, folder / f"node-{number}.log"))
        yield address


@contextmanager
def node(options: Sequence[str], environment: Mapping[str, str], log: Path) -> Iterator[None]:
    """Start a node with one core and wait until it has joined its cluster; end it and its processes afterwards.

    Args:
        options: options of ``ray start``.
        environment: all variables of the node.
        log: file for what the node prints.

    Raises:
        TimeoutError: the node has not joined in time, or has ended.
    """
    command = [sys.executable, "-m", "ray.scripts.scripts", "start", *options]
    fixed = ["--node-ip-address=127.0.0.1", "--num-cpus=1", "--disable-usage-stats", "--block"]
    with log.open("wb") as file, subprocess.Popen([*command, *fixed], env=environment, stdout=file, stderr=file) as run:
        try:
            end = time.monotonic() + START_S
            while JOINED not in (text := log.read_text(encoding="utf-8", errors="replace")):
                if run.poll() is not None or time.monotonic() > end:
                    raise TimeoutError(f"the node with {options} has not joined: {text}")
                time.sleep(POLL_S)
            yield
        finally:
            run.terminate()  # a node that gets this signal ends its processes
            with suppress(subprocess.TimeoutExpired):
                run.wait(END_S)
            run.kill()
