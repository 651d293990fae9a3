"""Penetration depths under random inputs stay within the two-frame rule; an independent program measures them.

`python -m tests.simulation.test_depths 1000000` runs a million steps of every built-in scenario. The tests run `STEPS`
steps of each scenario.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator

import numpy as np
import pytest

import aftdeck
from aftdeck import Inputs
from aftdeck.scenario.load import built_in
from aftdeck.simulation.run import SavedSimulation
from tests.each import number
from tests.scenario.missions import but_very_long
from tests.simulation.flights import random_inputs
from tests.simulation.sat import DepthMeter

STEPS = number(4_000, 40_000)
SEGMENT = 500
"""Number of random steps after each start."""
STARTS = 12
"""Number of states during the script that serve as starts."""
SLIGHTLY = 5e-5
"""Greatest depth that a step out of several contacts may add to one of them [m]; rounding errors are smaller."""


def starts(sim: aftdeck.Simulation) -> list[SavedSimulation]:
    """Return the first state of a run, and states during its script if there is one."""
    found = [sim.save()]
    if not sim.scenario.phases:
        return found
    ends = 0
    while not sim.ended:
        sim.advance()
        ends += 1
    sim.restore(found[0])
    wanted = set(np.linspace(1, ends - 1, STARTS).astype(int).tolist())
    for tick in range(1, ends):
        sim.advance()
        if tick in wanted:
            found.append(sim.save())
    return found


def random_pushes(rng: np.random.Generator, steps: int) -> Iterator[Inputs]:
    """Yield random inputs: sticks that are held for 0.16 to 1.6 s, and now and then a switch."""
    deflection = float(rng.choice([0.2, 1.0]))
    yield from random_inputs(rng, steps, deflection, switches=0.1, every=int(rng.integers(8, 80)))


def deepest(name: str, steps: int, seed: int = 1) -> DepthMeter:
    """Return the depths measured during `steps` random steps of a built-in scenario."""
    sim = aftdeck.Simulation(name)
    rng = np.random.default_rng(seed)
    begin = starts(sim)
    meter = DepthMeter(sim)
    for _ in range(steps // SEGMENT):
        sim.restore(begin[rng.integers(len(begin))])
        meter.begin()
        for inputs in random_pushes(rng, SEGMENT):
            sim.advance(inputs)
            meter.measure()
    return meter


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("name", but_very_long(built_in()))
def test_penetration_stays_within_two_steps_travel(name: str) -> None:
    meter = deepest(name, STEPS)
    over = {pair: depth for pair, depth in meter.worst.items() if depth > SLIGHTLY}
    assert not over


def main(steps: int, names: tuple[str, ...]) -> None:
    """Print, for each scenario, the four pairs whose depths exceed their limits most."""
    for name in names:
        meter = deepest(name, steps)
        over = sorted(((depth, pair) for pair, depth in meter.worst.items()), reverse=True)[:4]
        summary = "; ".join(f"{a} – {b} {1e3 * most:.4g} mm" for most, (a, b) in over)
        print(f"{name}: {len(meter.worst)} pairs penetrated; greatest excess: {summary}", flush=True)


if __name__ == "__main__":
    main(int(sys.argv[1]), tuple(sys.argv[2:]) or tuple(built_in()))
