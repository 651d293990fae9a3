"""Connection of this process to a Ray cluster, for the time of a study."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from aftdeck.errors import InputError
from aftdeck.extra import needed
from aftdeck.study.ray_access import MODE, mode_for

LOCAL, AUTO = "local", "auto"
"""Addresses of a new cluster on this machine, which ends with the study, and of the cluster this machine belongs to."""
NEW_CLUSTER = {
    "RAY_USAGE_STATS_ENABLED": "0",
    "RAY_ACCEL_ENV_VAR_OVERRIDE_ON_ZERO": "0",
}
"""Variables for a new cluster: it reports its use to nobody, and leaves the choice of accelerators unchanged."""
STARTS = 2
"""Number of attempts to start a new cluster: a node of Ray 2.60 gives up if its agent, a Python program, does not run
after 15 s, which no setting changes. On a busy machine the second attempt finds the files in memory."""


@contextmanager
def connected(address: str, workers: int | None) -> Iterator[Any]:
    """Connect to a cluster, and disconnect at the end.

    Args:
        address: ``auto`` for the cluster to which this machine belongs, ``local`` for a new one on this machine, or the
            address of a cluster.
        workers: number of workers, which sizes a new cluster; None: one for each core.

    Yields:
        The module ``ray``.

    Raises:
        InputError: Ray is not installed, the cluster does not answer, or it does not accept the token.
    """
    ray: Any = needed("ray", "ray")
    before = _variables()
    for name, value in NEW_CLUSTER.items():
        os.environ.setdefault(name, value)
    try:
        if address != LOCAL:
            address = _found(ray) if address == AUTO else address
            if mode := mode_for(address):
                os.environ[MODE] = mode
        _reload_settings(ray)
        _connect(ray, address, workers)
        yield ray
    finally:
        ray.shutdown()
        for name in _variables():
            del os.environ[name]
        os.environ.update(before)
        _reload_settings(ray)


_PASSING = "Initialization failure from server"
"""Error of an address `ray://`: the head could not start the process that serves this client."""


def _variables() -> dict[str, str]:
    """Return Ray's variables."""
    return {name: value for name, value in os.environ.items() if name.startswith("RAY_")}


def _found(ray: Any) -> str:
    """Return the address of the cluster to which this machine belongs, as Ray itself finds it.

    Raises:
        InputError: there is none.
    """
    if named := os.environ.get("RAY_ADDRESS", ""):
        return named
    try:
        return str(ray._private.services.canonicalize_bootstrap_address_or_die(AUTO))
    except ConnectionError:
        raise InputError(
            f"--ray {AUTO}: no Ray cluster runs on this machine; start one with `ray start --head`, or give the "
            "address of another one"
        ) from None


def _connect(ray: Any, address: str, workers: int | None) -> None:
    options: dict[str, Any] = {"log_to_driver": False, "logging_level": "ERROR"}
    if address == LOCAL:
        options |= {"num_cpus": workers, "include_dashboard": False}
    for attempt in range(STARTS, 0, -1):
        try:
            ray.init(address=address, **options)
            return
        except Exception as error:  # Ray raises even the base class
            ray.shutdown()
            if attempt == 1 or not (address == LOCAL or _PASSING in str(error)):
                raise InputError(f"--ray {address}: {_cause(str(error))}") from None


def _cause(text: str) -> str:
    """Return the first line of an error, and the last one if the first announces it."""
    first, *others = text.splitlines() or [""]
    return f"{first} {others[-1].strip()}" if others and first.endswith(":") else first


def _reload_settings(ray: Any) -> None:
    """Let Ray read its variables again, which it does otherwise only once in a process."""
    ray._raylet.Config.initialize("")
