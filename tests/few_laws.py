"""Two small laws, for tests of the compilation, and calls of them."""

from __future__ import annotations

import os

from aftdeck.law import law

PID = "AFTDECK_TEST_PID"
"""Variable with the number of the process that wants the laws."""


@law
def third(value: float) -> float:
    """Return a third."""
    return value / 3.0


@law
def ninth(value: float) -> float:
    """Return a ninth."""
    return third(third(value))


def call() -> None:
    """Call both laws."""
    ninth(1.0)
    third(1.0)


def call_one() -> None:
    """Call one law."""
    third(1.0)


def call_and_fail() -> None:
    """Raise an error in the process that compiles."""
    if os.environ.get(PID) != str(os.getpid()):
        raise ValueError("no such arm")
    call()


def call_and_end() -> None:
    """End the process that compiles."""
    if os.environ.get(PID) != str(os.getpid()):
        os._exit(1)
    call()
