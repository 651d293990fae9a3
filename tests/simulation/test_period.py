"""The compiled part of a step against the same step in Python, with random sticks and switches."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest

from aftdeck.plant.state import FOLLOWING
from aftdeck.scenario.load import built_in, load_scenario
from aftdeck.simulation import fly
from aftdeck.simulation.command_check import rehearsal
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.period.contact import seen
from aftdeck.simulation.period.drive import driven
from aftdeck.simulation.period.limit import limited
from aftdeck.simulation.period.period import DRIVEN, OBSERVED, SEEN, UNCHANGED
from aftdeck.simulation.period.quick import give, quick_step, take
from aftdeck.simulation.row.scalars import BEGAN, MADE
from aftdeck.simulation.run import Simulation
from aftdeck.simulation.state import State
from aftdeck.steering.mode import MODES
from tests.simulation.flights import random_inputs

STEPS = 700
"""Number of steps of each run."""
LEAVES_SWITCHES = 0.9
"""Share of the steps in which only sticks move, where a test chooses them."""


def in_python(
    flight: Flight, state: State, inputs: Inputs, *, observes: bool, most: int = 1, goes_on: bool = False
) -> int:
    """Replace `quick_step`: steer in Python, move by laws, and leave the rest of the step to Python."""
    del observes, most
    assert not goes_on
    fly._steer(state)
    began = state.panel.motion_began
    give(flight, state, inputs)
    flat = state.row.flat(flight.packed)
    limited(flat, state.rules)
    state.row.scalars[BEGAN], state.row.scalars[MADE] = 0.0, 1.0
    reached = DRIVEN
    if driven(flat):
        seen(flat, FOLLOWING)
        reached = SEEN
    take(flight, state, reached)
    assert state.panel.motion_began == began
    return reached


def digests(name: str, seed: int | None, steps: int) -> list[bytes]:
    """Return the digest of each step: of random sticks, or of the script, if any, with sticks at rest."""
    sim = Simulation(name)
    given = None if seed is None else random_inputs(np.random.default_rng(seed), steps)
    found: list[bytes] = []
    while len(found) < steps and not sim.ended:
        sim.advance(None if given is None else next(given))
        found.append(sim.seal())
    return found


@pytest.mark.parametrize("name", built_in())
@pytest.mark.parametrize("seed", [None, 1, 2])
def test_compiled_steps_change_the_state_as_steps_in_python_do(
    name: str, seed: int | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    compiled = digests(name, seed, STEPS)
    monkeypatch.setattr(fly, "quick_step", in_python)
    monkeypatch.setattr(rehearsal, "_COMMANDED", STEPS * 1000)
    assert digests(name, seed, STEPS) == compiled


@pytest.mark.parametrize("name", ["srms-berth", "concept-1972-script", "sequence", "first-flight"])
def test_most_steps_are_compiled_as_a_whole(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    reached: Counter[int] = Counter()
    own = quick_step

    def counted(
        flight: Flight, state: State, inputs: Inputs, *, observes: bool, most: int = 1, goes_on: bool = False
    ) -> int:
        found = own(flight, state, inputs, observes=observes, most=most, goes_on=goes_on)
        reached[found] += observes
        return found

    monkeypatch.setattr(fly, "quick_step", counted)
    digests(name, None if load_scenario(name).phases else 1, 2000)
    assert reached[OBSERVED] + reached[UNCHANGED] > 0.5 * reached.total(), reached


@pytest.mark.parametrize("name", built_in())
@pytest.mark.parametrize("seed", [1, 2])
def test_steps_with_sticks_alone_are_as_steps_that_do_everything(name: str, seed: int) -> None:
    random = np.random.default_rng(seed)
    quick, whole = Simulation(name), Simulation(name)
    alone, went_on, turn = random_inputs(random, STEPS), 0, Inputs()
    for switched in alone:
        if random.random() < LEAVES_SWITCHES:
            turn = Inputs(translation=switched.translation, rotation=switched.rotation, drive=switched.drive)
        else:
            turn = switched
        quick.advance(turn)
        whole._state.row.goes_on = False
        whole.advance(turn)
        went_on += quick._state.row.goes_on
        assert quick.seal() == whole.seal() and quick.look() == whole.look()
    begins = quick.scenario
    assert went_on > 0 or begins.plant != "kinematic" or MODES[begins.mode].kind == "automatic"


@pytest.mark.parametrize("name", built_in())
@pytest.mark.parametrize("seed", [1, 2])
def test_held_inputs_are_as_many_steps(name: str, seed: int) -> None:
    random = np.random.default_rng(seed)
    one, many = Simulation(name), Simulation(name)
    for inputs in random_inputs(random, STEPS // 4):
        steps = int(random.integers(1, 9))
        for _ in range(steps):
            one.advance(inputs)
        many.hold(inputs, steps)
        assert one.seal() == many.seal() and one.look() == many.look()
