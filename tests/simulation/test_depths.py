"""Penetration depths under random inputs stay within the two-frame rule, by an outside witness.

`python -m tests.simulation.test_depths 1000000` makes a million steps of every built-in scenario; the normal tests make
`STEPS` of each.
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
from tests.simulation.flights import anything
from tests.simulation.sat import Witness

STEPS = 20_000
SEGMENT = 500
"""Steps flown by hand from a place on the script's way."""
STARTS = 12
"""Places on the script's way from which segments begin."""
SLIGHTLY = 5e-5
"""What a step that leads out of several contacts may deepen one of them by [m], and more than rounding makes."""


def starts(sim: aftdeck.Simulation) -> list[SavedSimulation]:
    """States on the way of a scenario's script, its first instant among them; of one without a script that alone."""
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


def pushes(rng: np.random.Generator, steps: int) -> Iterator[Inputs]:
    """Sticks that are held for up to a second and a half, with every switch put now and then."""
    pace = float(rng.choice([0.2, 1.0]))
    yield from anything(rng, steps, pace, switches=0.1, every=int(rng.integers(8, 80)))


def deepest(name: str, steps: int, seed: int = 1) -> Witness:
    """The witness of so many random steps of a built-in scenario."""
    sim = aftdeck.Simulation(name)
    rng = np.random.default_rng(seed)
    begin = starts(sim)
    witness = Witness(sim)
    for _ in range(steps // SEGMENT):
        sim.restore(begin[rng.integers(len(begin))])
        witness.begin()
        for inputs in pushes(rng, SEGMENT):
            sim.advance(inputs)
            witness.look()
    return witness


@pytest.mark.slow
@pytest.mark.parametrize("name", built_in())
def test_penetration_stays_within_two_steps_travel(name: str) -> None:
    witness = deepest(name, STEPS)
    over = {pair: depth for pair, depth in witness.worst.items() if depth > SLIGHTLY}
    assert not over


def main(steps: int, names: tuple[str, ...]) -> None:
    """Print the deepest pair and the one farthest over its limit, of each scenario."""
    for name in names:
        witness = deepest(name, steps)
        over = sorted(((depth, pair) for pair, depth in witness.worst.items()), reverse=True)[:4]
        told = "; ".join(f"{a} – {b} {1e3 * most:.4g} mm" for most, (a, b) in over)
        print(f"{name}: {len(witness.worst)} pairs met; farthest over: {told}", flush=True)


if __name__ == "__main__":
    main(int(sys.argv[1]), tuple(sys.argv[2:]) or tuple(built_in()))
