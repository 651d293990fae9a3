"""Flights on another processor, and as plain Python, are equal to the last bit."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from tests.exact_flights import generic

STEPS = 25
"""Number of steps as plain Python, which is a few hundred times slower than compiled code."""


def digests(environment: dict[str, str], *given: str) -> dict[str, str]:
    """Return the line of each flight from a new process, by the flight's name."""
    done = subprocess.run(
        [sys.executable, "-m", "tests.exact_flights", *given],
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=False,
        timeout=1500,
    )
    assert done.returncode == 0, done.stderr
    return dict(line.split(" ", 1) for line in done.stdout.splitlines())


def sums(environment: dict[str, str]) -> str:
    """Return sines and matrix products of NumPy and Python, computed in a new process."""
    code = (
        "import math, numpy as np; r = np.random.default_rng(0).normal(size=(1000, 3, 3));"
        "print(sum(map(hash, np.sin(r).ravel().tolist())), sum(map(hash, (r @ r[::-1]).ravel().tolist())),"
        "sum(hash(math.sin(x)) for x in r.ravel().tolist()))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], env={**os.environ, **environment}, capture_output=True, text=True, check=True
    )
    return done.stdout


@pytest.mark.slow
@pytest.mark.long
def test_every_flight_is_equal_to_the_last_bit_on_a_generic_processor() -> None:
    if sums({}) == sums(generic()):
        pytest.skip("this processor computes like the generic one, so that nothing would be compared")
    here, elsewhere = digests({}), digests(generic())
    assert here == elsewhere
    assert len(here) > 30


@pytest.mark.slow
def test_every_flight_is_equal_to_the_last_bit_as_plain_python() -> None:
    assert digests({}, str(STEPS)) == digests({"NUMBA_DISABLE_JIT": "1"}, str(STEPS))
