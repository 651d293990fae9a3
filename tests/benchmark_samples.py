"""Benchmarks for the tests of the command that runs them."""

from __future__ import annotations

import os
import time
from pathlib import Path
from typing import NoReturn

from benchmarks.measure import Figure

FULL, TINY = 2.0, 1.0
RESULTS = "AFTDECK_TEST_RESULTS"
"""Environment variable with the path of the file of results."""


def works(size: float) -> list[Figure]:
    """Return a figure that misses its target in a full run."""
    return [Figure("length", size, "m", 1.5)]


def counts(size: float) -> list[Figure]:
    """Return the number of lines that the file of results has by now."""
    return [Figure("lines", len(Path(os.environ[RESULTS]).read_bytes().splitlines()), "")]


def fails(size: float) -> NoReturn:
    """Raise an error with a message of two lines."""
    raise LookupError("nothing\nfound")


def crashes(size: float) -> NoReturn:
    """End the process without a word of Python."""
    os._exit(3)


def hangs(size: float) -> NoReturn:
    """Wait for ever."""
    while True:
        time.sleep(60.0)


def repeats(size: float) -> list[Figure]:
    """Return two figures of the same name."""
    return [*works(size), *works(size)]
