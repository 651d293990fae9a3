"""A run that begins again in the same simulation."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import aftdeck
from aftdeck.errors import ScenarioError
from aftdeck.scenario.load import built_in
from aftdeck.scenario.model import Grasped, Start
from tests.simulation.flights import random_inputs

AHEAD = aftdeck.Inputs(translation=(0.4, 0.0, 0.1), effector="close")


def seals(sim: aftdeck.Simulation, steps: int = 30) -> list[bytes]:
    """Return the digests of the next steps."""
    found = []
    for _ in range(steps):
        sim.advance(AHEAD)
        found.append(sim.seal())
    return found


@pytest.mark.parametrize("plant", ["kinematic", "rigid"])
def test_restarted_run_equals_a_new_one_bit_for_bit(plant: str) -> None:
    scenario = aftdeck.load_scenario("tutorial", {("plant",): plant})
    sim = aftdeck.Simulation(scenario)
    first = seals(sim)
    sim.restart()
    assert sim.frame is None
    assert sim.given is None
    assert seals(sim) == first == seals(aftdeck.Simulation(scenario))


def flown(sim: aftdeck.Simulation, seed: int, steps: int) -> list[bytes]:
    """Return the digests of steps with random inputs."""
    found = []
    for inputs in random_inputs(np.random.default_rng(seed), steps, every=6):
        sim.advance(inputs)
        found.append(sim.seal())
    return found


@pytest.mark.parametrize("name", built_in())
def test_run_that_restarts_in_place_equals_one_in_new_memory(name: str) -> None:
    """What the clearance monitor remembers of the run before changes nothing."""
    sim, other = aftdeck.Simulation(name, digests=False), aftdeck.Simulation(name, digests=False)
    rng = np.random.default_rng(len(name))
    for seed in range(3):
        flown(sim, seed, 40 * seed)
        start = replace(sim.scenario.start, angles=sim.scenario.start.angles + rng.uniform(-0.05, 0.05))
        sim.restart(start, in_place=True)
        other.restart(start)
        assert sim.save() == other.save()
        assert flown(sim, seed + 10, 40) == flown(other, seed + 10, 40)
        assert sim.look() == other.look()
        assert sim.watched() == other.watched()


def test_restart_from_other_initial_conditions_begins_there() -> None:
    sim = aftdeck.Simulation("tutorial")
    own = sim.scenario.start
    angles = own.angles + 0.05
    sim.restart(replace(own, angles=angles))
    frame = sim.step(aftdeck.Inputs())
    assert frame.tick == 1
    assert frame.angles == pytest.approx(angles, abs=1e-12)
    sim.restart()
    assert sim.step(aftdeck.Inputs()).angles == pytest.approx(own.angles, abs=1e-12)


def test_start_that_holds_a_payload_out_of_reach_is_rejected_and_changes_nothing() -> None:
    sim = aftdeck.Simulation("concept-1972")
    sim.advance(AHEAD)
    before = sim.seal()
    start = sim.scenario.start
    impossible = Start(start.angles, np.zeros(6), start.stand, Grasped(0, start.angles, start.stand))
    with pytest.raises(ScenarioError, match=r"initial\.grasped: .* cannot have been captured in this pose"):
        sim.restart(impossible)
    assert sim.seal() == before
