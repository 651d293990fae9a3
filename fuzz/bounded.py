"""One attack with one seed, in bounded time and memory."""

from __future__ import annotations

import resource
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from types import FrameType

from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.warm import warm_up
from fuzz.attacks import Attack

MOST_GROWTH = 500_000_000
"""Greatest growth of the greatest memory of this process in one attack [bytes]."""


class TooLongError(Exception):
    """An attack that takes longer than its limit."""


class TooMuchMemoryError(Exception):
    """An attack that takes more memory than `MOST_GROWTH`."""


def outcome(attack: Attack, seed: int) -> str:
    """Return the outcome of an attack with a seed. Call this in the main thread, which receives signals.

    Raises:
        TooLongError: the attack took more than its time.
        TooMuchMemoryError: the attack took more than `MOST_GROWTH`.
        Exception: the attack failed.
    """
    _compile_laws()
    before = _greatest_memory()
    with _limited(attack.slowest_s):
        found = attack.run(seed)
    if (growth := _greatest_memory() - before) > MOST_GROWTH:
        raise TooMuchMemoryError(f"{growth / 1e6:.0f} MB")
    return found


@cache
def _compile_laws() -> None:
    """Compile all laws, which may take more than `MOST_GROWTH`."""
    for name in ("first-flight", "concept-1972"):
        warm_up(load_scenario(name))


@contextmanager
def _limited(seconds: float) -> Iterator[None]:
    """Raise TooLongError in the block after some seconds."""

    def stop(signum: int, frame: FrameType | None) -> None:
        raise TooLongError(f"not finished after {seconds:g} s")

    previous = signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, previous)


def _greatest_memory() -> int:
    """Return the greatest memory that this process has had so far [bytes]."""
    greatest = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return greatest if sys.platform == "darwin" else greatest * 1024
