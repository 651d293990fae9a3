"""Digests of flights, for comparison between processors, compilers and versions of Python.

``python -m tests.exact_flights`` prints the name of each flight, its number of steps, and one SHA-256 over the exact
states and frames of all its steps. The output is the same on every machine. The flights are all built-in scenarios
with a script, and runs with random sticks, all on the kinematic plant: the others are exact on one processor only.
"""

from __future__ import annotations

import hashlib
import importlib
import sys
from collections.abc import Iterator
from typing import Any

import msgspec
import numpy as np

from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from tests.same_flights import flights, operator


def generic() -> dict[str, str]:
    """Return an environment in which Numba, OpenBLAS, NumPy and the C library compute as on a processor without AVX."""
    umath: Any = importlib.import_module("numpy._core._multiarray_umath")
    without = ",".join(f"-{name}" for name in ("AVX", "AVX2", "FMA", "AVX512F", "AVX2_Usable", "FMA_Usable"))
    return {
        "NUMBA_CPU_NAME": "generic",
        "NUMBA_CPU_FEATURES": "",
        "OPENBLAS_CORETYPE": "Prescott",
        "NPY_DISABLE_CPU_FEATURES": " ".join(umath.__cpu_dispatch__),
        "GLIBC_TUNABLES": f"glibc.cpu.hwcaps={without}",
    }


def digest(scenario: str, seed: int, most: int) -> tuple[int, str]:
    """Fly a scenario, by its script or with random sticks; return the number of steps and the digest.

    Args:
        scenario: name of the scenario.
        seed: seed of the sticks; -1 for the script.
        most: greatest number of steps.
    """
    sim = Simulation(load_scenario(scenario, {("plant",): "kinematic"}))
    given, found, count = operator(seed), hashlib.sha256(), 0
    for inputs in _inputs(sim, given):
        sim.advance(inputs)
        found.update(sim.seal())
        found.update(msgspec.json.encode(sim.look(), enc_hook=_plain))
        count += 1
        if count == most:
            break
    return count, found.hexdigest()


def _plain(value: np.generic) -> object:
    """Return a number of NumPy as a number of Python; laws as plain Python leave some in the frame."""
    return value.item()


def _inputs(sim: Simulation, given: object) -> Iterator[Inputs | None]:
    while not sim.ended:
        inputs = given(sim) if callable(given) else None
        if callable(given) and inputs is None:
            return
        yield inputs


def main(most: int = sys.maxsize) -> None:
    """Print the digest of each flight, of at most `most` steps each."""
    for name, scenario, seed in flights():
        count, found = digest(scenario, seed, most)
        print(name, count, found, flush=True)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
